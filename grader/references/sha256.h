// SHA-256 (FIPS 180-4): the fingerprint of scenes and references in the manifest.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rays {

/// 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

/// The same of a file's bytes. Throws InputError when it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace rays
