#include "core/film.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "core/error.h"

namespace rays {

namespace {

/// A file that is written in large pieces: OpenEXR hands over line by line.
class LargeWrites final : public Imf::OStream {
public:
    explicit LargeWrites(const char* path) : OStream(path), file_(path, std::ios::binary) { check(); }

    void write(const char* bytes, int count) override {
        held_.append(bytes, static_cast<std::size_t>(count));
        if (held_.size() >= kPiece) flush();
    }
    std::uint64_t tellp() override { return static_cast<std::uint64_t>(file_.tellp()) + held_.size(); }
    void seekp(std::uint64_t place) override {
        flush();
        file_.seekp(static_cast<std::streamoff>(place));
        check();
    }
    void flush() {
        file_.write(held_.data(), static_cast<std::streamsize>(held_.size()));
        held_.clear();
        check();
    }
    void close() {
        flush();
        file_.close();
        check();
    }

private:
    static constexpr std::size_t kPiece = std::size_t(256) << 10;
    void check() const {
        if (!file_) throw std::system_error(errno, std::generic_category());
    }
    std::ofstream file_;
    std::string held_;
};

}  // namespace

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
        LargeWrites out(partial.c_str());
        {
            Imf::OutputFile file(out, header);
            file.setFrameBuffer(frame);
            file.writePixels(height);
        }
        out.close();
        std::filesystem::rename(partial, path);
    } catch (const std::exception& e) {
        std::error_code ignored;
        std::filesystem::remove(partial, ignored);
        throw InputError(path + ": cannot write the picture (" + e.what() +
                         "); check that the folder exists, is writable and has room");
    }
}

}  // namespace rays
