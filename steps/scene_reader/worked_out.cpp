// Expressions that repeat are worked out: what stands at a place of the text becomes a formula the second time.
#include <array>

#include "scene_reader/interpreter.h"

namespace rays::sdl {

namespace {

constexpr std::uint8_t kNever = 255;  ///< failures of what is no formula

}  // namespace

/// The value of the expression that comes next, which is consumed. False when its text must be read: it is read for
/// the first time, or there is more in it than numbers, or an error to tell.
bool Interpreter::worked_out(Expression::Rule rule, int wanted, Numbers& result) {
    if (!repeats() || hold_ || left_side_ || parameters_.function) return false;
    const char* at = scanner_.at();
    if (has_peeked_) {
        const bool can_begin = peeked_.kind == Token::Kind::number || peeked_.kind == Token::Kind::symbol ||
                               peeked_.kind == Token::Kind::word || peeked_.kind == Token::Kind::value;
        if (!can_begin || peeked_.array) return false;
        at = peeked_.place.at;
    }
    if (!scanned_.known) scanned_.known = nothing_remembered<Scanned::Known>();
    Scanned::Known& known = scanned_.known[reinterpret_cast<std::uintptr_t>(at) % Scanned::kRemembered];
    if (known.from != at || known.rule != rule || known.wanted != wanted) {
        known = {at, nullptr, rule, static_cast<std::uint8_t>(wanted), 0};
        return false;
    }
    if (!known.formula) {
        if (known.failures >= kMostFormulasOfOne) return false;
        known.formula = make_formula(rule, wanted, at);
        if (!known.formula) known.failures = kNever;
        if (!known.formula) return false;
    }
    const char* end = known.formula->end();
    if (!evaluate(*known.formula, result)) {
        known.formula = nullptr;
        ++known.failures;
        return false;
    }
    scanner_.move_to(scanner_.source(), end);
    has_peeked_ = false;
    return true;
}

const Formula* Interpreter::make_formula(Expression::Rule rule, int wanted, const char* at) {
    if (scanned_.formulas.size() == kMostFormulas) return nullptr;
    const Expression expression{rule, wanted, scanner_.source(), at};
    int tokens = 0;
    auto formula = expression.worked_out(
        names_, [this](NameId name) { return value_of(name); }, tokens);
    spend(kWorkOfFormula + kWorkOfFormulaToken * tokens);
    // A macro is given the variable itself, not its value.
    if (!formula || (rule == Expression::Rule::argument && formula->is_a_name())) return nullptr;
    scanned_.formulas.push_back(std::move(formula));
    return scanned_.formulas.back().get();
}

const Value* Interpreter::value_of(NameId name) const {
    if (name >= bindings_.size() || bindings_[name].empty()) return nullptr;
    const Value* value = bindings_[name].back().slot.get();
    while (const auto* reference = value->as<Reference>()) value = reference->target.get();
    return value;
}

bool Interpreter::evaluate(const Formula& formula, Numbers& result) {
    const bool fits = blocks_.size() + static_cast<std::size_t>(formula.macro_nesting()) < kMostOpenBlocks &&
                      depth_ + formula.nesting() < kDeepestNesting;
    if (!fits) return false;
    std::array<double, Formula::kMostNumbers> numbers;
    std::array<const Array*, Formula::kMostThings> arrays;
    std::array<const Formula*, Formula::kMostThings> functions;
    std::size_t all_numbers = 0, all_arrays = 0, all_functions = 0;
    std::int64_t work = formula.work();
    for (const Formula::Name& name : formula.names()) {
        const Value* value = value_of(name.name);
        if (!value) return false;
        if (value == time_.slot) time_.used = true;
        if (value == wavelength_.slot) wavelength_.used = true;
        switch (name.is) {
            case Formula::Name::Is::numbers: {
                const auto* found = value->as<Numbers>();
                if (!found || found->count != name.count) return false;
                for (int i = 0; i < name.count; ++i) numbers[all_numbers++] = found->at[i];
                break;
            }
            case Formula::Name::Is::array: {
                const auto* found = value->as<std::shared_ptr<Array>>();
                if (!found || (*found)->sizes != name.sizes) return false;
                arrays[all_arrays++] = found->get();
                break;
            }
            case Formula::Name::Is::function: {
                const auto* found = value->as<Shared<Function>>();
                const bool same =
                    found && (*found)->formula && (*found)->parameters.size() == static_cast<std::size_t>(name.count);
                if (!same) return false;
                functions[all_functions++] = (*found)->formula.get();
                work += kWorkOfCall + (*found)->formula->work();
                break;
            }
            case Formula::Name::Is::macro: {
                const auto* found = value->as<Shared<Macro>>();
                if (!found || (*found)->body != name.body) return false;
                break;
            }
        }
    }
    spend(work);
    const bool has_value = formula(
        {{numbers.data(), all_numbers}, {arrays.data(), all_arrays}, {functions.data(), all_functions}, &random_},
        result);
    if (has_value && (formula.draws() || formula.macros() > 0)) ++changes_;
    return has_value;
}

}  // namespace rays::sdl
