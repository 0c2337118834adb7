// References and frames as OpenEXR files.
#include "references/exr_layers.h"
#include "references/reference.h"

namespace rays {

void save_reference(const Reference& reference, const std::filesystem::path& file) {
    save_layers(file, {{"", &reference.frame}, {"min.", &reference.min}, {"max.", &reference.max}}, Digits::half);
}

Reference load_reference(const std::filesystem::path& file) {
    Reference result;
    load_layers(file, {{"", &result.frame}, {"min.", &result.min}, {"max.", &result.max}});
    return result;
}

RgbImage load_rgb_exr(const std::filesystem::path& file) {
    RgbImage result;
    load_layers(file, {{"", &result}});
    return result;
}

}  // namespace rays
