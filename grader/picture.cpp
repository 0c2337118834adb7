#include "grader/picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>

namespace rays::grader {

static constexpr const char* kDamaged = "is damaged: its pixels cannot be read";

DecodedPicture decode_exr(const std::string& bytes, int width, int height) {
    DecodedPicture result;
    result.problem = exr_header_problem(bytes, width, height);
    if (!result.problem.empty()) return result;
    try {
        OIIO::Filesystem::IOMemReader memory(static_cast<const void*>(bytes.data()), bytes.size());
        auto input = OIIO::ImageInput::open("student.exr", nullptr, &memory);
        RgbImage picture{{width, height},
                         std::vector<Rgb>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
        const bool good = input && input->spec().width == width && input->spec().height == height &&
                          input->spec().nchannels >= 3 &&
                          input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, picture.pixels.data());
        if (good)
            result.picture = std::move(picture);
        else
            result.problem = kDamaged;
        OIIO::geterror();  // forget what was said: the problem is known
    } catch (const std::exception&) {
        result.problem = kDamaged;
    }
    return result;
}

DecodedCosts decode_cost_map(const std::string& bytes, int width, int height) {
    DecodedCosts result;
    result.problem = exr_header_problem(bytes, width, height, {"tests", "nodes"});
    if (!result.problem.empty()) return result;
    result.problem = kDamaged;
    try {
        OIIO::Filesystem::IOMemReader memory(static_cast<const void*>(bytes.data()), bytes.size());
        const auto input = OIIO::ImageInput::open("costs.exr", nullptr, &memory);
        const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        const auto plane = [&](const char* name, std::vector<float>& values) {
            const int channel = input->spec().channelindex(name);
            values.resize(pixels);
            return channel >= 0 && input->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::FLOAT, values.data());
        };
        const bool good = input && input->spec().width == width && input->spec().height == height &&
                          plane("tests", result.tests) && plane("nodes", result.nodes);
        // No NaN is >= 0.
        const auto counts = [](float v) { return v >= 0 && std::isfinite(v); };
        const bool counted = std::all_of(result.tests.begin(), result.tests.end(), counts) &&
                             std::all_of(result.nodes.begin(), result.nodes.end(), counts);
        if (good) result.problem = counted ? "" : "holds numbers that count nothing";
        OIIO::geterror();  // forget what was said: the problem is known
    } catch (const std::exception&) {
        // The problem is known.
    }
    if (!result.problem.empty()) result.tests.clear(), result.nodes.clear();
    return result;
}

}  // namespace rays::grader
