#include "scene_reader/token.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>

#include "core/error.h"

namespace rays::sdl {

namespace {

/// What a byte can begin. One table look-up a byte: scanning is most of the work of reading a large scene.
enum class Class : std::uint8_t { none, blank, digit, letter, symbol, quote, hash };

constexpr std::array<Class, 256> kClasses = [] {
    std::array<Class, 256> classes{};
    const auto set = [&classes](std::string_view bytes, Class to) {
        for (char c : bytes) classes[static_cast<unsigned char>(c)] = to;
    };
    set(" \n\t\r", Class::blank);
    set("0123456789", Class::digit);
    set("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_", Class::letter);
    set("{}()[]<>,;+-*/=!&|?:.@$%^~`'\\", Class::symbol);
    set("\"", Class::quote);
    set("#", Class::hash);
    return classes;
}();

Class class_of(char c) { return kClasses[static_cast<unsigned char>(c)]; }
bool is_letter(char c) { return class_of(c) == Class::letter; }
bool is_digit(char c) { return class_of(c) == Class::digit; }
bool is_blank(char c) { return class_of(c) == Class::blank; }

/// The first `c` in [from, end), or `end`.
const char* next(const char* from, char c, const char* end) {
    const void* found = from < end ? std::memchr(from, c, static_cast<std::size_t>(end - from)) : nullptr;
    return found ? static_cast<const char*>(found) : end;
}

[[noreturn]] void fail(const Place& place, std::string_view what) {
    throw InputError(fmt::format("{}: {}", to_string(place), what));
}

}  // namespace

std::string describe(const Token& token) {
    switch (token.kind) {
        case Token::Kind::end: return "the end of the scene";
        case Token::Kind::number: return fmt::format("the number {}", token.number);
        case Token::Kind::string: return "a string";
        case Token::Kind::hash: return "a directive";
        case Token::Kind::symbol: break;
        default: return fmt::format("'{}'", token.text.substr(0, 60));
    }
    switch (token.symbol) {
        case 'l': return "'<='";
        case 'g': return "'>='";
        case 'n': return "'!='";
        default: return fmt::format("'{}'", token.symbol);
    }
}

void Scanner::skip_blanks() {
    const char* start = at_;
    skip_blanks_uncounted();
    walked_ += at_ - start;
}

void Scanner::skip_blanks_uncounted() {
    for (;;) {
        while (is_blank(*at_)) ++at_;
        if (*at_ == '\0' && at_ < end_) {  // POV-Ray passes over NUL bytes, too
            ++at_;
        } else if (at_[0] == '/' && at_[1] == '/') {
            while (at_ < end_ && *at_ != '\n' && *at_ != '\r') ++at_;  // old Macs end lines by \r alone
        } else if (at_[0] == '/' && at_[1] == '*') {
            const Place opened = place();
            int depth = 0;  // comments nest
            do {
                if (at_ >= end_) fail(opened, "this comment never ends; close it with */");
                if (at_[0] == '/' && at_[1] == '*') {
                    ++depth;
                    at_ += 2;
                } else if (at_[0] == '*' && at_[1] == '/') {
                    --depth;
                    at_ += 2;
                } else {
                    ++at_;
                }
            } while (depth > 0);
        } else {
            return;
        }
    }
}

void Scanner::scan(Names& names, Token& token) {
    token.value = nullptr;
    token.array = nullptr;
    for (;;) {
        while (is_blank(*at_)) ++at_;
        if (*at_ == '/' || *at_ == '\0') skip_blanks();
        token.place = place();
        if (at_ >= end_) {
            token.kind = Token::Kind::end;
            return;
        }
        const char c = *at_;
        switch (class_of(c)) {
            case Class::digit: return scan_number(token);
            case Class::letter: return scan_name(token, names);
            case Class::quote: return scan_string(token);
            case Class::hash:
                ++at_;
                token.kind = Token::Kind::hash;
                return;
            case Class::symbol:
                if (c == '.' && is_digit(at_[1])) return scan_number(token);
                token.kind = Token::Kind::symbol;
                token.symbol = c;
                ++at_;
                if (*at_ == '=' && (c == '<' || c == '>' || c == '!')) {
                    token.symbol = c == '<' ? 'l' : c == '>' ? 'g' : 'n';
                    ++at_;
                }
                return;
            default: break;
        }
        // A byte order mark in front of the text is no character of it.
        if (at_ != source_->begin() || std::strncmp(at_, "\xEF\xBB\xBF", 3) != 0) {
            fail(token.place, fmt::format("byte {:#04x} is no character of the language; is this a text file?",
                                          static_cast<unsigned char>(c)));
        }
        at_ += 3;
    }
}

void Scanner::scan_repeated(Scanned& scanned, Token& token) {
    if (!scanned.remembered) scanned.remembered = nothing_remembered<Scanned::Remembered>();
    auto& known = scanned.remembered[reinterpret_cast<std::uintptr_t>(at_) % Scanned::kRemembered];
    if (known.from != at_) {
        const char* from = at_;
        scan(scanned.names, token);
        known = {from, at_, token};
        return;
    }
    token = known.token;
    at_ = known.to;
}

/// Up to 15 digits with a point among them and no exponent: an integer below 2^53 divided by a power of ten that is
/// exact, too, so the quotient is the nearest double (Clinger 1990).
bool Scanner::scan_short_number(Token& token) {
    static constexpr double kTens[] = {1,   1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                       1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const char* p = at_;
    std::uint64_t digits = 0;  // what does not fit is not used
    while (is_digit(*p)) digits = digits * 10 + static_cast<unsigned>(*p++ - '0');
    std::ptrdiff_t count = p - at_;
    std::ptrdiff_t after_point = 0;
    if (*p == '.') {
        const char* point = p++;
        while (is_digit(*p) && p - point < 16) digits = digits * 10 + static_cast<unsigned>(*p++ - '0');
        after_point = p - point - 1;
        count += after_point;
    }
    if (count > 15 || *p == 'e' || *p == 'E' || *p == '.' || is_digit(*p)) return false;
    token.number = static_cast<double>(digits) / kTens[after_point];
    token.text = {at_, static_cast<std::size_t>(p - at_)};
    at_ = p;
    return true;
}

void Scanner::scan_number(Token& token) {
    token.kind = Token::Kind::number;
    if (scan_short_number(token)) return;
    const auto [stop, error] = std::from_chars(at_, end_, token.number);
    if (error == std::errc::result_out_of_range) {
        token.number = std::strtod(std::string(at_, stop).c_str(), nullptr);  // too small is 0
        if (!std::isfinite(token.number)) fail(token.place, "this number is too large; stay below 1e308");
    }
    token.text = {at_, static_cast<std::size_t>(stop - at_)};
    at_ = stop;
    if (*at_ == '.' && is_digit(at_[1]) && token.text.find('.') != std::string_view::npos) {
        fail(token.place, "a number with two points; is a comma missing?");
    }
}

void Scanner::scan_string(Token& token) {
    token.kind = Token::Kind::string;
    const char* start = ++at_;
    const char* quote = next(start, '"', end_);
    for (const char* escape = start; (escape = next(escape, '\\', quote)) < quote;) {
        escape += 2;
        if (escape > quote) quote = next(escape, '"', end_);
    }
    if (quote == end_) fail(token.place, "this string never ends; close it with \"");
    token.text = {start, static_cast<std::size_t>(quote - start)};
    at_ = quote + 1;
}

void Scanner::scan_name(Token& token, Names& names) {
    const char* start = at_;
    std::uint32_t hash = Names::kHashStart;
    while (is_letter(*at_) || is_digit(*at_)) hash = Names::hash_step(hash, *at_++);
    token.text = {start, static_cast<std::size_t>(at_ - start)};
    if (token.text.size() > 1000) fail(token.place, "this name has more than 1000 letters; shorten it");
    token.name = names.intern(token.text, hash);
    token.kind = Token::Kind::name;
    if (names.is_reserved(token.name)) {
        token.kind = Token::Kind::word;
        token.word = names.word_of(token.name);
    }
}

Word Scanner::directive_word(Names& names) {
    skip_blanks();
    if (!is_letter(*at_)) return Word::other_;
    const char* start = at_;
    Token token;
    scan_name(token, names);
    if (token.kind == Token::Kind::word) return token.word;
    at_ = start;
    return Word::other_;
}

Word Scanner::directive_word_repeated(Scanned& scanned) {
    const char* start = at_;
    Token token;
    scan_repeated(scanned, token);
    if (token.kind == Token::Kind::word) return token.word;
    at_ = start;
    return directive_word(scanned.names);
}

Word Scanner::skip_block_repeated(Scanned& scanned, int levels, bool at_else, Place opened) {
    if (!scanned.skipped) scanned.skipped = nothing_remembered<Scanned::Skipped>();
    auto& known = scanned.skipped[reinterpret_cast<std::uintptr_t>(at_) % Scanned::kRemembered];
    if (known.from != at_) {
        const char* from = at_;
        const Word word = skip_block(scanned.names, levels, at_else, opened);
        known = {from, at_, word};
    }
    at_ = known.to;
    return known.word;
}

Word Scanner::skip_block(Names& names, int levels, bool at_else, Place opened) {
    for (;;) {
        // Walk to the next '#' outside of strings and comments.
        const std::size_t plain = std::strcspn(at_, "#\"/");
        at_ += plain;
        if (at_ >= end_) fail(opened, "this block never ends; close it with #end");
        if (*at_ == '\0') {
            ++at_;
        } else if (*at_ == '"') {
            Token ignored;
            ignored.place = place();
            scan_string(ignored);
        } else if (*at_ == '/') {
            const char* before = at_;
            skip_blanks();
            if (at_ == before) ++at_;
        } else {
            ++at_;
            switch (const Word word = directive_word(names)) {
                case Word::if_:
                case Word::ifdef_:
                case Word::ifndef_:
                case Word::while_:
                case Word::for_:
                case Word::switch_:
                case Word::macro_: ++levels; break;
                case Word::else_:
                case Word::elseif_:
                case Word::case_:
                case Word::range_:
                    if (at_else && levels == 1) return word;
                    break;
                case Word::end_:
                    if (--levels == 0) return word;
                    break;
                default: break;
            }
        }
    }
}

}  // namespace rays::sdl
