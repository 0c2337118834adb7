#include "grader/averaged_truth.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace rays::grader {
namespace {

constexpr int kLargest = 4096;

RgbImage layer(const std::vector<float>& values, const OIIO::ImageSpec& spec, const std::string& prefix) {
    RgbImage image{{spec.width, spec.height}, {}};
    std::array<int, 3> channels{};
    for (std::size_t c = 0; c < 3; ++c) {
        channels[c] = spec.channelindex(prefix + "RGB"[c]);
        if (channels[c] < 0) throw InputError(fmt::format("has no channel {}{}", prefix, "RGB"[c]));
    }
    const auto pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    for (std::size_t i = 0; i < pixels; ++i) {
        Rgb pixel{};
        for (std::size_t c = 0; c < 3; ++c)
            pixel[c] = values[i * static_cast<std::size_t>(spec.nchannels) + static_cast<std::size_t>(channels[c])];
        if (!std::isfinite(pixel[0]) || !std::isfinite(pixel[1]) || !std::isfinite(pixel[2]))
            throw InputError("holds numbers that are not finite");
        image.pixels.push_back(pixel);
    }
    return image;
}

AveragedTruth read(const std::filesystem::path& file) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) throw InputError(OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > kLargest || spec.height > kLargest || spec.nchannels > 64)
        throw InputError(fmt::format("has {} x {} pixels of {} channels", spec.width, spec.height, spec.nchannels));
    std::vector<float> values(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                              static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, values.data())) throw InputError(input->geterror());
    return {layer(values, spec, ""), layer(values, spec, "error.")};
}

}  // namespace

AveragedTruth load_averaged_truth(const std::filesystem::path& file) {
    try {
        return read(file);
    } catch (const InputError& e) {
        throw InputError(fmt::format("{}: {}", file.string(), e.what()));
    }
}

}  // namespace rays::grader
