// Macros and functions: text that is read again with its parameters bound.
#include <fmt/format.h>

#include <algorithm>

#include "scene_reader/formula.h"
#include "scene_reader/interpreter.h"

namespace rays::sdl {

void Interpreter::define_macro(Place place) {
    auto macro = std::make_shared<Macro>();
    const bool outer_hold = std::exchange(hold_, true);
    left_side_ = true;
    const Token name = take();
    left_side_ = false;
    const bool known_macro = name.kind == Token::Kind::macro;
    if (name.kind != Token::Kind::name && !known_macro) {
        fail(name, fmt::format("found {}; expected a new name for the macro", describe(name)));
    }
    macro->name = std::string(name.text);
    expect('(', "a macro's definition");
    for (left_side_ = true; !accept(')'); comma()) {
        const Token parameter = take();
        const bool is_name = parameter.kind == Token::Kind::name || parameter.kind == Token::Kind::value ||
                             parameter.kind == Token::Kind::macro;
        if (!is_name) fail(parameter, fmt::format("found {}; expected the name of a parameter", describe(parameter)));
        macro->parameters.push_back(parameter.name);
        if (macro->parameters.size() > 56) fail(parameter, "a macro has at most 56 parameters");
    }
    left_side_ = false;
    hold_ = outer_hold;
    macro->source = scanner_.source();
    macro->body = scanner_.at();
    // The first pass over the body only looks for its end; calls recognise it by the '#'.
    skip_block(1, false, place);
    const char* end = scanner_.at();
    while (*end != '#') --end;
    macro->body_end = end;
    bind(name.name, known_macro ? name.scope : 0)->is = Shared<Macro>(macro);
    ++changes_;
}

void Interpreter::call_macro(const Shared<Macro>& called, Place place) {
    const Macro& macro = *called;
    const Nesting nesting(*this);
    spend(kWorkOfCall);
    // Arguments are expressions of the caller, who may look at whatever follows: directives in them are obeyed.
    const bool outer_hold = std::exchange(hold_, false);
    const bool outer_left = std::exchange(left_side_, false);
    if (!accept('(')) unexpected(fmt::format("'(' in the call of macro {}", macro.name));
    std::vector<Value> arguments;
    const std::size_t caller_scope = scopes_.size() - 1;
    for (std::size_t i = 0; i < macro.parameters.size(); ++i) {
        if (peek().is(')')) {
            fail(peek(), fmt::format("macro {} takes {} arguments, but only {} are given", macro.name,
                                     macro.parameters.size(), i));
        }
        arguments.push_back(right_side(true, caller_scope, false));
        comma();
    }
    if (!accept(')'))
        unexpected(fmt::format("')' in the call of macro {}, which takes {} arguments", macro.name,
                               macro.parameters.size()));
    hold_ = outer_hold;
    left_side_ = outer_left;
    if (blocks_.size() >= kMostOpenBlocks) {
        fail(place,
             fmt::format("more than {} macro calls and blocks inside of one another; does {} call itself for ever?",
                         kMostOpenBlocks, macro.name));
    }
    Block block;
    block.kind = Block::Kind::macro;
    block.opened = place;
    block.come_back = scanner_.place();
    block.macro = called;
    blocks_.push_back(std::move(block));
    scopes_.emplace_back();
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        bind(macro.parameters[i], scopes_.size() - 1)->is = std::move(arguments[i].is);
    }
    ++changes_;
    scanner_.move_to(macro.source, macro.body);
}

void Interpreter::return_from_macro() {
    const Place back = blocks_.back().come_back;
    blocks_.pop_back();
    leave_scope();
    scanner_.move_to(back.source, back.at);
}

Value Interpreter::function_definition() {
    auto function = std::make_shared<Function>();
    const Place place = scanner_.place();
    if (accept('(')) {
        for (left_side_ = true; !accept(')'); comma()) {
            // x, y, z, u and v are reserved, and the usual names of parameters all the same.
            const Token parameter = take();
            if (parameter.text.empty()) fail(parameter, "expected the name of a parameter");
            function->parameters.push_back(parameter.name);
            if (function->parameters.size() > 56) fail(parameter, "a function has at most 56 parameters");
        }
        left_side_ = false;
    } else {
        for (const char* name : {"x", "y", "z"}) function->parameters.push_back(names_.intern(name));
    }
    if (!peek().is('{')) unexpected("'{' and the function's expression (float functions only)");
    function->source = scanner_.source();
    function->body = scanner_.at();
    function->name = "function";
    take();
    int depth = 1;
    for (bool first = true; depth > 0; first = false) {
        spend(1);
        const Token token = scanner_.scan(names_);
        if (token.kind == Token::Kind::end) fail(place, "this function never ends; close it with }");
        if (first && token.kind == Token::Kind::word &&
            (token.word == Word::internal_ || token.word == Word::pigment_)) {
            function->internal = true;
        }
        if (token.kind == Token::Kind::name) capture(*function, token);
        if (token.is('{')) ++depth;
        if (token.is('}') && --depth == 0) function->body_end = token.place.at;
    }
    if (!function->internal) function->formula = formula_of(*function, names_);
    Value value;
    value.is = Shared<Function>(function);
    return value;
}

void Interpreter::capture(Function& function, const Token& name) {
    const auto& parameters = function.parameters;
    const auto& known = bindings(name.name);
    if (known.empty() || std::find(parameters.begin(), parameters.end(), name.name) != parameters.end()) return;
    function.captured.emplace_back(name.name, known.back().slot);
    // A copy: what the variable becomes later does not change the function.
    const Value* value = known.back().slot.get();
    while (const auto* reference = value->as<Reference>()) value = reference->target.get();
    if (value == time_.slot) time_.used = true;
    if (value == wavelength_.slot) wavelength_.used = true;
    if (!value->as<Shared<Function>>()) function.captured.back().second = std::make_shared<Value>(*value);
}

double Interpreter::call_function(const Function& function, Place place) {
    const Nesting nesting(*this);
    spend(kWorkOfCall);
    if (function.internal) fail(place, "POV-Ray's built-in functions and pigment functions are not in the subset");
    expect('(', "a function's call");
    std::vector<double> arguments;
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        if (i > 0) comma();
        arguments.push_back(number());
    }
    if (!accept(')')) unexpected(fmt::format("')' in a function's call with {} arguments", function.parameters.size()));
    if (function.formula) {
        spend(function.formula->work());
        if (const auto value = (*function.formula)(arguments)) return *value;
    }
    const Place back = scanner_.place();
    const auto outer = std::exchange(parameters_, {&function, std::move(arguments)});
    scopes_.emplace_back();
    for (const auto& [name, slot] : function.captured) bind(name, scopes_.size() - 1)->is = Reference{slot};
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        if (names_.is_reserved(function.parameters[i])) continue;
        Numbers argument;
        argument.at[0] = parameters_.values[i];
        bind(function.parameters[i], scopes_.size() - 1)->is = argument;
    }
    scanner_.move_to(function.source, function.body);
    const double value = number();
    if (!peek().is('}')) unexpected("the end of the function");
    has_peeked_ = false;
    leave_scope();
    parameters_ = outer;
    scanner_.move_to(back.source, back.at);
    return value;
}

}  // namespace rays::sdl
