// Text that a student may control, made harmless before it enters the page.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace rays::report {

/// Valid UTF-8 without control characters: escape and its like become visible pictures (U+2400 ...), marks that
/// reorder the text on the screen become U+FFFD. Longer texts are cut at a character and say how much is missing.
std::string harmless(std::string_view text, std::size_t max_bytes);

/// Bytes that are no UTF-8 become U+FFFD, everything else stays: a JSON reader stops at them.
std::string valid_utf8(std::string_view text);

/// harmless() for every string and every key of a JSON value.
void make_harmless(nlohmann::json& value, std::size_t max_bytes);

/// JSON for the inside of a script element: ASCII only, no character that HTML or JavaScript could take for its own.
std::string for_script(const nlohmann::json& value);

}  // namespace rays::report
