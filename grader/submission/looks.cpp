#include "grader/submission/looks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "grader/compare.h"
#include "grader/picture.h"
#include "grader/submission/png.h"

namespace rays::grader {
namespace {

constexpr int kLeastAllowed = 3;
constexpr int kPngRounding = 1;

bool same_levels(const std::array<std::uint8_t, 3>& shown, const Rgb& rendered) {
    for (std::size_t c = 0; c < 3; ++c) {
        const int level = display_level(rendered[c]);
        if (level < 0 || std::abs(level - shown[c]) > kPngRounding) return false;
    }
    return true;
}

bool visibly_different(const Rgb& a, const Rgb& b) {
    for (std::size_t c = 0; c < 3; ++c) {
        const int la = display_level(a[c]), lb = display_level(b[c]);
        if (la < 0 || lb < 0 || std::abs(la - lb) >= kVisibleLevels) return true;
    }
    return false;
}

Likeness exr_likeness(const std::string& bytes, const RgbImage& rendered) {
    Likeness result;
    const DecodedPicture decoded = decode_exr(bytes, rendered.raster.width, rendered.raster.height);
    result.problem = decoded.problem;
    if (!result.problem.empty()) return result;
    for (std::size_t i = 0; i < rendered.pixels.size(); ++i)
        result.differing += !within(decoded.picture.pixels[i], rendered.pixels[i], kReferenceTolerance);
    return result;
}

Likeness png_likeness(const std::string& bytes, const RgbImage& rendered) {
    Likeness result;
    const PngPicture decoded = decode_png(bytes, rendered.raster);
    result.problem = decoded.problem;
    if (!result.problem.empty()) return result;
    for (std::size_t i = 0; i < rendered.pixels.size(); ++i)
        result.differing += !same_levels(decoded.pixels[i], rendered.pixels[i]);
    return result;
}

}  // namespace

int display_level(float linear) {
    if (std::isnan(linear)) return -1;
    const float v = std::clamp(linear, 0.0f, 1.0f);
    const float encoded = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
    return static_cast<int>(std::lround(255 * encoded));
}

double visible_share(const RgbImage& a, const RgbImage& b) {
    if (a.pixels.size() != b.pixels.size() || a.pixels.empty()) return 1;
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) different += visibly_different(a.pixels[i], b.pixels[i]);
    return double(different) / double(a.pixels.size());
}

bool Likeness::same() const {
    return problem.empty() && differing <= std::max(kLeastAllowed, static_cast<int>(pixels * kSilhouetteShare));
}

Likeness likeness(const std::string& file_name, const std::string& bytes, const RgbImage& rendered) {
    const bool exr = file_name.ends_with(".exr");
    Likeness result = exr ? exr_likeness(bytes, rendered) : png_likeness(bytes, rendered);
    result.pixels = static_cast<int>(rendered.pixels.size());
    return result;
}

}  // namespace rays::grader
