#include "encoding.h"

#include <zlib.h>

#include <stdexcept>

#include "support/sha256.h"

namespace rays::report {

Bytes deflate(std::string_view bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    Bytes packed(size);
    const auto* from = reinterpret_cast<const Bytef*>(bytes.data());
    if (compress2(packed.data(), &size, from, static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION) != Z_OK)
        throw std::runtime_error("zlib could not compress the results");
    packed.resize(size);
    return packed;
}

std::string base91(const Bytes& bytes) {
    const auto digit = [](std::uint32_t d) { return static_cast<char>('#' + d + (d >= '<' - '#' ? 1 : 0)); };
    std::string text;
    text.reserve(bytes.size() * 16 / 13 + 2);
    std::uint32_t bits = 0;
    int count = 0;
    const auto put = [&](std::uint32_t group) { text += digit(group / 91), text += digit(group % 91); };
    for (const std::uint8_t byte : bytes) {
        bits = bits << 8 | byte;
        count += 8;
        if (count < 13) continue;
        count -= 13;
        put(bits >> count & 8191u);
    }
    // Less than a byte of padding: nobody reads a byte too much.
    if (count > 6)
        put(bits << (13 - count) & 8191u);
    else if (count > 0)
        text += digit(bits << (6 - count) & 63u);
    return text;
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
