// References and frames as OpenEXR files.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>

#include "core/error.h"
#include "support/files.h"
#include "references/reference.h"

namespace rays {
namespace {

constexpr int kLargest = 4096;
constexpr std::array<const char*, 3> kChannels{"R", "G", "B"};

// A slice that begins at (left, top) of the data window and steps from pixel to pixel of `image`.
Imf::Slice slice(RgbImage& image, std::size_t channel, int left = 0, int top = 0) {
    constexpr std::size_t step = sizeof(Rgb);
    const std::size_t row = step * static_cast<std::size_t>(image.raster.width);
    return Imf::Slice::Make(Imf::FLOAT, &image.pixels[0][channel], Imath::V2i(left, top), image.raster.width,
                            image.raster.height, step, row);
}

void allocate(RgbImage& image, Raster raster) {
    image.raster = raster;
    image.pixels.resize(static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height));
}

/// A layer's name with its dot -> the image that receives it.
using Layers = std::vector<std::pair<std::string, RgbImage*>>;

void load_layers(const std::filesystem::path& file, const Layers& layers) {
    if (!std::filesystem::is_regular_file(file)) throw InputError(fmt::format("{}: no such file", file.string()));
    try {
        Imf::InputFile in(file.c_str());
        const Imath::Box2i window = in.header().dataWindow();
        const long long width = 1LL + window.max.x - window.min.x;
        const long long height = 1LL + window.max.y - window.min.y;
        if (width < 1 || height < 1 || width > kLargest || height > kLargest) {
            throw InputError(
                fmt::format("{}: {} x {} pixels, at most {} each way", file.string(), width, height, kLargest));
        }
        Imf::FrameBuffer buffer;
        for (const auto& [layer, image] : layers) {
            allocate(*image, {static_cast<int>(width), static_cast<int>(height)});
            for (std::size_t c = 0; c < 3; ++c) {
                const std::string channel = layer + kChannels[c];
                if (in.header().channels().findChannel(channel) == nullptr) {
                    throw InputError(fmt::format("{}: has no channel {}", file.string(), channel));
                }
                buffer.insert(channel, slice(*image, c, window.min.x, window.min.y));
            }
        }
        in.setFrameBuffer(buffer);
        in.readPixels(window.min.y, window.max.y);
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& problem) {
        throw InputError(fmt::format("{}: not readable as OpenEXR: {}", file.string(), problem.what()));
    }
}

// OpenEXR takes the numbers in the type of the file, so floats are converted here. They came from halves: no loss.
std::vector<Imath::half> to_halves(const RgbImage& image) {
    std::vector<Imath::half> result;
    for (const Rgb& pixel : image.pixels) result.insert(result.end(), pixel.begin(), pixel.end());
    return result;
}

}  // namespace

void save_reference(const Reference& reference, const std::filesystem::path& file) {
    const Raster raster = reference.raster();
    Imf::Header header(raster.width, raster.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer buffer;
    std::array<std::vector<Imath::half>, 3> halves;
    const std::array<std::pair<const char*, const RgbImage*>, 3> layers{
        {{"", &reference.frame}, {"min.", &reference.min}, {"max.", &reference.max}}};
    for (std::size_t l = 0; l < layers.size(); ++l) {
        halves[l] = to_halves(*layers[l].second);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::string channel = std::string(layers[l].first) + kChannels[c];
            constexpr std::size_t step = 3 * sizeof(Imath::half);
            header.channels().insert(channel, Imf::Channel(Imf::HALF));
            buffer.insert(
                channel, Imf::Slice::Make(Imf::HALF, &halves[l][c], Imath::V2i(0, 0), raster.width, raster.height, step,
                                          step * static_cast<std::size_t>(raster.width)));
        }
    }
    write_atomically(file, [&](const std::filesystem::path& partial) {
        Imf::OutputFile out(partial.c_str(), header);
        out.setFrameBuffer(buffer);
        out.writePixels(raster.height);
    });
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
