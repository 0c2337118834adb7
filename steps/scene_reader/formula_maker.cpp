// How text becomes a formula.
#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <variant>

#include "core/error.h"
#include "scene_reader/formula_writer.h"
#include "scene_reader/token.h"

namespace rays::sdl {

namespace {

constexpr int kDeepest = 16;                               ///< calls of functions inside of one another
constexpr int kDeepestText = 100;                          ///< parentheses, signs and macros
constexpr int kMostTokens = 4000;                          ///< macros in macros can double and double
constexpr std::int64_t kMostWork = 1'000'000'000'000'000;  ///< more than any reading has

const Value* without_references(const Value* value) {
    while (const auto* reference = value ? value->as<Reference>() : nullptr) value = reference->target.get();
    return value;
}

}  // namespace

/// Interpreter's grammar of expressions (expressions.cpp), for numbers alone. Everything else is no formula: then the
/// text seems to end, which leads out of the grammar. Throwing would cost the first who throws a millisecond or two,
/// since a program without shared libraries sorts its tables of frames then.
class Formula::Maker : Writer {
public:
    using ValueOf = std::function<const Value*(NameId)>;

    Maker(Names& names, const ValueOf& value_of) : names_(names), value_of_(value_of) {}

    std::optional<Formula> of_function(const Function& function) {
        function_ = &function;
        for (std::size_t i = 0; i < function.parameters.size(); ++i) new_number();
        begin(function.source, function.body);
        const Operand value = sum(1);
        if (value.count != 1 || !token_.is('}') || token_.place.at != function.body_end) give_up();
        return finish(value);
    }

    std::optional<Formula> of(const Expression& expression) {
        begin(expression.source, expression.at);
        const Token first = token_;
        const Operand value =
            expression.rule == Expression::Rule::whole ? this->expression(expression.wanted) : sum(expression.wanted);
        // A name may be a macro that goes on with an operator, and so may what follows a directive.
        if (token_.kind != Token::Kind::symbol && token_.kind != Token::Kind::word) give_up();
        formula_.end_ = token_.place.at;
        formula_.is_a_name_ = first.kind == Token::Kind::name && has_one_operand_;
        return finish(value);
    }

    int tokens() const { return tokens_; }

private:
    /// What a macro's parameter stands for: numbers, or what has this name outside of all macros.
    using Argument = std::variant<Operand, NameId>;
    struct Call {
        const Macro* macro;
        std::vector<Argument> arguments;
    };

    struct Nesting {
        explicit Nesting(Maker& maker) : maker_(maker) {
            if (++maker.depth_ > kDeepestText) maker.give_up();
            maker.formula_.nesting_ = std::max(maker.formula_.nesting_, maker.depth_);
        }
        ~Nesting() { --maker_.depth_; }
        Maker& maker_;
    };

    // ---- tokens
    void begin(const Source* source, const char* at) {
        scanner_.move_to(source, at);
        next();
    }
    void next() {
        if (++tokens_ > kMostTokens) give_up();
        is_formula_ ? scanner_.scan(names_, token_) : give_up();
    }
    void give_up() {
        is_formula_ = false;
        token_.kind = Token::Kind::end;
    }
    /// For who has to return a value.
    Operand none() {
        give_up();
        return {};
    }
    bool accept(char symbol) {
        if (!token_.is(symbol)) return false;
        next();
        return true;
    }
    void expect(char symbol) {
        if (!accept(symbol)) give_up();
    }

    // ---- the grammar
    void combine(Operand& left, Operand right, Does does) {
        has_one_operand_ = false;
        promote(left, right.count);
        promote(right, left.count);
        for (int i = 0; i < left.count; ++i) left.at[i] = add(does, left.at[i], right.at[i]);
    }
    void apply(Operand& operand, Does does) {
        has_one_operand_ = false;
        for (int i = 0; i < operand.count; ++i) operand.at[i] = add(does, operand.at[i]);
    }

