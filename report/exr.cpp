#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <stdexcept>

#include "pictures.h"

namespace rays::report {
namespace {

// A picture of a check has 160 x 120 pixels; a header that promises far more is a mistake or an attack.
constexpr std::int64_t kMaxPixels = 4'000'000;
constexpr int kMaxChannels = 64;

/// The channels prefix+R, +G, +B; empty when one is missing.
Picture channels(const std::vector<float>& values, const OIIO::ImageSpec& spec, const std::string& prefix) {
    Picture picture{spec.width, spec.height, {}};
    int index[3];
    for (int c = 0; c < 3; ++c) {
        index[c] = spec.channelindex(prefix + "RGB"[c]);
        if (index[c] < 0) return {};
    }
    picture.rgb.reserve(3 * picture.pixels());
    for (std::size_t i = 0; i < picture.pixels(); ++i)
        for (const int c : index)
            picture.rgb.push_back(values[i * static_cast<std::size_t>(spec.nchannels) + static_cast<std::size_t>(c)]);
    return picture;
}

/// All channels of a file that has a picture's size.
struct Channels {
    OIIO::ImageSpec spec;
    std::vector<float> values;
};

Channels read_channels(const std::filesystem::path& file) {
    if (!std::filesystem::is_regular_file(file)) throw std::runtime_error("there is no picture");
    if (std::filesystem::file_size(file) == 0) throw std::runtime_error("the picture's file is empty");
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) {
        OIIO::geterror();  // the message names paths of this machine
        throw std::runtime_error("the file is not a picture that can be read");
    }
    const OIIO::ImageSpec& spec = input->spec();
    const std::int64_t pixels = std::int64_t{spec.width} * spec.height;
    if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1 || pixels > kMaxPixels || spec.nchannels > kMaxChannels)
        throw std::runtime_error(fmt::format("the picture claims to have {} x {} pixels of {} channels", spec.width,
                                             spec.height, spec.nchannels));
    std::vector<float> values(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(spec.nchannels));
    if (!input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, values.data())) {
        input->geterror();
        throw std::runtime_error("the picture's pixels cannot be read: the file is damaged or cut off");
    }
    return {spec, std::move(values)};
}

}  // namespace

Exr read_picture(const std::filesystem::path& file) {
    const auto [spec, values] = read_channels(file);
    Exr exr{channels(values, spec, ""), channels(values, spec, "min."), channels(values, spec, "max.")};
    if (exr.frame.rgb.empty()) throw std::runtime_error("the picture lacks one of the channels R, G, B");
    return exr;
}

Picture read_cost_map(const std::filesystem::path& file) {
    const auto [spec, values] = read_channels(file);
    const int tests = spec.channelindex("tests"), nodes = spec.channelindex("nodes");
    if (tests < 0 || nodes < 0) throw std::runtime_error("the picture lacks one of the channels tests, nodes");
    Picture picture{spec.width, spec.height, {}};
    picture.rgb.reserve(3 * picture.pixels());
    for (std::size_t i = 0; i < picture.pixels(); ++i) {
        const float* pixel = &values[i * static_cast<std::size_t>(spec.nchannels)];
        picture.rgb.insert(picture.rgb.end(), {pixel[tests], pixel[nodes], 0.0f});
    }
    return picture;
}

}  // namespace rays::report
