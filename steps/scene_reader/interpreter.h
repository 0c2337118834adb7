// The language without its objects: directives, variables, macros, expressions.
//
// Reading is one pass over text in memory. Whoever parses a statement asks for tokens; directives are obeyed, macros
// entered and loops turned while a token is fetched, so that they may stand anywhere. What repeats, in
// loops and macros, is remembered by its place: tokens, the ends of skipped blocks, and expressions as formulas.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/gamma.h"
#include "core/material.h"
#include "core/shapes.h"
#include "scene_reader/limits.h"
#include "scene_reader/scene_reader.h"
#include "scene_reader/token.h"

namespace rays::sdl {

/// What several readings of one scene share: the text, and how much work is left.
struct Budget {
    std::int64_t work = kIdleWork;
    std::int64_t for_objects = kMostWorkForObjects;  ///< what objects can still buy
    bool can_grow = true;                            ///< the first reading: text and objects buy more work
    std::int64_t memory_limit = kMostMemory;
    std::int64_t memory = kMostMemory;  ///< left
    std::size_t objects = 0;
    std::shared_ptr<Scanned> scanned = std::make_shared<Scanned>();
};

class Interpreter {
public:
    Interpreter(Sources& sources, const Source& scene, const ReadOptions& options, Budget& budget);

    /// Reads what only the scene's own grammar knows after `#declare X =` (texture, object, ...): true when the next
    /// token begins such a thing.
    std::function<bool(Value&)> read_thing;
    /// `#default { ... }`.
    std::function<void()> read_default;

    // ---- tokens
    // ------------------------------------------------------------------------------------------------------
    const Token& peek() {
        if (!has_peeked_) {
            fetch();
            has_peeked_ = true;
        }
        return peeked_;
    }
    Token take() {
        peek();
        has_peeked_ = false;
        return peeked_;
    }
    bool accept(char symbol) { return peek().is(symbol) && (has_peeked_ = false, true); }
    bool accept(Word word) { return peek().is(word) && (has_peeked_ = false, true); }
    /// A word that only Raysteps knows, and only in this place: everywhere else it is a name like any other.
    bool accept_own(std::string_view word) {
        const Token& next = peek();
        const bool is_name = next.kind == Token::Kind::name || next.kind == Token::Kind::value;
        return is_name && next.text == word && (has_peeked_ = false, true);
    }
    /// `where` is what the symbol belongs to: "a sphere".
    void expect(char symbol, std::string_view where);
    void comma() { accept(','); }
    /// The thing of kind Shared<T> that the next token names, which is then consumed; else null.
    template <class T>
    Shared<T> accept_named() {
        if (peek().kind != Token::Kind::value) return nullptr;
        Shared<T> thing = peek().value->shared<T>();
        if (thing) has_peeked_ = false;
        return thing;
    }

    // ---- expressions
    // -------------------------------------------------------------------------------------------------
    bool number_follows();  ///< a float expression may begin here
    bool vector_follows();  ///< any expression of floats
    bool color_follows();   ///< the same, or a colour's keyword
    double number();
    double number_or(double otherwise) { return number_follows() ? number() : otherwise; }
    bool flag() { return number_or(1) > 0; }  ///< `hollow`, `hollow on`, `hollow 0`
    /// Truncated. Throws outside of [least, most]; `what` names it.
    int integer(std::string_view what, int least, int most);
    std::size_t count(std::string_view what, std::size_t most);
    V2 vector2();
    V3 vector();
    Color color();   ///< five components
    Radiance rgb();  ///< three
    std::string string();
    bool string_follows();

    // ---- messages
    // ----------------------------------------------------------------------------------------------------
    [[noreturn]] void fail(const Place& place, std::string_view what) const;
    [[noreturn]] void fail(const Token& token, std::string_view what) const { fail(token.place, what); }
    /// The next token is not what is wanted.
    [[noreturn]] void unexpected(std::string_view wanted);
    [[noreturn]] void wrong_value(const Token& token, std::string_view wanted) const;  ///< a name of something else
    void note(const Place& place, std::string_view what);
    std::vector<std::string>& notes() { return notes_; }

