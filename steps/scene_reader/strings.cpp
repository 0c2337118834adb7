// Strings and what is made of them.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "core/error.h"
#include "scene_reader/interpreter.h"

namespace rays::sdl {

bool Interpreter::string_follows() {
    const Token& token = peek();
    switch (token.kind) {
        case Token::Kind::string: return true;
        case Token::Kind::value: return token.value->as<std::string>() != nullptr;
        case Token::Kind::word: break;
        default: return false;
    }
    switch (token.word) {
        case Word::chr_:
        case Word::concat_:
        case Word::str_:
        case Word::strlwr_:
        case Word::strupr_:
        case Word::substr_:
        case Word::vstr_: return true;
        default: return false;
    }
}

namespace {

/// Escapes as POV-Ray knows them.
std::string unescaped(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t plain = std::min(text.find('\\', i), text.size());
        result.append(text, i, plain - i);
        i = plain;
        if (i + 1 >= text.size()) {
            result.append(text, i);
            break;
        }
        switch (const char c = text[++i]) {
            case 'n': result += '\n'; break;
            case 't': result += '\t'; break;
            case 'r': result += '\r'; break;
            case 'a': result += '\a'; break;
            case 'b': result += '\b'; break;
            case 'f': result += '\f'; break;
            case 'v': result += '\v'; break;
            case '0': result += '\0'; break;
            default: result += c;
        }
    }
    return result;
}

/// str(value, width, precision): as printf's %f; negative width: zeros in front; negative precision: printf's own.
std::string formatted(double value, int width, int precision) {
    char text[600];
    const char* format = width < 0 ? (precision < 0 ? "%0*f" : "%0*.*f") : (precision < 0 ? "%*f" : "%*.*f");
    const int field = std::abs(width);
    const int length = precision < 0 ? std::snprintf(text, sizeof text, format, field, value)
                                     : std::snprintf(text, sizeof text, format, field, precision, value);
    return std::string(text, static_cast<std::size_t>(std::min<int>(length, sizeof text - 1)));
}

}  // namespace

std::string Interpreter::string() {
    const Nesting nesting(*this);
    const Token token = take();
    std::string result;
    if (token.kind == Token::Kind::string) {
        result = unescaped(token.text);
    } else if (token.kind == Token::Kind::value && token.value->as<std::string>()) {
        result = *token.value->as<std::string>();
    } else if (token.kind == Token::Kind::word) {
        result = string_made_by(token);
    } else {
        fail(token, fmt::format("found {}; expected a string", describe(token)));
    }
    if (result.size() > kLongestString) fail(token, fmt::format("a string of more than {} characters", kLongestString));
    spend(static_cast<std::int64_t>(result.size()) / kBytesPerWork);
    return result;
}

std::string Interpreter::string_made_by(const Token& token) {
    expect('(', fmt::format("'{}', where a string is expected", token.text));
    std::string result;
    switch (token.word) {
        case Word::chr_: {
            const int code = integer("the code of a character", 0, 255);
            result = std::string(1, static_cast<char>(code));
            break;
        }
        case Word::concat_:
            result = string();
            while (!peek().is(')')) {
                comma();
                result += string();
                if (result.size() > kLongestString) fail(token, "the string grows too long");
            }
            break;
        case Word::str_: {
            const double value = number();
            comma();
            const int width = integer("the width of str", -200, 200);
            comma();
            result = formatted(value, width, integer("the precision of str", -1000, 100));
            spend(kWorkOfPrintedDigit * static_cast<std::int64_t>(result.size()));
            break;
        }
        case Word::vstr_: {
            const int size = std::clamp(integer("the size of vstr", -1000, 1000), 2, 5);
            comma();
            const Numbers value = sum(1);
            comma();
            const std::string between = string();
            comma();
            const int width = integer("the width of vstr", -200, 200);
            comma();
            const int precision = integer("the precision of vstr", -1000, 100);
            for (int i = 0; i < size; ++i) result += (i ? between : "") + formatted(value.at[i], width, precision);
            spend(kWorkOfPrintedDigit * static_cast<std::int64_t>(result.size()));
            break;
        }
        case Word::substr_: {
            const std::string text = string();
            comma();
            const int first = integer("the start of substr", 1, 1 << 20);
            comma();
            const int length = integer("the length of substr", 0, 1 << 20);
            if (static_cast<std::size_t>(first) - 1 + static_cast<std::size_t>(length) > text.size()) {
                fail(token, fmt::format("substr reaches beyond the {} characters of the string", text.size()));
            }
            result = text.substr(static_cast<std::size_t>(first) - 1, static_cast<std::size_t>(length));
            break;
        }
        case Word::strupr_:
        case Word::strlwr_:
            result = string();
            for (char& c : result)
                c = static_cast<char>(token.word == Word::strupr_ ? std::toupper(c) : std::tolower(c));
            break;
        default: fail(token, fmt::format("found {}; expected a string", describe(token)));
    }
    expect(')', fmt::format("'{}'", token.text));
    return result;
}

bool Interpreter::string_function(Word word, const Place& place, double& result) {
    switch (word) {
        case Word::asc_:
        case Word::file_exists_:
        case Word::strcmp_:
        case Word::strlen_:
        case Word::val_: break;
        default: return false;
    }
    expect('(', fmt::format("'{}'", to_string(word)));
    const std::string text = string();
    if (word == Word::strcmp_) {
        comma();
        const int order = text.compare(string());
        result = order < 0 ? -1 : order > 0;
    } else if (word == Word::asc_) {
        result = text.empty() ? 0 : static_cast<unsigned char>(text[0]);
    } else if (word == Word::strlen_) {
        result = static_cast<double>(text.size());
    } else if (word == Word::val_) {
        result = std::strtod(text.c_str(), nullptr);
    } else {
        spend(kWorkOfFileSearch);
        try {
            result = !sources_.find_file(text).empty();
        } catch (const InputError& error) {
            fail(place, error.what());
        }
    }
    expect(')', fmt::format("'{}'", to_string(word)));
    return true;
}

}  // namespace rays::sdl
