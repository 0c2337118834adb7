// Names and what they stand for: #declare, #local, scopes, arrays.
#include <fmt/format.h>

#include "scene_reader/drafts.h"
#include "scene_reader/interpreter.h"

namespace rays::sdl {

std::string kind_name(const Value& value) {
    static constexpr const char* kNames[] = {"undefined",  "a float",     "a string",    "an array",    "a macro",
                                             "a function", "a reference", "a transform", "a camera",    "an object",
                                             "a texture",  "a pigment",   "a finish",    "an interior", "a media",
                                             "a density",  "a material",  "unusable"};
    static_assert(std::size(kNames) == std::variant_size_v<decltype(Value::is)>);
    if (const auto* numbers = value.as<Numbers>()) {
        static constexpr const char* kSizes[] = {"a float", "a 2D vector", "a vector", "a 4D vector", "a color"};
        return kSizes[numbers->count - 1];
    }
    return kNames[value.is.index()];
}

const Value* Interpreter::predeclare(std::string_view name, double value) {
    const std::shared_ptr<Value> slot = bind(names_.intern(name), 0);
    Numbers number;
    number.at[0] = value;
    slot->is = number;
    return slot.get();
}

std::shared_ptr<Value> Interpreter::bind(NameId name, std::size_t scope) {
    auto& known = bindings(name);
    if (!known.empty() && known.back().scope == scope) return known.back().slot;
    known.push_back({scope, std::make_shared<Value>()});
    scopes_[scope].push_back(name);
    return known.back().slot;
}

void Interpreter::leave_scope() {
    const std::size_t scope = scopes_.size() - 1;
    for (NameId name : scopes_.back()) {
        auto& known = bindings_[name];
        if (!known.empty() && known.back().scope == scope) known.pop_back();
    }
    scopes_.pop_back();
}

std::shared_ptr<Value> Interpreter::assignable(const Token& token, bool local) {
    const std::size_t scope = local ? scopes_.size() - 1 : 0;
    switch (token.kind) {
        case Token::Kind::name: return bind(token.name, scope);
        case Token::Kind::macro:
        case Token::Kind::value:
            if (token.array) return {token.array->shared_from_this(), token.value};
            if (token.value->shared<Function>() && !(local && token.scope != scope)) {
                fail(token, fmt::format("'{}' is a function already; #undef it first", token.text));
            }
            if (local && token.scope != scope) return bind(token.name, scope);
            if (Reference* reference = bindings_[token.name].back().slot->as<Reference>()) return reference->target;
            return bindings_[token.name].back().slot;
        default: break;
    }
    if (token.kind == Token::Kind::word) {
        fail(token, fmt::format("'{}' is a reserved word; choose another name", token.text));
    }
    fail(token, fmt::format("found {}; expected a name to declare", describe(token)));
}

void Interpreter::declare(bool local, Place place) {
    const bool outer_hold = std::exchange(hold_, true);
    left_side_ = true;
    if (accept(Word::deprecated_)) {
        accept(Word::once_);
        string_follows() ? static_cast<void>(string()) : void();
    }
    const Token name = take();
    const std::shared_ptr<Value> slot = assignable(name, local);
    left_side_ = false;
    const bool is_element = name.array != nullptr;
    expect('=', "a declaration");
    hold_ = outer_hold;
    Value value = place.source->is_library ? library_value() : declared_value();
    if (is_element && !slot->empty() && slot->is.index() != value.is.index()) {
        fail(place,
             fmt::format("an array of {} cannot hold {}; declare another array", kind_name(*slot), kind_name(value)));
    }
    *slot = std::move(value);
    // From now on it is the scene's own variable.
    if (slot.get() == time_.slot) time_.slot = nullptr;
    if (slot.get() == wavelength_.slot) wavelength_.slot = nullptr;
    ++changes_;
    hold_ = true;
    accept(';');
    hold_ = outer_hold;
}

namespace {

/// What cannot be used is of any kind.
bool same_kind(const Value& a, const Value& b) {
    if (a.as<Shared<Unusable>>() || b.as<Shared<Unusable>>()) return true;
    if (a.is.index() != b.is.index()) return false;
    const auto* numbers = a.as<Numbers>();
    return !numbers || numbers->count == b.as<Numbers>()->count;
}

/// Elements in all, strings counted by their length.
std::size_t cost_of_copy(const Value& value) {
    if (const auto* text = value.as<std::string>()) return text->size() / sizeof(Value);
    const auto* array = value.as<std::shared_ptr<Array>>();
    if (!array) return 0;
    std::size_t cost = (*array)->elements.size();
    for (const Value& element : (*array)->elements) cost += cost_of_copy(element);
    return cost;
}

/// Assignment copies: arrays with all their elements.
Value copy_of(const Value& value) {
    Value copy = value;
    if (auto* array = copy.as<std::shared_ptr<Array>>()) {
        *array = std::make_shared<Array>(**array);
        for (Value& element : (*array)->elements) element = copy_of(element);
    }
    return copy;
}

/// Colours are kept in single precision, as POV-Ray keeps them.
Numbers rounded(Numbers color) {
    for (double& x : color.at) x = static_cast<float>(x);
    return color;
}

Numbers numbers_of(const Color& color) {
    Numbers numbers;
    numbers.count = 5;
    for (int i = 0; i < 3; ++i) numbers.at[i] = color.rgb[i];
    numbers.at[3] = color.filter;
    numbers.at[4] = color.transmit;
    return numbers;
}

}  // namespace

Value Interpreter::right_side(bool as_argument, std::size_t caller_scope, bool needs_semicolon) {
    const Nesting nesting(*this);
    const bool outer_hold = hold_;
    Value result;
    const auto semicolon = [&] {
        if (needs_semicolon && !accept(';')) {
            fail(peek(),
                 fmt::format("found {}; a declaration of a float, vector or color ends with ';'", describe(peek())));
        }
    };
    Numbers formula;
    if (worked_out(as_argument ? Expression::Rule::argument : Expression::Rule::sum, 1, formula)) {
        hold_ = true;
        result.is = formula.count == 5 ? rounded(formula) : formula;
        semicolon();
        hold_ = outer_hold;
        return result;
    }
    const Token first = peek();
    const Value* known = first.kind == Token::Kind::value ? first.value : nullptr;
    // The caller's own variable, when nothing but its name stands there.
    const auto reference = [&]() -> std::shared_ptr<Value> {
        if (!as_argument || first.scope > caller_scope) return nullptr;
        if (first.array) return {first.array->shared_from_this(), first.value};
        std::shared_ptr<Value> slot = bindings_[first.name].back().slot;
        while (Reference* further = slot->as<Reference>()) slot = further->target;
        return slot;
    };
    const bool callable = known && (known->as<Shared<Function>>() != nullptr);
    if (known && !known->as<Numbers>() && !callable) {
        const std::shared_ptr<Value> target = reference();
        take();
        if (target) {
            result.is = Reference{target};
        } else {
            const std::size_t cost = cost_of_copy(*known);
            spend(static_cast<std::int64_t>(cost));
            hold(cost * sizeof(Value));
            result = copy_of(*known);
        }
    } else if (first.kind == Token::Kind::name) {
        fail(first, fmt::format("'{}' is neither a word of the language nor declared; declare it first", first.text));
    } else if (string_follows()) {
        result.is = string();
        hold(std::get<std::string>(result.is).capacity());
    } else if (!vector_follows() && color_follows()) {
        hold_ = true;
        result.is = numbers_of(color());
        semicolon();
        hold_ = outer_hold;
    } else if (vector_follows()) {
        const std::shared_ptr<Value> target = known ? reference() : nullptr;
        const std::int64_t before = tokens_;
        hold_ = true;
        if (callable && !scanner_.next_is('(')) {  // the function itself, not its value
            result = *known;
            take();
            semicolon();
            hold_ = outer_hold;
            return result;
        }
        Numbers numbers = sum(1);
        for (int i = 0; i < numbers.count; ++i) checked(numbers.at[i], first.place);
        if (numbers.count == 5) numbers = rounded(numbers);
        peek();
        if (target && tokens_ == before + 1) {
            result.is = Reference{target};
        } else {
            result.is = numbers;
        }
        semicolon();
        hold_ = outer_hold;
    } else if (accept(Word::array_)) {
        result = array_literal();
    } else if (accept(Word::function_)) {
        result = function_definition();
    } else if (!read_thing || !read_thing(result)) {
        unexpected("a value (float, vector, color, string, array, texture, object, ...)");
    }
    return result;
}

Value Interpreter::declared_value() {
    Value value = right_side(false, scopes_.size(), true);
    const bool outer_hold = std::exchange(hold_, true);
    while (value.shared<SurfaceDraft>() && peek().is(Word::texture_)) {
        const Token layer = peek();
        hold_ = outer_hold;
        Value upper = right_side(false, scopes_.size(), false);
        hold_ = true;
        if (!is_opaque(*upper.shared<SurfaceDraft>())) {
            fail(layer, "layered textures are not in the subset; declare one texture");
        }
        value = std::move(upper);
    }
    hold_ = outer_hold;
    return value;
}

Value Interpreter::library_value() {
    const Place start = scanner_.place();
    const std::size_t blocks = blocks_.size(), files = files_.size(), scopes = scopes_.size();
    const bool outer_hold = hold_, outer_left = left_side_;
    const int depth = depth_;
    const Parameters outer = parameters_;
    ++library_values_;
    try {
        Value value = declared_value();
        --library_values_;
        return value;
    } catch (const LibraryFailure& failure) {
        --library_values_;
        const bool can_go_on = blocks_.size() >= blocks && files_.size() == files && scopes_.size() >= scopes &&
                               depth_ == depth && budget_.work > 0 && budget_.memory > 0;
        if (!can_go_on) fail(failure.unusable->place, failure.unusable->why);
        hold(sizeof(Unusable) + failure.unusable->why.capacity());
        blocks_.resize(blocks);
        while (scopes_.size() > scopes) leave_scope();
        parameters_ = outer;
        hold_ = outer_hold;
        left_side_ = outer_left;
        has_peeked_ = false;
        scanner_.move_to(start.source, start.at);
        skip_value();
        Value value;
        value.is = failure.unusable;
        return value;
    }
}

void Interpreter::skip_value() {
    for (int depth = 0;;) {
        spend(1);
        const Place before = scanner_.place();
        const Token token = scanner_.scan(names_);
        if (token.kind == Token::Kind::end) return;
        if (depth == 0 && (token.kind == Token::Kind::hash || token.is(';')))
            return scanner_.move_to(before.source, before.at);
        if (token.is('{')) ++depth;
        if (!token.is('}') || --depth > 0) continue;
        const Place after = scanner_.place();
        const bool next_layer = scanner_.scan(names_).is(Word::texture_);
        scanner_.move_to(after.source, after.at);
        if (!next_layer) return;
    }
}

Value Interpreter::array_literal() {
    const Place place = peek().place;
    auto array = std::make_shared<Array>();
    double total = 1;
    while (accept('[')) {
        if (array->sizes.size() == 5) fail(place, "an array has at most five dimensions");
        const std::size_t size = count("an array's size", kMostArrayElements);
        total *= static_cast<double>(size);
        if (size == 0 || total > static_cast<double>(kMostArrayElements)) {
            fail(place, fmt::format("an array has between 1 and {} elements", kMostArrayElements));
        }
        array->sizes.push_back(size);
        expect(']', "an array");
        const bool outer_hold = std::exchange(hold_, true);
        peek();
        hold_ = outer_hold;
    }
    if (array->sizes.empty()) unexpected("'[' and the size of the array");
    spend(static_cast<std::int64_t>(total));
    hold(static_cast<std::size_t>(total) * sizeof(Value));
    array->elements.resize(static_cast<std::size_t>(total));
    if (peek().is('{')) array_elements(*array, 0, 0);
    return {array};
}

void Interpreter::array_elements(Array& array, std::size_t dimension, std::size_t first) {
    const Nesting nesting(*this);
    std::size_t stride = 1;
    for (std::size_t i = dimension + 1; i < array.sizes.size(); ++i) stride *= array.sizes[i];
    expect('{', "an array");
    for (std::size_t i = 0; i < array.sizes[dimension]; ++i) {
        if (dimension + 1 < array.sizes.size()) {
            array_elements(array, dimension + 1, first + i * stride);
            continue;
        }
        const Place place = peek().place;
        Value& element = array.elements[first + i];
        element = right_side(false, scopes_.size(), false);
        if (!same_kind(element, array.elements[0])) {
            fail(place, fmt::format("an array of {} cannot hold {}", kind_name(array.elements[0]), kind_name(element)));
        }
        comma();
    }
    expect('}', "an array");
    const bool outer_hold = std::exchange(hold_, true);
    comma();
    hold_ = outer_hold;
}

}  // namespace rays::sdl
