#include "text.h"

#include <fmt/format.h>

#include <cstdint>

namespace rays::report {
namespace {

constexpr std::uint32_t kReplacement = 0xfffd;

struct Decoded {
    std::uint32_t code = kReplacement;
    std::size_t bytes = 1;
};

// One character of UTF-8 (RFC 3629); a byte that starts none counts as one replacement character.
Decoded decode(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const std::uint32_t first = byte(at);
    if (first < 0x80) return {first, 1};
    const std::size_t length = first >= 0xf0 && first < 0xf5 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
    if (length == 0 || first >= 0xf5) return {};
    std::uint32_t code = first & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(at + i) & 0xc0u) != 0x80u) return {};
        code = code << 6 | (byte(at + i) & 0x3fu);
    }
    constexpr std::uint32_t kFirstOfLength[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    if (code < kFirstOfLength[length] || surrogate || code > 0x10ffff) return {};
    return {code, length};
}

void append(std::string& text, std::uint32_t code) {
    const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xc0 | code >> 6), put(0x80 | (code & 63));
    } else if (code < 0x10000) {
        put(0xe0 | code >> 12), put(0x80 | (code >> 6 & 63)), put(0x80 | (code & 63));
    } else {
        put(0xf0 | code >> 18), put(0x80 | (code >> 12 & 63)), put(0x80 | (code >> 6 & 63)), put(0x80 | (code & 63));
    }
}

bool reorders_text(std::uint32_t c) {
    return (c >= 0x202a && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069) || c == 0x200e || c == 0x200f || c == 0x061c;
}

std::uint32_t visible(std::uint32_t c) {
    if (c == '\n' || c == '\t') return c;
    if (c < 0x20) return 0x2400 + c;
    if (c == 0x7f) return 0x2421;
    if ((c > 0x7f && c < 0xa0) || reorders_text(c)) return kReplacement;
    return c;
}

}  // namespace

std::string harmless(std::string_view text, std::size_t max_bytes) {
    std::string out;
    std::size_t at = 0;
    while (at < text.size() && out.size() < max_bytes) {
        const Decoded c = decode(text, at);
        at += c.bytes;
        if (c.code == '\r' && at < text.size() && text[at] == '\n') continue;
        append(out, visible(c.code));
    }
    if (at < text.size()) out += fmt::format(" … ({} more bytes cut)", text.size() - at);
    return out;
}

std::string valid_utf8(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const Decoded c = decode(text, at);
        append(out, c.code);
        at += c.bytes;
    }
    return out;
}

void make_harmless(nlohmann::json& value, std::size_t max_bytes) {
    if (value.is_string()) {
        value = harmless(value.get_ref<const std::string&>(), max_bytes);
    } else if (value.is_array()) {
        for (auto& item : value) make_harmless(item, max_bytes);
    } else if (value.is_object()) {
        nlohmann::json clean = nlohmann::json::object();
        for (auto& [key, item] : value.items()) {
            make_harmless(item, max_bytes);
            clean[harmless(key, 200)] = std::move(item);
        }
        value = std::move(clean);
    }
}

std::string for_script(const nlohmann::json& value) {
    const std::string json = value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    std::string out;
    out.reserve(json.size());
    for (const char c : json) {
        if (c == '<' || c == '>' || c == '&')
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            out += c;
    }
    return out;
}

}  // namespace rays::report