    /// One level of nesting of the text, and so of the stack.
    class Nesting {
    public:
        explicit Nesting(Interpreter& in) : in_(in) {
            if (++in_.depth_ > kDeepestNesting) in_.too_deep();
        }
        ~Nesting() { --in_.depth_; }
        Nesting(const Nesting&) = delete;

    private:
        Interpreter& in_;
    };

    /// Called for every object made: it buys work, within limits.
    void object_made(const Place& place);
    /// The same for a face of a mesh, which costs less.
    void face_made() {
        buy_work(0);
        spend(kWorkOfFace);
        hold(2 * sizeof(Mesh::Face));
    }
    /// A cost that is not a token.
    void spend(std::int64_t work) {
        if ((budget_.work -= work) < 0) out_of_work();
    }

    /// Memory that stays until the scene is read.
    void hold(std::size_t bytes) {
        if ((budget_.memory -= static_cast<std::int64_t>(bytes)) < 0) out_of_memory();
        spend(static_cast<std::int64_t>(bytes) / kHeldBytesPerWork);
    }

    std::size_t memory_left() const { return static_cast<std::size_t>(std::max<std::int64_t>(budget_.memory, 0)); }

    Gamma gamma;  ///< so far; for colours stated as sRGB

    Sources& sources() { return sources_; }
    double version() const { return version_; }
    /// Is the scene one of a POV-Ray before 3.7? As POV-Ray has it, one that states no version is.
    bool is_legacy() const { return !version_said_ || std::lround(100 * version_) < 370; }
    /// Was the variable looked at, while it was the predeclared one?
    bool used_time() const { return time_.used; }
    bool used_wavelength() const { return wavelength_.used; }

private:
    void buy_work(std::int64_t at_least) {
        if (!budget_.can_grow) return;
        const std::int64_t bought = std::min(budget_.for_objects, kWorkPerObject);
        budget_.for_objects -= bought;
        budget_.work += std::max(bought, at_least);
    }

    /// In a loop or a macro, or read once more: what stands here is read time and again, as far as one knows.
    bool repeats() const { return !blocks_.empty() || !budget_.can_grow; }

    // tokens (interpreter.cpp)
    void fetch();  ///< into peeked_
    Word skip_block(int levels, bool at_else, Place opened);
    void resolve(Token& token);
    void subscripts(Token& token);
    [[noreturn]] void too_deep();
    [[noreturn]] void out_of_work();
    [[noreturn]] void out_of_memory();

    // directives (directives.cpp)
    void directive();
    void if_directive(bool condition, Place opened);
    void else_directive(Place place);
    void end_directive(Place place);
    void while_directive(Place opened);
    void for_directive(Place opened);
    void switch_directive(Place opened);
    void break_directive(Place place);
    void include_directive(Place place);
    void version_directive(Place place);
    void undef_directive(Place place);
    void message_directive(Word word, Place place);
    void end_of_source();
    double condition();
    bool is_declared();
    bool case_matches(Word word, double value);
    bool turn_while(std::size_t block);
    bool is_endless(Place opened);

    // variables (variables.cpp)
    struct Binding {
        std::size_t scope = 0;
        std::shared_ptr<Value> slot;
    };
    std::vector<Binding>& bindings(NameId name) {
        if (name >= bindings_.size()) bindings_.resize(name + 64);
        return bindings_[name];
    }
    const Value* predeclare(std::string_view name, double value);
    std::shared_ptr<Value> bind(NameId name, std::size_t scope);
    void leave_scope();
    void declare(bool local, Place place);
    std::shared_ptr<Value> assignable(const Token& token, bool local);
    /// The right side of an assignment, or a macro's argument (then `as_argument`, and variables go by reference).
    Value right_side(bool as_argument, std::size_t caller_scope, bool needs_semicolon);
    /// The right side of a declaration. Of textures over one another the uppermost counts, when it is opaque.
    Value declared_value();
    /// What fail() throws while a library's value is read: nobody may ever want it as a message.
    struct LibraryFailure {
        Shared<Unusable> unusable;
    };
    /// The same in one of POV-Ray's include files: what is not in the subset becomes unusable, and is skipped.
    Value library_value();
    void skip_value();  ///< up to the brace that closes it, or to a ';' or '#' before any
    Value array_literal();
    void array_elements(Array& array, std::size_t dimension, std::size_t first);
    Value function_definition();

