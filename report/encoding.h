// Bytes for a web page: deflate, base64, SHA-256.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rays::report {

using Bytes = std::vector<std::uint8_t>;

/// zlib format (RFC 1950), which browsers decode with DecompressionStream("deflate").
enum class Effort { quick, best };
Bytes deflate(const Bytes& bytes, Effort effort = Effort::best);

/// RFC 4648, with padding.
std::string base64(const Bytes& bytes);

/// FIPS 180-4. The digest's 32 bytes.
Bytes sha256(std::string_view text);

}  // namespace rays::report
