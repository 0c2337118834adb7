// SHA-256 (FIPS 180-4): the fingerprint of scenes and references in the manifest, and of the report's scripts.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace rays {

/// The 32 bytes of the digest.
std::array<std::uint8_t, 32> sha256_digest(std::string_view bytes);

/// The same as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

/// The same of a file's bytes. Throws InputError when it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace rays