    // macros (macros.cpp)
    void define_macro(Place place);
    void call_macro(const Shared<Macro>& called, Place place);
    void return_from_macro();
    void capture(Function& function, const Token& name);
    double call_function(const Function& function, Place place);

    // worked_out.cpp
    bool worked_out(Expression::Rule rule, int wanted, Numbers& result);
    const Formula* make_formula(Expression::Rule rule, int wanted, const char* at);
    bool evaluate(const Formula& formula, Numbers& result);
    const Value* value_of(NameId name) const;

    // expressions (expressions.cpp, functions.cpp)
    Numbers expression(int wanted);
    Numbers comparison(int wanted);
    Numbers logical(int wanted);
    Numbers sum(int wanted);
    Numbers product(int wanted);
    Numbers factor(int wanted);
    Numbers primary(int wanted);
    Numbers in_parentheses(int wanted);
    void choose(Numbers& condition, int wanted);
    Numbers value_of(const Token& token, int wanted);
    bool parameter(NameId name, double& result) const;
    void component(Numbers& numbers);
    Numbers angle_brackets();
    double string_comparison();
    bool float_function(Word word, const Place& place, double& result);
    bool vector_function(Word word, const Place& place, V3& result);
    double extreme(bool largest);
    double bits(Word word);
    double select();
    double random(const Place& place);
    double dimension(Word word);
    double argument();
    void two_arguments(double& a, double& b);
    double checked(double value, const Place& place);

    // strings.cpp, colors.cpp
    std::string string_made_by(const Token& token);
    bool string_function(Word word, const Place& place, double& result);
    Color color_components(int wanted);
    void color_keyword(Word word, Color& color);

    struct Block {
        enum class Kind : std::uint8_t { if_, while_, for_, switch_, macro };
        Kind kind = Kind::if_;
        Place opened;
        const char* again = nullptr;  ///< while: its condition; for: its body
        double switch_value = 0;
        NameId variable = 0;
        double last = 0, step = 0;
        std::int64_t changes = 0;  ///< of variables, when the turn began: a turn without any goes on for ever
        Shared<Macro> macro;
        Place come_back;
    };
    /// The function being evaluated: x, y and z are its arguments there, not the unit vectors.
    struct Parameters {
        const Function* function = nullptr;
        std::vector<double> values;
    };
    struct File {
        Place come_back;
        std::size_t blocks = 0;  ///< open when the file was entered
    };

    Sources& sources_;
    ReadOptions options_;
    Budget& budget_;
    Scanned& scanned_;
    Names& names_;
    Scanner scanner_;
    Token peeked_;
    bool has_peeked_ = false;
    /// Directives and macro calls wait: a statement looks one token ahead, and what comes next is not its business.
    bool hold_ = false;
    bool left_side_ = false;  ///< elements that have no value yet may be named
    int depth_ = 0;
    std::int64_t tokens_ = 0;
    std::int64_t changes_ = 0;
    std::vector<Block> blocks_;
    std::vector<File> files_;
    std::vector<std::vector<Binding>> bindings_;  ///< by name, innermost scope last
    std::vector<std::vector<NameId>> scopes_;     ///< the names bound in each; scope 0 is global
    Parameters parameters_;
    std::vector<std::uint32_t> random_;  ///< rand()'s streams
    double version_ = 3.7;
    bool version_said_ = false;
    std::vector<std::string> notes_;
    std::vector<const char*> noted_;  ///< where; a loop passes the same place often
    struct Watched {
        const Value* slot = nullptr;
        bool used = false;
    };
    Watched time_, wavelength_;
    int library_values_ = 0;  ///< being read, inside of one another
};

}  // namespace rays::sdl
