#include "encoding.h"

#include <zlib.h>

#include <stdexcept>

#include "support/sha256.h"

namespace rays::report {

Bytes deflate(const Bytes& bytes, Effort effort) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    Bytes packed(size);
    const int level = effort == Effort::best ? Z_BEST_COMPRESSION : Z_BEST_SPEED;
    if (compress2(packed.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), level) != Z_OK)
        throw std::runtime_error("zlib could not compress the pixels of a picture");
    packed.resize(size);
    return packed;
}

std::string base64(const Bytes& bytes) {
    static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        const std::uint32_t group = std::uint32_t{bytes[i]} << 16 | (left > 1 ? std::uint32_t{bytes[i + 1]} << 8 : 0u) |
                                    (left > 2 ? std::uint32_t{bytes[i + 2]} : 0u);
        text += kDigits[group >> 18];
        text += kDigits[group >> 12 & 63];
        text += left > 1 ? kDigits[group >> 6 & 63] : '=';
        text += left > 2 ? kDigits[group & 63] : '=';
    }
    return text;
}

Bytes sha256(std::string_view text) {
    const auto digest = sha256_digest(text);
    return {digest.begin(), digest.end()};
}

}  // namespace rays::report
