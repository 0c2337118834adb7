// EXR files, uncompressed, as "OpenEXR File Layout" (openexr.com) has them: attributes, a table of where each line
// begins, the lines. Written here: loading OpenEXR and its four libraries took longer than many a picture's sky.
// Deflating 32-bit floats would take as long as rendering a picture of nine spheres, and save a third.
#include "core/film.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/error.h"

namespace rays {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers of EXR files are little-endian");

/// Bytes to be written, in large pieces.
class Output {
public:
    explicit Output(const std::string& path) : file_(path, std::ios::binary) { check(); }

    template <class T>
    Output& number(T value) {
        held_.append(reinterpret_cast<const char*>(&value), sizeof value);
        return *this;
    }
    Output& text(std::string_view characters) {  // with its final 0
        held_.append(characters).push_back('\0');
        return *this;
    }
    void floats(const std::vector<float>& values) {
        held_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
        if (held_.size() >= kPiece) flush();
    }
    void close() {
        flush();
        file_.close();
        check();
    }

private:
    static constexpr std::size_t kPiece = std::size_t(256) << 10;
    void flush() {
        file_.write(held_.data(), static_cast<std::streamsize>(held_.size()));
        held_.clear();
        check();
    }
    void check() const {
        if (!file_) throw std::system_error(errno, std::generic_category());
    }
    std::ofstream file_;
    std::string held_;
};

/// A lane and its name.
struct Channel {
    std::string name;
    int lane;
};

/// In the order of their names, as the format wants them.
std::vector<Channel> channels_of(const std::vector<std::string>& lanes) {
    std::vector<Channel> channels;
    for (std::size_t c = 0; c < lanes.size(); ++c) channels.push_back({lanes[c], static_cast<int>(c)});
    std::sort(channels.begin(), channels.end(), [](const Channel& a, const Channel& b) { return a.name < b.name; });
    return channels;
}

/// The header, and how many bytes it has.
std::size_t write_header(Output& out, Raster raster, const std::vector<Channel>& channels) {
    std::size_t size = 0;
    const auto attribute = [&](std::string_view name, std::string_view type, std::int32_t bytes) -> Output& {
        size += name.size() + type.size() + 2 + sizeof bytes + static_cast<std::size_t>(bytes);
        return out.text(name).text(type).number(bytes);
    };
    const auto window = [&](std::string_view name) {
        attribute(name, "box2i", 16).number(std::int32_t{0}).number(std::int32_t{0});
        out.number<std::int32_t>(raster.width - 1).number<std::int32_t>(raster.height - 1);
    };
    out.number(std::uint32_t{20000630}).number(std::uint32_t{2});  // an EXR file, version 2: one picture, in lines
    std::size_t list = 1;
    for (const Channel& channel : channels) list += channel.name.size() + 17;
    attribute("channels", "chlist", static_cast<std::int32_t>(list));
    for (const Channel& channel : channels) {
        constexpr std::int32_t kFloat = 2, kNotPerceptual = 0, kEveryPixel = 1;
        out.text(channel.name).number(kFloat).number(kNotPerceptual).number(kEveryPixel).number(kEveryPixel);
    }
    out.text("");
    attribute("compression", "compression", 1).number(std::uint8_t{0});  // none
    window("dataWindow");
    window("displayWindow");
    attribute("lineOrder", "lineOrder", 1).number(std::uint8_t{0});  // from top to bottom
    attribute("pixelAspectRatio", "float", 4).number(1.0f);
    attribute("screenWindowCenter", "v2f", 8).number(0.0f).number(0.0f);
    attribute("screenWindowWidth", "float", 4).number(1.0f);
    out.text("");
    return size + 9;
}

void write(Output& out, const Film& film, const std::vector<Channel>& channels) {
    std::vector<float> values(static_cast<std::size_t>(film.raster().width) * channels.size());
    const std::size_t bytes = values.size() * sizeof(float);
    const std::size_t header = write_header(out, film.raster(), channels);
    std::uint64_t line = header + sizeof line * static_cast<std::size_t>(film.raster().height);
    for (int y = 0; y < film.raster().height; ++y, line += 2 * sizeof(std::int32_t) + bytes) out.number(line);
    for (int y = 0; y < film.raster().height; ++y) {
        out.number<std::int32_t>(y).number(static_cast<std::int32_t>(bytes));
        float* to = values.data();
        for (const Channel& channel : channels)
            for (int x = 0; x < film.raster().width; ++x) *to++ = film.at(x, y)[channel.lane];
        out.floats(values);
    }
    out.close();
}

}  // namespace

void write_exr(const Film& film, const std::string& path, const std::vector<std::string>& lanes) {
    const std::string partial = path + ".partial";
    try {
        Output out(partial);
        write(out, film, channels_of(lanes));
        std::filesystem::rename(partial, path);
    } catch (const std::exception& e) {
        std::error_code ignored;
        std::filesystem::remove(partial, ignored);
        throw InputError(path + ": cannot write the picture (" + e.what() +
                         "); check that the folder exists, is writable and has room");
    }
}

}  // namespace rays
