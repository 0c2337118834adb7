// The smallest pieces of a scene's text.
#pragma once

#include <cstdlib>
#include <memory>
#include <new>
#include <string_view>
#include <type_traits>
#include <utility>

#include "scene_reader/formula.h"
#include "scene_reader/value.h"

namespace rays::sdl {

struct Token {
    enum class Kind : std::uint8_t {
        end,     ///< of the scene's text
        number,  ///< a literal; its value in `number`
        string,  ///< a literal; its characters, escapes untouched, in `text`
        word,    ///< reserved; which, in `word`
        name,    ///< bound to nothing yet
        value,   ///< a name, or an element of an array, that stands for `*value`
        symbol,  ///< punctuation; <=, >= and != are 'l', 'g' and 'n'
        hash,    ///< a directive that must wait (see Interpreter::hold_)
        macro,   ///< a macro call that must wait
    };
    Kind kind = Kind::end;
    char symbol = 0;
    Word word = Word::other_;
    NameId name = 0;
    double number = 0;
    Value* value = nullptr;  ///< valid until the next token is fetched
    Array* array = nullptr;  ///< whose element `value` is
    std::size_t scope = 0;   ///< where the name is bound
    std::string_view text;
    Place place;

    bool is(char s) const { return kind == Kind::symbol && symbol == s; }
    bool is(Word w) const { return kind == Kind::word && word == w; }
};

/// How a message calls it: "'sphere'", "the number 3", "the end of the scene".
std::string describe(const Token& token);

/// What all readings of a text share: the numbers of its names, and tokens by their place.
struct Scanned {
    Names names;

    /// What stands in the text from `from` on. Texts do not change, so it stays true.
    struct Remembered {
        const char* from = nullptr;
        const char* to = nullptr;
        Token token;
    };
    static constexpr std::size_t kRemembered = 4096;  ///< a body of so many bytes is remembered whole
    struct Free {
        void operator()(void* p) const { std::free(p); }
    };
    /// By the last bits of `from`; none until something repeats. From calloc: of a short body few pages are ever
    /// touched.
    std::unique_ptr<Remembered[], Free> remembered;

    /// Where a block that is not executed ends that begins at `from`.
    struct Skipped {
        const char* from = nullptr;
        const char* to = nullptr;
        Word word = Word::other_;
    };
    std::unique_ptr<Skipped[], Free> skipped;

    /// What is known of the expression that stands at `from`, by the same bits.
    struct Known {
        const char* from = nullptr;
        const Formula* formula = nullptr;
        Expression::Rule rule = Expression::Rule::sum;
        std::uint8_t wanted = 0;
        std::uint8_t failures = 0;  ///< names stood for something else, or there was an error
    };
    std::unique_ptr<Known[], Free> known;
    std::vector<std::unique_ptr<const Formula>> formulas;
};

/// A table all bytes of which are 0: no place in any text.
template <class T>
std::unique_ptr<T[], Scanned::Free> nothing_remembered() {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
    void* bytes = std::calloc(Scanned::kRemembered, sizeof(T));
    if (!bytes) throw std::bad_alloc();
    return std::unique_ptr<T[], Scanned::Free>(static_cast<T*>(bytes));
}

/// Scans numbers, names, strings and punctuation; knows nothing of what they mean.
class Scanner {
public:
    void move_to(const Source* source, const char* at) {
        source_ = source;
        at_ = at;
        end_ = source->end();
    }
    const Source* source() const { return source_; }
    const char* at() const { return at_; }
    Place place() const { return {source_, at_}; }

    /// The next token; a '#' is left to the caller, who sees kind hash. End of text is kind end.
    void scan(Names& names, Token& token);
    /// The same, for text that is read time and again, as loops and macros are: what was scanned is remembered by its
    /// place.
    void scan_repeated(Scanned& scanned, Token& token);
    Token scan(Names& names) {
        Token token;
        scan(names, token);
        return token;
    }
    /// True when the next thing but blanks and comments is `c`. Nothing is consumed but blanks.
    bool next_is(char c) {
        skip_blanks();
        return *at_ == c;
    }
    const char* end() const { return end_; }
    /// Bytes of blanks and comments walked over since the last call: a loop pays for them each time round.
    std::int64_t take_walked() { return std::exchange(walked_, 0); }

    /// After a '#': the directive's word, or other_ when there is none.
    Word directive_word(Names& names);
    Word directive_word_repeated(Scanned& scanned);

    /// Where a block that is not executed stops: after the word of the #else, #elseif, #case, #range or #end that
    /// belongs to `levels` blocks up (1: the innermost). Stops at #else and its kin only when `at_else` and levels
    /// is 1. Throws InputError at the end of the text; `opened` is named in it.
    Word skip_block(Names& names, int levels, bool at_else, Place opened);
    Word skip_block_repeated(Scanned& scanned, int levels, bool at_else, Place opened);

private:
    void skip_blanks();
    void skip_blanks_uncounted();
    bool scan_short_number(Token& token);
    void scan_number(Token& token);
    void scan_string(Token& token);
    void scan_name(Token& token, Names& names);

    const Source* source_ = nullptr;
    const char* at_ = nullptr;
    const char* end_ = nullptr;
    std::int64_t walked_ = 0;
};

}  // namespace rays::sdl
