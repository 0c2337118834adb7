#include "scene_reader/interpreter.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace rays::sdl {

Interpreter::Interpreter(Sources& sources, const Source& scene, const ReadOptions& options, Budget& budget)
    : sources_(sources),
      options_(options),
      budget_(budget),
      scanned_(*budget.scanned),
      names_(scanned_.names),
      scopes_(1) {
    scanner_.move_to(&scene, scene.begin());
    if (budget_.can_grow) budget_.work += kWorkPerByte * static_cast<std::int64_t>(scene.text.size());
    predeclare("Raysteps", 1);
    time_.slot = predeclare("Time", 0);
    wavelength_.slot = predeclare("Wavelength", 380);  // the first of the table (tabulate.cpp)
    predeclare("frame_number", options.frame_number);
    predeclare("image_width", options.raster.width);
    predeclare("image_height", options.raster.height);
    for (const auto& [name, value] : options.declared) {
        const Value* slot = predeclare(name, value);
        if (slot == time_.slot) time_.slot = nullptr;
        if (slot == wavelength_.slot) wavelength_.slot = nullptr;
    }
}

void Interpreter::fetch() {
    Token& token = peeked_;
    for (;;) {
        ++tokens_;
        const char* before = scanner_.at();
        if (repeats())
            scanner_.scan_repeated(scanned_, token);
        else
            scanner_.scan(names_, token);
        spend(1 + (scanner_.at() - before + scanner_.take_walked()) / kBytesPerWork);
        switch (token.kind) {
            case Token::Kind::name:
                resolve(token);
                if (token.kind != Token::Kind::value) return;
                if (const auto* macro = token.value->as<Shared<Macro>>()) {
                    if (hold_ || left_side_) {
                        token.kind = Token::Kind::macro;
                        return;
                    }
                    const Shared<Macro> kept = *macro;
                    call_macro(kept, Place(token.place));
                    continue;
                }
                return;
            case Token::Kind::end:
                if (files_.empty()) {
                    if (!blocks_.empty()) fail(blocks_.back().opened, "this block never ends; close it with #end");
                    return;
                }
                end_of_source();
                continue;
            case Token::Kind::hash:
                if (!blocks_.empty() && blocks_.back().kind == Block::Kind::macro &&
                    blocks_.back().macro->body_end == token.place.at) {
                    return_from_macro();
                    continue;
                }
                if (hold_) return;
                directive();
                // A declaration looks one token ahead for a further layer or a semicolon.
                while (has_peeked_) {
                    has_peeked_ = false;
                    if (peeked_.kind == Token::Kind::hash) {
                        directive();
                    } else if (peeked_.kind == Token::Kind::macro) {
                        const Shared<Macro> kept = peeked_.value->shared<Macro>();
                        call_macro(kept, peeked_.place);
                    } else {
                        return;
                    }
                }
                continue;
            default: return;
        }
    }
}

void Interpreter::resolve(Token& token) {
    if (token.name >= bindings_.size() || bindings_[token.name].empty()) return;
    Binding& binding = bindings_[token.name].back();
    token.kind = Token::Kind::value;
    token.scope = binding.scope;
    token.value = binding.slot.get();
    while (const auto* reference = token.value->as<Reference>()) token.value = reference->target.get();
    if (!left_side_) {  // a macro's parameter may have the name as well
        if (token.value == time_.slot) time_.used = true;
        if (token.value == wavelength_.slot) wavelength_.used = true;
    }
    while (token.value->as<std::shared_ptr<Array>>() && scanner_.next_is('[')) {
        Token element = token;  // the subscripts' tokens take this one's place meanwhile
        subscripts(element);
        token = element;
        has_peeked_ = false;
    }
}

void Interpreter::subscripts(Token& token) {
    // The array must outlive the evaluation of its subscripts, which may do anything.
    const std::shared_ptr<Array> array = *token.value->as<std::shared_ptr<Array>>();
    const bool left_side = std::exchange(left_side_, false);
    std::size_t element = 0;
    for (std::size_t size : array->sizes) {
        expect('[', "an array element");
        const Place place = peek().place;
        const double subscript = number();
        if (!(subscript > -0.5) || !(subscript + 1e-10 < static_cast<double>(size))) {
            fail(place, fmt::format("subscript {} of an array of {} elements; count from 0", subscript, size));
        }
        element = element * size + static_cast<std::size_t>(std::max(subscript + 1e-10, 0.0));
        expect(']', "an array element");
    }
    left_side_ = left_side;
    token.array = array.get();
    token.value = &array->elements[element];
    if (token.value->empty() && !left_side_) {
        fail(token, fmt::format("this element of '{}' has no value yet; declare it first", token.text));
    }
}

