// Text that a student's program wrote, made harmless.
#pragma once

#include <string>
#include <string_view>

namespace rays::grader {

/// For a terminal or a one-line message: control characters (escape sequences among them) and bytes that are no ASCII
/// become "?", line ends become spaces, and the text is cut after `limit` characters with "...".
std::string plain(std::string_view text, std::size_t limit = 200);

/// The same, but line ends stay: for compiler messages and ray trees.
std::string plain_lines(std::string_view text, std::size_t limit = 4000);

}  // namespace rays::grader
