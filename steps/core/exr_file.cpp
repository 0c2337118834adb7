// EXR files, uncompressed, as "OpenEXR File Layout" (openexr.com) has them: attributes, a table of where each line
// begins, the lines. Written here: loading OpenEXR and its four libraries took longer than many a picture's sky.
// Deflating 32-bit floats would take as long as rendering a picture of nine spheres, and save a third; without it each
// line has its place in the file before it is known.
#include "core/exr_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace rays {

namespace {

constexpr std::uint64_t kPiece = 256 << 10;  ///< bytes that are written at once

static_assert(std::endian::native == std::endian::little, "numbers of EXR files are little-endian");

template <class T>
void append(std::string& bytes, T number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}
void append_text(std::string& bytes, std::string_view characters) {  // with its final 0
    bytes.append(characters).push_back('\0');
}

}  // namespace

ExrFile::ExrFile(std::string path, Raster raster, const std::vector<std::string>& lanes)
    : path_(std::move(path)), partial_(path_ + ".partial") {
    for (std::size_t c = 0; c < lanes.size(); ++c) channels_.push_back({lanes[c], static_cast<int>(c)});
    std::sort(channels_.begin(), channels_.end(), [](const Channel& a, const Channel& b) { return a.name < b.name; });
    line_bytes_ = 2 * sizeof(std::int32_t) + sizeof(float) * static_cast<std::size_t>(raster.width) * channels_.size();
    file_ = ::open(partial_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file_ < 0) fail(errno);
    begin(raster);
    if (problem_ != 0) fail(problem_);
}

ExrFile::~ExrFile() {
    if (file_ < 0) return;
    ::close(file_);
    ::unlink(partial_.c_str());
}

/// Room for the whole file at once, so that a full disk is noticed before anything is rendered; ext4 also needs a
/// quarter less time then. File systems that cannot do it find room as they go.
void ExrFile::begin(Raster raster) {
    std::string bytes = header(raster);
    const auto lines = static_cast<std::uint64_t>(raster.height);
    first_line_ = bytes.size() + sizeof first_line_ * lines;
    for (std::uint64_t y = 0; y < lines; ++y) append(bytes, first_line_ + y * line_bytes_);
    const auto all = static_cast<off_t>(first_line_ + lines * line_bytes_);
    if (::fallocate(file_, 0, 0, all) != 0 && errno == ENOSPC) problem_ = ENOSPC;
    write(bytes, 0);
}

std::string ExrFile::header(Raster raster) const {
    std::string bytes;
    const auto attribute = [&](std::string_view name, std::string_view type, std::int32_t size) {
        append_text(bytes, name);
        append_text(bytes, type);
        append(bytes, size);
    };
    const auto window = [&](std::string_view name) {
        attribute(name, "box2i", 16);
        for (const std::int32_t corner : {0, 0, raster.width - 1, raster.height - 1}) append(bytes, corner);
    };
    append(bytes, std::uint32_t{20000630});
    append(bytes, std::uint32_t{2});  // an EXR file, version 2: one picture, in lines
    std::size_t list = 1;
    for (const Channel& channel : channels_) list += channel.name.size() + 17;
    attribute("channels", "chlist", static_cast<std::int32_t>(list));
    for (const Channel& channel : channels_) {
        constexpr std::int32_t kFloat = 2, kNotPerceptual = 0, kEveryPixel = 1;
        append_text(bytes, channel.name);
        for (const std::int32_t property : {kFloat, kNotPerceptual, kEveryPixel, kEveryPixel}) append(bytes, property);
    }
    append_text(bytes, "");
    attribute("compression", "compression", 1);
    append(bytes, std::uint8_t{0});  // none
    window("dataWindow");
    window("displayWindow");
    attribute("lineOrder", "lineOrder", 1);
    append(bytes, std::uint8_t{0});  // from top to bottom
    attribute("pixelAspectRatio", "float", 4);
    append(bytes, 1.0f);
    attribute("screenWindowCenter", "v2f", 8);
    append(bytes, 0.0f);
    append(bytes, 0.0f);
    attribute("screenWindowWidth", "float", 4);
    append(bytes, 1.0f);
    append_text(bytes, "");
    return bytes;
}

void ExrFile::take(const Film& lines, int first) noexcept {
    const auto [width, height] = lines.raster();
    const int together = static_cast<int>(std::clamp<std::uint64_t>(kPiece / line_bytes_, 1, height));
    std::string bytes(line_bytes_ * static_cast<std::size_t>(together), '\0');
    for (int y = 0; y < height; y += together) {
        char* to = bytes.data();
        const auto put = [&](auto number) {
            std::memcpy(to, &number, sizeof number);
            to += sizeof number;
        };
        for (int line = y; line < std::min(y + together, height); ++line) {
            put(std::int32_t{first + line});
            put(static_cast<std::int32_t>(line_bytes_ - 2 * sizeof(std::int32_t)));
            const Radiance* const pixels = &lines.at(0, line);  // bytes may be anything's, so nothing else stays known
            for (const Channel& channel : channels_)
                for (int x = 0, lane = channel.lane; x < width; ++x) put(pixels[x].lane[lane]);
        }
        write({bytes.data(), to}, first_line_ + static_cast<std::uint64_t>(first + y) * line_bytes_);
    }
}

void ExrFile::write(std::string_view bytes, std::uint64_t place) noexcept {
    for (std::size_t done = 0; done < bytes.size() && problem_ == 0;) {
        const auto written =
            ::pwrite(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(place + done));
        if (written > 0)
            done += static_cast<std::size_t>(written);
        else if (written == 0 || errno != EINTR)
            problem_ = written == 0 ? EIO : errno;
    }
}

void ExrFile::finish() {
    if (::close(std::exchange(file_, -1)) != 0) problem_ = errno;
    if (problem_ == 0 && ::rename(partial_.c_str(), path_.c_str()) != 0) problem_ = errno;
    if (problem_ != 0) fail(problem_);
}

void ExrFile::fail(int problem) {
    if (file_ >= 0) ::close(std::exchange(file_, -1));
    ::unlink(partial_.c_str());
    throw InputError(path_ + ": cannot write the picture (" + std::generic_category().message(problem) +
                     "); check that the folder exists, is writable and has room");
}

void write_exr(const Film& film, const std::string& path, const std::vector<std::string>& lanes) {
    ExrFile file(path, film.raster(), lanes);
    file.take(film, 0);
    file.finish();
}

}  // namespace rays