    Operand expression(int wanted) {
        const Nesting nesting(*this);
        Operand value = logical();
        if (!accept('?')) {
            promote(value, wanted);
            return value;
        }
        has_one_operand_ = false;
        const Operand if_true = expression(wanted);
        expect(':');
        const Operand if_false = expression(wanted);
        if (value.count != 1 || if_true.count != if_false.count) return none();
        Operand chosen = if_true;
        for (int i = 0; i < chosen.count; ++i)
            chosen.at[i] = add(Does::choose, value.at[0], if_true.at[i], if_false.at[i]);
        return chosen;
    }
    Operand logical() {
        Operand left = comparison(1);
        for (;;) {
            if (accept('&'))
                combine(left, comparison(left.count), Does::both);
            else if (accept('|'))
                combine(left, comparison(left.count), Does::either);
            else
                return left;
        }
    }
    Operand comparison(int wanted) {
        Operand left = sum(wanted);
        for (;;) {
            const auto does = compares();
            if (!does) return left;
            next();
            combine(left, sum(left.count), *does);
        }
    }
    std::optional<Does> compares() const {
        if (token_.kind != Token::Kind::symbol) return std::nullopt;
        switch (token_.symbol) {
            case '<': return Does::less;
            case '>': return Does::greater;
            case 'l': return Does::less_equal;
            case 'g': return Does::greater_equal;
            case '=': return Does::equal;
            case 'n': return Does::unequal;
            default: return std::nullopt;
        }
    }
    Operand sum(int wanted) {
        Operand left = product(wanted);
        for (;;) {
            if (accept('+'))
                combine(left, product(left.count), Does::add);
            else if (accept('-'))
                combine(left, product(left.count), Does::subtract);
            else
                return left;
        }
    }
    Operand product(int wanted) {
        Operand left = factor(wanted);
        for (;;) {
            if (accept('*'))
                combine(left, factor(left.count), Does::multiply);
            else if (accept('/'))
                combine(left, factor(left.count), Does::divide);
            else
                return left;
        }
    }
    Operand factor(int wanted) {
        const Nesting nesting(*this);
        while (accept('+')) {
        }
        Operand value;
        if (accept('-')) {
            value = factor(wanted);
            apply(value, Does::negate);
        } else if (accept('!')) {
            value = factor(wanted);
            apply(value, Does::invert);
        } else {
            value = primary(wanted);
        }
        while (accept('.')) value = component(value);
        return value;
    }
    Operand component(Operand value) {
        has_one_operand_ = false;
        const Token token = token_;
        next();
        int i = 0;
        switch (token.kind == Token::Kind::word ? token.word : Word::other_) {
            // clang-format off
            case Word::x_: case Word::u_: case Word::red_: i = 0; break;
            case Word::y_: case Word::v_: case Word::green_: i = 1; break;
            case Word::z_: case Word::blue_: i = 2; break;
            case Word::t_: case Word::filter_: i = 3; break;
            case Word::transmit_: i = 4; break;
            // clang-format on
            default: return none();
        }
        if (i >= value.count) return none();
        value.at[0] = value.at[i];
        value.count = 1;
        return value;
    }

    Operand primary(int wanted) {
        const Token token = token_;
        next();
        switch (token.kind) {
            case Token::Kind::number: return literal(token.number, wanted);
            case Token::Kind::symbol:
                if (token.symbol == '(') return in_parentheses(wanted);
                if (token.symbol == '<') return angle_brackets();
                return none();
            case Token::Kind::word:
            case Token::Kind::name: break;
            default: return none();
        }
        if (const auto number = parameter(token.name)) return filled(*number, wanted);
        return token.kind == Token::Kind::word ? word(token.word, wanted) : name(token.name, wanted);
    }
    Operand in_parentheses(int wanted) {
        const Operand value = expression(wanted);
        expect(')');
        has_one_operand_ = false;
        return value;
    }
    Operand angle_brackets() {
        has_one_operand_ = false;
        Operand vector;
        vector.count = 0;
        while (vector.count < 2 || (vector.count < 5 && !token_.is('>'))) {
            vector.at[vector.count++] = number();
            accept(',');
        }
        expect('>');
        return vector;
    }
    std::uint16_t number() {
        const Operand value = sum(1);
        if (value.count != 1) give_up();
        return value.at[0];
    }
    Operand vector() {
        Operand value = sum(3);
        if (value.count > 3) give_up();
        value.count = 3;
        return value;
    }

    // ---- names
    std::optional<std::uint16_t> parameter(NameId name) const {
        if (!function_) return std::nullopt;
        const auto& all = function_->parameters;
        const auto found = std::find(all.begin(), all.end(), name);
        if (found == all.end()) return std::nullopt;
        return static_cast<std::uint16_t>(kNumber + (found - all.begin()));
    }