Word Interpreter::skip_block(int levels, bool at_else, Place opened) {
    const char* start = scanner_.at();
    const Word word = repeats() ? scanner_.skip_block_repeated(scanned_, levels, at_else, opened)
                                : scanner_.skip_block(names_, levels, at_else, opened);
    spend((scanner_.at() - start) / kBytesPerWork);
    return word;
}

void Interpreter::expect(char symbol, std::string_view where) {
    if (!accept(symbol)) unexpected(fmt::format("'{}' in {}", symbol, where));
}

void Interpreter::unexpected(std::string_view wanted) {
    const Token token = peek();
    if (token.kind == Token::Kind::word && token.word == Word::other_) {
        fail(token,
             fmt::format("'{}' is not in the subset that Raysteps reads; here {} can stand (see scenes/README.md)",
                         token.text, wanted));
    }
    if (token.kind == Token::Kind::name) {
        fail(token,
             fmt::format("'{}' is neither a word of the language nor declared; expected {}", token.text, wanted));
    }
    if (token.kind == Token::Kind::value) wrong_value(token, wanted);
    fail(token, fmt::format("found {}; expected {}", describe(token), wanted));
}

void Interpreter::wrong_value(const Token& token, std::string_view wanted) const {
    if (const auto unusable = token.value->shared<Unusable>()) {
        if (library_values_ > 0) throw LibraryFailure{unusable};  // the first cause is the one to tell
        fail(token, fmt::format("'{}' holds what is not in the subset that Raysteps reads ({}: {}); here {} can stand",
                                token.text, to_string(unusable->place), unusable->why, wanted));
    }
    fail(token, fmt::format("'{}' is {}; expected {}", token.text, kind_name(*token.value), wanted));
}

namespace {

/// A scene's text may hold anything; messages hold nothing that moves a terminal's cursor.
std::string printable(std::string text) {
    for (char& c : text) {
        if ((static_cast<unsigned char>(c) < 32 && c != '\n') || c == 127) c = '?';
    }
    return text;
}

}  // namespace

void Interpreter::fail(const Place& place, std::string_view what) const {
    if (library_values_ > 0) throw LibraryFailure{std::make_shared<Unusable>(Unusable{place, std::string(what)})};
    std::string message = fmt::format("{}: {}", to_string(place), what);
    int shown = 0;
    for (auto block = blocks_.rbegin(); block != blocks_.rend() && shown < 3; ++block) {
        if (block->kind != Block::Kind::macro) continue;
        message += fmt::format("\n  in macro {}, called at {}", block->macro->name, to_string(block->opened));
        ++shown;
    }
    throw InputError(printable(std::move(message)));
}

void Interpreter::note(const Place& place, std::string_view what) {
    if (notes_.size() > kMostNotes || std::find(noted_.begin(), noted_.end(), place.at) != noted_.end()) return;
    noted_.push_back(place.at);
    if (notes_.size() == kMostNotes) {
        notes_.emplace_back("further notes are left out");
        return;
    }
    notes_.push_back(printable(fmt::format("{}: {}", to_string(place), what)));
}

void Interpreter::object_made(const Place& place) {
    buy_work(kWorkOfPlainSphere);
    if (++budget_.objects > kMostObjects) {
        fail(place, fmt::format("the scene has more than {} objects; use a mesh", kMostObjects));
    }
}

void Interpreter::too_deep() {
    depth_ = 0;
    fail(scanner_.place(), fmt::format("more than {} levels of nesting; flatten the scene", kDeepestNesting));
}

void Interpreter::out_of_work() {
    budget_.work = 0;
    fail(scanner_.place(), "reading this scene takes too long; does a loop or a macro go on for ever?");
}

void Interpreter::out_of_memory() {
    fail(scanner_.place(),
         "this scene needs too much memory; use a mesh, share textures, or end the loop that fills it");
}

}  // namespace rays::sdl
