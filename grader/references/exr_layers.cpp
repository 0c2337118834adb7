#include "references/exr_layers.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <fmt/format.h>

#include "core/error.h"
#include "support/files.h"

namespace rays {
namespace {

constexpr int kLargest = 4096;
constexpr std::array<const char*, 3> kChannels{"R", "G", "B"};

// Slices that begin at (left, top) of the data window and step from pixel to pixel.
Imf::Slice slice(Imf::PixelType type, const void* first, std::size_t step, Raster raster, int left = 0, int top = 0) {
    return Imf::Slice::Make(type, first, Imath::V2i(left, top), raster.width, raster.height, step,
                            step * static_cast<std::size_t>(raster.width));
}

void allocate(RgbImage& image, Raster raster) {
    image.raster = raster;
    image.pixels.resize(static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height));
}

// OpenEXR takes the numbers in the type of the file, so floats are converted here. They came from halves: no loss.
std::vector<Imath::half> to_halves(const RgbImage& image) {
    std::vector<Imath::half> result;
    for (const Rgb& pixel : image.pixels) result.insert(result.end(), pixel.begin(), pixel.end());
    return result;
}

}  // namespace

void load_layers(const std::filesystem::path& file, const LayersRead& layers) {
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
                buffer.insert(channel, slice(Imf::FLOAT, &image->pixels[0][c], sizeof(Rgb), image->raster, window.min.x,
                                             window.min.y));
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

void save_layers(const std::filesystem::path& file, const LayersWritten& layers, Digits digits) {
    const Raster raster = layers.front().second->raster;
    const Imf::PixelType type = digits == Digits::half ? Imf::HALF : Imf::FLOAT;
    Imf::Header header(raster.width, raster.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer buffer;
    std::vector<std::vector<Imath::half>> halves(layers.size());  // alive until the pixels are written
    for (std::size_t l = 0; l < layers.size(); ++l) {
        const auto& [layer, image] = layers[l];
        if (digits == Digits::half) halves[l] = to_halves(*image);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::string channel = layer + kChannels[c];
            header.channels().insert(channel, Imf::Channel(type));
            buffer.insert(channel, digits == Digits::half ? slice(type, &halves[l][c], 3 * sizeof(Imath::half), raster)
                                                          : slice(type, &image->pixels[0][c], sizeof(Rgb), raster));
        }
    }
    write_atomically(file, [&](const std::filesystem::path& partial) {
        Imf::OutputFile out(partial.c_str(), header);
        out.setFrameBuffer(buffer);
        out.writePixels(raster.height);
    });
}

}  // namespace rays
