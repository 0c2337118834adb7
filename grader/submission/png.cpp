#include "grader/submission/png.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdlib>
#include <string_view>

namespace rays::grader {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t kChunkFrame = 12;  ///< length, type, checksum

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t v = 0;
    for (const char c : bytes.substr(0, 4)) v = v << 8 | static_cast<unsigned char>(c);
    return v;
}

struct Chunk {
    std::string_view type, data;
};

/// The next chunk, taken off `rest`; without a type when the bytes end too early or its checksum is wrong.
Chunk next_chunk(std::string_view& rest) {
    if (rest.size() < kChunkFrame) return {};
    const std::size_t length = big_endian(rest);
    if (length > rest.size() - kChunkFrame) return {};
    const Chunk chunk{rest.substr(4, 4), rest.substr(8, length)};
    const std::string_view checked = rest.substr(4, length + 4);
    const auto sum = ::crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size()));
    if (sum != big_endian(rest.substr(length + 8))) return {};
    rest.remove_prefix(length + kChunkFrame);
    return chunk;
}

struct Header {
    Raster raster{0, 0};
    std::size_t channels = 0;
    std::string problem;
};

Header read_header(const Chunk& chunk, Raster wanted) {
    Header header;
    if (chunk.type != "IHDR" || chunk.data.size() != 13) return header.problem = "is damaged: it has no header", header;
    const std::uint32_t width = big_endian(chunk.data), height = big_endian(chunk.data.substr(4));
    if (width != static_cast<std::uint32_t>(wanted.width) || height != static_cast<std::uint32_t>(wanted.height))
        return header.problem = fmt::format("is {} x {} pixels, but submission.json says {} x {}", width, height,
                                            wanted.width, wanted.height),
               header;
    const int bits = chunk.data[8], color = chunk.data[9], interlaced = chunk.data[12];
    if (bits != 8 || (color != 2 && color != 6) || interlaced != 0 || chunk.data[10] != 0 || chunk.data[11] != 0)
        return header.problem = "is of another kind of PNG: save it with 8 bits, RGB or RGBA, not interlaced", header;
    header.raster = wanted;
    header.channels = color == 6 ? 4 : 3;
    return header;
}

/// Exactly `size` bytes out of the IDAT chunks' data; empty when there are fewer or the stream is broken.
std::vector<std::uint8_t> inflated(std::string_view packed, std::size_t size) {
    std::vector<std::uint8_t> out(size);
    z_stream stream{};
    if (::inflateInit(&stream) != Z_OK) return {};
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = out.data();
    stream.avail_out = static_cast<uInt>(out.size());
    const int status = ::inflate(&stream, Z_FINISH);
    const bool whole = stream.avail_out == 0 && status == Z_STREAM_END;
    ::inflateEnd(&stream);
    return whole ? out : std::vector<std::uint8_t>();
}

int paeth(int left, int up, int corner) {
    const int guess = left + up - corner;
    const int by_left = std::abs(guess - left), by_up = std::abs(guess - up), by_corner = std::abs(guess - corner);
    if (by_left <= by_up && by_left <= by_corner) return left;
    return by_up <= by_corner ? up : corner;
}

/// Undoes the filters of all rows in place. Each row has its filter's number before it. False for an unknown one.
bool unfilter(std::vector<std::uint8_t>& rows, int height, std::size_t row_bytes, std::size_t channels) {
    const std::vector<std::uint8_t> nothing(row_bytes + 1);
    const std::uint8_t* above = nothing.data() + 1;
    for (int y = 0; y < height; ++y) {
        std::uint8_t* row = rows.data() + static_cast<std::size_t>(y) * (row_bytes + 1);
        const int filter = *row++;
        if (filter > 4) return false;
        for (std::size_t i = 0; i < row_bytes; ++i) {
            const int left = i < channels ? 0 : row[i - channels], up = above[i];
            const int corner = i < channels ? 0 : above[i - channels];
            const int guesses[] = {0, left, up, (left + up) / 2, paeth(left, up, corner)};
            row[i] = static_cast<std::uint8_t>(row[i] + guesses[filter]);
        }
        above = row;
    }
    return true;
}

PngPicture refused(const std::string& problem) { return {{}, problem}; }

}  // namespace

PngPicture decode_png(const std::string& bytes, Raster raster) {
    std::string_view rest(bytes);
    if (!rest.starts_with(kSignature)) return refused("is no PNG file");
    rest.remove_prefix(kSignature.size());
    const Header header = read_header(next_chunk(rest), raster);
    if (!header.problem.empty()) return refused(header.problem);
    std::string packed;
    for (Chunk chunk = next_chunk(rest); chunk.type != "IEND"; chunk = next_chunk(rest)) {
        if (chunk.type.empty()) return refused("is damaged: it ends too early, or a checksum is wrong");
        if (chunk.type == "IDAT") packed += chunk.data;
    }
    const std::size_t row_bytes = static_cast<std::size_t>(raster.width) * header.channels;
    auto rows = inflated(packed, (row_bytes + 1) * static_cast<std::size_t>(raster.height));
    if (rows.empty() || !unfilter(rows, raster.height, row_bytes, header.channels))
        return refused("is damaged: its pixels cannot be read");
    PngPicture picture;
    for (std::size_t y = 0; y < static_cast<std::size_t>(raster.height); ++y)
        for (std::size_t x = 0; x < static_cast<std::size_t>(raster.width); ++x) {
            const std::uint8_t* p = rows.data() + y * (row_bytes + 1) + 1 + x * header.channels;
            picture.pixels.push_back({p[0], p[1], p[2]});
        }
    return picture;
}

}  // namespace rays::grader
