#include "grader/text.h"

namespace rays::grader {
namespace {

std::string clean(std::string_view text, std::size_t limit, bool keep_lines) {
    std::string out;
    for (const char c : text.substr(0, limit)) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\n' || c == '\t')
            out += c == '\n' && keep_lines ? '\n' : ' ';
        else
            out += byte >= 0x20 && byte < 0x7f ? c : '?';
    }
    if (text.size() > limit) out += "...";
    return out;
}

}  // namespace

std::string plain(std::string_view text, std::size_t limit) { return clean(text, limit, false); }
std::string plain_lines(std::string_view text, std::size_t limit) { return clean(text, limit, true); }

}  // namespace rays::grader
