#include "core/film.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>

#include <cstdio>
#include <filesystem>
#include <system_error>

#include "core/error.h"

namespace rays {

void write_exr(const Film& film, const std::string& path, const std::vector<std::string>& lanes) {
    const auto [width, height] = film.raster();
    const std::string partial = path + ".partial";
    try {
        Imf::setGlobalThreadCount(0);
        // Uncompressed: deflating 32-bit floats took as long as rendering a picture of nine spheres, and saved a third.
        Imf::Header header(width, height, 1, Imath::V2f(0, 0), 1, Imf::INCREASING_Y, Imf::NO_COMPRESSION);
        Imf::FrameBuffer frame;
        auto* base = const_cast<char*>(reinterpret_cast<const char*>(&film.at(0, 0)));
        for (std::size_t c = 0; c < lanes.size(); ++c) {
            header.channels().insert(lanes[c], Imf::Channel(Imf::FLOAT));
            frame.insert(lanes[c], Imf::Slice(Imf::FLOAT, base + sizeof(float) * c,
                                              sizeof(Radiance),
                                              sizeof(Radiance) * static_cast<std::size_t>(width)));
        }
        {
            Imf::OutputFile file(partial.c_str(), header);
            file.setFrameBuffer(frame);
            file.writePixels(height);
        }
        std::filesystem::rename(partial, path);
    } catch (const std::exception& e) {
        std::error_code ignored;
        std::filesystem::remove(partial, ignored);
        throw InputError(path + ": cannot write the picture (" + e.what() +
                         "); check that the folder exists, is writable and has room");
    }
}

}  // namespace rays
