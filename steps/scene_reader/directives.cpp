// What begins with '#'. The '#' itself is behind the scanner; a directive leaves nothing peeked, but for declarations.
#include <fmt/format.h>
#include <fmt/printf.h>

#include <cmath>

#include "scene_reader/interpreter.h"

namespace rays::sdl {

void Interpreter::directive() {
    const Place place{scanner_.source(), scanner_.at() - 1};
    spend(kWorkOfDirective);
    switch (const Word word = repeats() ? scanner_.directive_word_repeated(scanned_) : scanner_.directive_word(names_)) {
        case Word::declare_: return declare(false, place);
        case Word::local_: return declare(true, place);
        case Word::undef_: return undef_directive(place);
        case Word::if_: return if_directive(std::abs(condition()) > kEpsilon, place);
        case Word::ifdef_: return if_directive(is_declared(), place);
        case Word::ifndef_: return if_directive(!is_declared(), place);
        case Word::else_:
        case Word::elseif_: return else_directive(place);
        case Word::end_: return end_directive(place);
        case Word::while_: return while_directive(place);
        case Word::for_: return for_directive(place);
        case Word::switch_: return switch_directive(place);
        case Word::case_:
        case Word::range_:
            // Falling into the next case: its value no longer matters.
            if (blocks_.empty() || blocks_.back().kind != Block::Kind::switch_) {
                fail(place, "#case or #range outside of a #switch");
            }
            static_cast<void>(case_matches(word, 0));
            return;
        case Word::break_: return break_directive(place);
        case Word::macro_: return define_macro(place);
        case Word::include_: return include_directive(place);
        case Word::version_: return version_directive(place);
        case Word::default_:
            if (read_default) read_default();
            return;
        case Word::error_:
        case Word::warning_:
        case Word::debug_:
        case Word::render_:
        case Word::statistics_: return message_directive(word, place);
        default: break;
    }
    Token found = scanner_.scan(names_);
    fail(place,
         fmt::format("#{} is not in the subset that Raysteps reads; known are #version #declare #local #undef #if "
                     "#ifdef #ifndef #elseif #else #end #switch #case #range #break #while #for #macro #include "
                     "#default #error #warning #debug",
                     found.text.substr(0, 40)));
}

/// Ends with its parenthesis, so nothing behind it is looked at: macros within may be called at once.
double Interpreter::condition() {
    const bool outer_hold = std::exchange(hold_, false);
    const double value = argument();
    hold_ = outer_hold;
    return value;
}

bool Interpreter::is_declared() {
    // A token cannot be fetched: an array's element would be looked up, a macro called.
    if (!scanner_.next_is('(')) fail(scanner_.place(), "expected '(' and a name");
    scanner_.scan(names_);
    Token name = scanner_.scan(names_);
    bool declared = false;
    if (name.kind == Token::Kind::name) {
        const auto& known = bindings(name.name);
        declared = !known.empty();
        if (declared && scanner_.next_is('[')) {
            left_side_ = true;
            resolve(name);
            left_side_ = false;
            declared = !name.value->empty();
        }
    } else if (name.kind != Token::Kind::word) {
        fail(name, fmt::format("found {}; expected a name", describe(name)));
    }
    expect(')', "#ifdef");
    return declared;
}

void Interpreter::if_directive(bool condition_holds, Place opened) {
    for (;;) {
        if (condition_holds) break;
        const Word word = skip_block(1, true, opened);
        if (word == Word::end_) return;
        if (word == Word::else_) break;
        if (word != Word::elseif_) fail(scanner_.place(), "#case or #range outside of a #switch");
        condition_holds = std::abs(condition()) > kEpsilon;
    }
    if (blocks_.size() >= kMostOpenBlocks) too_deep();
    Block block;
    block.kind = Block::Kind::if_;
    block.opened = opened;
    blocks_.push_back(block);
}

void Interpreter::else_directive(Place place) {
    if (blocks_.empty() || (blocks_.back().kind != Block::Kind::if_ && blocks_.back().kind != Block::Kind::switch_)) {
        fail(place, "#else without an #if");
    }
    skip_block(1, false, place);
    blocks_.pop_back();
}

bool Interpreter::case_matches(Word word, double value) {
    const bool outer_hold = std::exchange(hold_, false);
    bool matches = false;
    if (word == Word::case_) {
        matches = std::abs(argument() - value) < kEpsilon;
    } else {
        double low = 0, high = 0;
        two_arguments(low, high);
        matches = low <= value && value <= high;
    }
    hold_ = outer_hold;
    return matches;
}

void Interpreter::switch_directive(Place opened) {
    Block block;
    block.kind = Block::Kind::switch_;
    block.opened = opened;
    block.switch_value = condition();
    if (blocks_.size() >= kMostOpenBlocks) too_deep();
    for (;;) {
        const Word word = skip_block(1, true, opened);
        if (word == Word::end_) return;
        if (word == Word::elseif_) fail(scanner_.place(), "#elseif inside of a #switch");
        if (word == Word::else_ || case_matches(word, block.switch_value)) break;
    }
    blocks_.push_back(block);
}

void Interpreter::include_directive(Place place) {
    const std::string name = string();
    if (files_.size() >= kDeepestInclude) {
        fail(place, fmt::format("more than {} include files inside of one another; does a file include itself?",
                                kDeepestInclude));
    }
    const Source* source = nullptr;
    try {
        source = sources_.find_include(name);
    } catch (const InputError& error) {
        fail(place, fmt::format("include file {}", error.what()));
    }
    if (!source) {
        fail(place,
             fmt::format("include file '{}' is neither in the scene's folder nor in POV-Ray's include folder", name));
    }
    spend(kWorkOfFileSearch);
    files_.push_back({scanner_.place(), blocks_.size()});
    scopes_.emplace_back();
    scanner_.move_to(source, source->begin());
}

void Interpreter::end_of_source() {
    if (blocks_.size() > files_.back().blocks) {
        fail(blocks_.back().opened, "this block is still open at the end of the include file; close it with #end");
    }
    const Place back = files_.back().come_back;
    files_.pop_back();
    leave_scope();
    scanner_.move_to(back.source, back.at);
}

void Interpreter::version_directive(Place place) {
    const bool outer_hold = std::exchange(hold_, true);
    if (peek().text == "unofficial") take();
    version_ = number();
    version_said_ = true;
    accept(';');
    hold_ = outer_hold;
    if (!(version_ >= 1 && version_ < 3.705)) {
        fail(place, fmt::format("version {} is not known; Raysteps reads the language of POV-Ray 3.7", version_));
    }
}

void Interpreter::undef_directive(Place place) {
    const bool outer_hold = std::exchange(hold_, true);
    left_side_ = true;
    const Token name = take();
    left_side_ = false;
    hold_ = outer_hold;
    ++changes_;
    if (name.kind == Token::Kind::name) {
        note(place, fmt::format("#undef of '{}', which is not declared", name.text));
    } else if (name.array) {
        *name.value = Value{};
    } else if (name.kind == Token::Kind::value || name.kind == Token::Kind::macro) {
        bindings_[name.name].pop_back();
    } else {
        fail(name, fmt::format("found {}; expected a name", describe(name)));
    }
}

void Interpreter::message_directive(Word word, Place place) {
    const std::string text = string().substr(0, 2000);
    if (word == Word::error_) fail(place, fmt::format("the scene stops here: {}", text));
    if (word == Word::warning_) note(place, fmt::format("the scene warns: {}", text));
    // #debug goes nowhere, unless somebody listens.
    if (word != Word::warning_ && options_.debug) options_.debug(text);
}

}  // namespace rays::sdl