    Operand name(NameId name, int wanted) {
        // A macro sees the parameters of those that called it.
        for (std::size_t i = calls_.size(); i-- > 0;) {
            const auto& parameters = calls_[i].macro->parameters;
            const auto found = std::find(parameters.begin(), parameters.end(), name);
            if (found == parameters.end()) continue;
            const Argument& argument = calls_[i].arguments[static_cast<std::size_t>(found - parameters.begin())];
            if (const auto* operand = std::get_if<Operand>(&argument)) return value_of_numbers(*operand, wanted);
            return outer_name(std::get<NameId>(argument), wanted);
        }
        return outer_name(name, wanted);
    }
    Operand outer_name(NameId name, int wanted) {
        const Value* value = meaning(name);
        if (!value) return none();
        if (const auto* numbers = value->as<Numbers>()) return value_of_numbers(numbers_of(name, *numbers), wanted);
        if (const auto* array = value->as<std::shared_ptr<Array>>()) return element(name, **array, wanted);
        if (const auto function = value->shared<Function>()) return filled(call(name, *function), wanted);
        if (const auto macro = value->shared<Macro>()) return call(name, *macro, wanted);
        return none();
    }
    const Value* meaning(NameId name) const {
        if (!function_) return without_references(value_of_(name));
        const auto& all = function_->captured;
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.first == name; });
        return found == all.end() ? nullptr : without_references(found->second.get());
    }
    Operand value_of_numbers(Operand value, int wanted) {
        if (value.count == 1 || value.count == 3) promote(value, wanted);
        return value;
    }
    Operand numbers_of(NameId name, const Numbers& numbers) {
        Operand value;
        value.count = numbers.count;
        if (function_) {
            for (int i = 0; i < numbers.count; ++i) value.at[i] = constant(numbers.at[i]);
            return value;
        }
        const auto [known, is_new] = variables_.try_emplace(name);
        if (!is_new) return known->second;
        for (int i = 0; i < numbers.count; ++i) value.at[i] = new_number();
        formula_.names_.push_back({Name::Is::numbers, name, numbers.count, {}, nullptr});
        return known->second = value;
    }
    /// The number of a thing among those of its kind that the formula looks up.
    std::uint16_t thing(Name::Is is, NameId name, int count, const std::vector<std::size_t>& sizes,
                        const char* body = nullptr) {
        std::size_t number = 0;
        for (const Name& known : formula_.names_) {
            if (known.is != is) continue;
            if (known.name == name) return static_cast<std::uint16_t>(number);
            ++number;
        }
        if (number == kMostThings) return give_up(), std::uint16_t{0};
        formula_.names_.push_back({is, name, count, sizes, body});
        return static_cast<std::uint16_t>(number);
    }

    Operand element(NameId name, const Array& array, int wanted) {
        if (function_) return none();
        const bool alone = has_one_operand_;
        std::uint16_t index = 0;
        for (const std::size_t size : array.sizes) {
            expect('[');
            const std::uint16_t subscript = number();
            expect(']');
            index = add(Does::subscript, index, subscript, constant(static_cast<double>(size)));
        }
        const auto is_known = [](const Value& value) { return !value.empty(); };
        const auto like = std::find_if(array.elements.begin(), array.elements.end(), is_known);
        const Numbers* numbers = like == array.elements.end() ? nullptr : like->as<Numbers>();
        if (!numbers) return none();
        Operand value;
        value.count = numbers->count;
        const std::uint16_t which = thing(Name::Is::array, name, 0, array.sizes);
        for (int i = 0; i < value.count; ++i)
            value.at[i] = add(Does::element, which, index, static_cast<std::uint16_t>(8 * value.count + i));
        has_one_operand_ = alone;
        return value_of_numbers(value, wanted);
    }

    std::uint16_t call(NameId name, const Function& called) {
        if (!called.formula) return give_up(), std::uint16_t{0};
        const int count = static_cast<int>(called.parameters.size());
        std::uint16_t which = 0;
        if (function_) {
            formula_.depth_ = std::max(formula_.depth_, called.formula->depth_ + 1);
            if (formula_.depth_ > kDeepest) give_up();
            formula_.work_ = std::min(kMostWork, formula_.work_ + called.formula->work_);
            which = static_cast<std::uint16_t>(formula_.kept_.size());
            if (which == kMostNumbers) give_up();
            formula_.kept_.push_back(called.formula);
        } else {
            which = thing(Name::Is::function, name, count, {});
        }
        expect('(');
        std::vector<Operand> arguments;
        for (int i = 0; i < count; ++i) {
            if (i > 0) accept(',');
            arguments.push_back(filled(number(), 1));
        }
        expect(')');
        has_one_operand_ = false;
        const auto first = static_cast<std::uint16_t>(formula_.operands_.size());
        for (const Operand& argument : arguments) listed({argument});
        return add(Does::call, which, first, static_cast<std::uint16_t>(count));
    }

    /// A macro whose text is one operand: a number, a vector, something in parentheses.
    Operand call(NameId name, const Macro& macro, int wanted) {
        if (function_) return none();
        const Nesting nesting(*this);
        thing(Name::Is::macro, name, 0, {}, macro.body);
        ++formula_.macros_;
        Call call{&macro, {}};
        expect('(');
        for (std::size_t i = 0; i < macro.parameters.size(); ++i) {
            call.arguments.push_back(argument());
            accept(',');
        }
        if (!token_.is(')')) return none();
        const Scanner back = scanner_;
        calls_.push_back(std::move(call));
        formula_.macro_nesting_ = std::max(formula_.macro_nesting_, static_cast<int>(calls_.size()));
        begin(macro.source, macro.body);
        const Operand value = primary(wanted);
        if (token_.kind != Token::Kind::hash || token_.place.at != macro.body_end) return none();
        calls_.pop_back();
        scanner_ = back;
        next();
        has_one_operand_ = false;
        return value;
    }
    Argument argument() {
        const Token first = token_;
        if (first.kind == Token::Kind::name) {
            const Scanner behind = scanner_;
            next();
            if (token_.is(',') || token_.is(')')) {
                if (const auto thing = named(first.name)) return *thing;
                return name(first.name, 1);
            }
            scanner_ = behind;
            token_ = first;
        }
        const Operand value = sum(1);
        if (value.count == 5) give_up();  // a colour, which is rounded
        return value;
    }
    /// What the name stands for outside of all macros, when it is no number.
    std::optional<NameId> named(NameId name) const {
        for (std::size_t i = calls_.size(); i-- > 0;) {
            const auto& parameters = calls_[i].macro->parameters;
            const auto found = std::find(parameters.begin(), parameters.end(), name);
            if (found == parameters.end()) continue;
            const Argument& argument = calls_[i].arguments[static_cast<std::size_t>(found - parameters.begin())];
            if (const auto* other = std::get_if<NameId>(&argument)) return *other;
            return std::nullopt;
        }
        const Value* value = meaning(name);
        return value && !value->as<Numbers>() ? std::optional(name) : std::nullopt;
    }

    // ---- words
    struct Named {
        Word word;
        Does does;
        enum Takes { one, two, many } takes;
    };
    static constexpr Named kFunctions[] = {
        {Word::abs_, Does::abs, Named::one},         {Word::acos_, Does::acos, Named::one},
        {Word::acosh_, Does::acosh, Named::one},     {Word::asin_, Does::asin, Named::one},
        {Word::asinh_, Does::asinh, Named::one},     {Word::atan_, Does::atan, Named::one},
        {Word::atan2_, Does::atan2, Named::two},     {Word::atanh_, Does::atanh, Named::one},
        {Word::ceil_, Does::ceil, Named::one},       {Word::cos_, Does::cos, Named::one},
        {Word::cosh_, Does::cosh, Named::one},       {Word::degrees_, Does::degrees, Named::one},
        {Word::div_, Does::div, Named::two},         {Word::exp_, Does::exp, Named::one},
        {Word::floor_, Does::floor, Named::one},     {Word::int_, Does::integer, Named::one},
        {Word::ln_, Does::ln, Named::one},           {Word::log_, Does::log, Named::one},
        {Word::max_, Does::max, Named::many},        {Word::min_, Does::min, Named::many},
        {Word::mod_, Does::mod, Named::two},         {Word::pow_, Does::pow, Named::two},
        {Word::radians_, Does::radians, Named::one}, {Word::rand_, Does::draw, Named::one},
        {Word::sin_, Does::sin, Named::one},         {Word::sinh_, Does::sinh, Named::one},
        {Word::sqrt_, Does::sqrt, Named::one},       {Word::tan_, Does::tan, Named::one},
        {Word::tanh_, Does::tanh, Named::one}};

    Operand word(Word word, int wanted) {
        has_one_operand_ = false;
        switch (word) {
            case Word::pi_: return literal(std::numbers::pi, wanted);
            case Word::true_:
            case Word::yes_:
            case Word::on_: return literal(1, wanted);
            case Word::false_:
            case Word::no_:
            case Word::off_: return literal(0, wanted);
            case Word::x_: return axis(0, wanted);
            case Word::y_: return axis(1, wanted);
            case Word::z_: return axis(2, wanted);
            case Word::vdot_:
            case Word::vlength_: return filled(length_or_dot(word), wanted);
            case Word::vcross_:
            case Word::vnormalize_:
            case Word::vrotate_:
            case Word::vaxis_rotate_: return vector_function(word, wanted);
            default: return filled(float_function(word), wanted);
        }
    }
    Operand axis(int i, int wanted) {
        Operand value = filled(0, std::max(wanted, 3));
        value.at[i] = constant(1);
        return value;
    }
    std::uint16_t float_function(Word word) {
        const auto named = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                        [&](const Named& function) { return function.word == word; });
        if (named == std::end(kFunctions)) return give_up(), std::uint16_t{0};
        if (named->does == Does::draw) {
            if (function_) give_up();
            formula_.draws_ = true;
        }
        expect('(');
        std::uint16_t value = 0;
        if (named->takes == Named::one) {
            const Operand operand = expression(1);
            if (operand.count != 1) give_up();
            value = add(named->does, operand.at[0]);
        } else {
            value = number();
            if (named->takes == Named::two) accept(','), value = add(named->does, value, number());
            while (named->takes == Named::many && accept(',')) value = add(named->does, value, number());
        }
        expect(')');
        has_one_operand_ = false;
        return value;
    }
    std::uint16_t dot(const Operand& a, const Operand& b) {
        const auto product = [&](int i) { return add(Does::multiply, a.at[i], b.at[i]); };
        const std::uint16_t x = product(0), y = product(1), z = product(2);
        return add(Does::add, add(Does::add, x, y), z);
    }
    std::uint16_t length_or_dot(Word word) {
        expect('(');
        const Operand a = vector();
        std::uint16_t value = 0;
        if (word == Word::vdot_) {
            accept(',');
            value = dot(a, vector());
        } else {
            value = add(Does::sqrt, dot(a, a));
        }
        expect(')');
        has_one_operand_ = false;
        return value;
    }
    Operand vector_function(Word word, int wanted) {
        expect('(');
        const Operand a = vector();
        Operand value = filled(0, 3);
        if (word == Word::vnormalize_) {
            const std::uint16_t length = add(Does::sqrt, dot(a, a));
            for (int i = 0; i < 3; ++i) value.at[i] = add(Does::divide, a.at[i], length);
        } else {
            accept(',');
            const Operand b = vector();
            if (word == Word::vcross_) {
                for (int i = 0; i < 3; ++i) {
                    const int j = (i + 1) % 3, k = (i + 2) % 3;
                    value.at[i] = add(Does::subtract, add(Does::multiply, a.at[j], b.at[k]),
                                      add(Does::multiply, b.at[j], a.at[k]));
                }
            } else {
                std::uint16_t operands = 0;
                if (word == Word::vrotate_) {
                    operands = listed({a, b});
                } else {
                    accept(',');
                    operands = listed({a, b, filled(number(), 1)});
                }
                value.at[0] = push({word == Word::vrotate_ ? Does::rotate : Does::spin, operands});
                value.at[1] = push({Does::rest});
                value.at[2] = push({Does::rest});
            }
        }
        expect(')');
        has_one_operand_ = false;
        value.count = std::max(wanted, 3);
        return value;
    }

    Names& names_;
    const ValueOf& value_of_;
    const Function* function_ = nullptr;  ///< whose text this is: its names are constants
    Scanner scanner_;
    Token token_;
    std::vector<Call> calls_;
    std::map<NameId, Operand> variables_;
    int tokens_ = 0;
    int depth_ = 0;
    bool has_one_operand_ = true;
};

std::shared_ptr<const Formula> formula_of(const Function& function, Names& names) {
    try {
        auto formula = Formula::Maker(names, {}).of_function(function);
        return formula ? std::make_shared<const Formula>(*std::move(formula)) : nullptr;
    } catch (const InputError&) {  // the scanner's; who calls the function is told
        return nullptr;
    }
}

std::unique_ptr<const Formula> Expression::worked_out(Names& names, const std::function<const Value*(NameId)>& value_of,
                                                      int& tokens) const {
    try {
        Formula::Maker maker(names, value_of);
        auto formula = maker.of(*this);
        tokens = maker.tokens();
        return formula ? std::make_unique<const Formula>(*std::move(formula)) : nullptr;
    } catch (const InputError&) {  // the scanner's; reading the text tells it
        return nullptr;
    }
}

}  // namespace rays::sdl
