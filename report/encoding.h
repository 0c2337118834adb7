// Bytes for a web page: deflate, base64 and base 91, SHA-256.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rays::report {

using Bytes = std::vector<std::uint8_t>;

/// zlib format (RFC 1950), which browsers decode with DecompressionStream("deflate").
Bytes deflate(std::string_view bytes);

/// For the inside of a script element: 13 bits in two digits, a twelfth shorter than base64. The digits are the ASCII
/// characters from # to ~ but for <, in their order. A last digit alone has 6 bits.
std::string base91(const Bytes& bytes);

/// RFC 4648, with padding.
std::string base64(const Bytes& bytes);

/// FIPS 180-4. The digest's 32 bytes.
Bytes sha256(std::string_view text);

}  // namespace rays::report
