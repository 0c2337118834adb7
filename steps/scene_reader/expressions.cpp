// Expressions: POV-Ray 3.7's precedence and promotion.
//
// From loose to tight: ? :, & and |, comparisons, + and -, * and /, a sign or !, a component after a point. A float
// met where `wanted` components are asked for stands for a vector of that many equal ones; a shorter vector meeting a
// longer one is filled up with zeros (with itself, when it is a float). Where a statement wants a number it takes no
// comparison outside of parentheses, since '<' begins and '>' ends a vector.
#include <fmt/format.h>

#include <algorithm>

#include "scene_reader/interpreter.h"

namespace rays::sdl {

namespace {

bool is_true(double value) { return std::abs(value) > 1e-10; }

/// To `count` components.
void promote(Numbers& numbers, int count) {
    for (int i = numbers.count; i < count; ++i) numbers.at[i] = numbers.count == 1 ? numbers.at[0] : 0;
    numbers.count = std::max(numbers.count, count);
}

Numbers filled(double value, int count) {
    Numbers numbers;
    std::fill(numbers.at, numbers.at + count, value);
    numbers.count = count;
    return numbers;
}

template <class Operation>
void combine(Numbers& left, Numbers right, Operation operation) {
    promote(left, right.count);
    promote(right, left.count);
    for (int i = 0; i < left.count; ++i) left.at[i] = operation(left.at[i], right.at[i]);
}

}  // namespace

bool Interpreter::number_follows() {
    const Token& token = peek();
    switch (token.kind) {
        case Token::Kind::number: return true;
        case Token::Kind::symbol:
            return token.symbol == '(' || token.symbol == '+' || token.symbol == '-' || token.symbol == '!';
        case Token::Kind::word:
            return is_float_function(token.word) || (parameters_.function && is_vector_word(token.word));
        case Token::Kind::value: {
            const auto* numbers = token.value->as<Numbers>();
            return (numbers && numbers->count == 1) || token.value->as<Shared<Function>>();
        }
        default: return false;
    }
}

bool Interpreter::vector_follows() {
    const Token& token = peek();
    return number_follows() || token.is('<') || (token.kind == Token::Kind::word && is_vector_word(token.word)) ||
           (token.kind == Token::Kind::value && token.value->as<Numbers>());
}

// Here and below every function returns one variable of its own, in place: numbers that are copied as a whole right after
// they were set one by one take longer than what is done with them.
Numbers Interpreter::expression(int wanted) {
    const Nesting nesting(*this);
    Numbers value = logical(1);
    if (accept('?'))
        choose(value, wanted);
    else
        promote(value, wanted);
    return value;
}

void Interpreter::choose(Numbers& value, int wanted) {
    if (value.count != 1) fail(peek(), "the condition in front of '?' is a vector; compare floats");
    const bool first = is_true(value.at[0]);
    const Numbers if_true = expression(wanted);
    expect(':', "a conditional expression");
    const Numbers if_false = expression(wanted);
    value = first ? if_true : if_false;
}

Numbers Interpreter::logical(int wanted) {
    Numbers left = comparison(wanted);
    for (;;) {
        if (accept('&')) {
            combine(left, comparison(left.count), [](double a, double b) { return double(is_true(a) && is_true(b)); });
        } else if (accept('|')) {
            combine(left, comparison(left.count), [](double a, double b) { return double(is_true(a) || is_true(b)); });
        } else {
            return left;
        }
    }
}

Numbers Interpreter::comparison(int wanted) {
    Numbers left = string_follows() ? filled(string_comparison(), wanted) : sum(wanted);
    for (;;) {
        const Token& token = peek();
        if (token.kind != Token::Kind::symbol) return left;
        const char symbol = token.symbol;
        if (symbol != '<' && symbol != '>' && symbol != '=' && symbol != 'l' && symbol != 'g' && symbol != 'n')
            return left;
        take();
        const Numbers right = sum(left.count);
        combine(left, right, [symbol](double a, double b) {
            const bool equal = !is_true(a - b);
            switch (symbol) {
                case '<': return double(a < b);
                case '>': return double(a > b);
                case 'l': return double(a <= b || equal);
                case 'g': return double(a >= b || equal);
                case '=': return double(equal);
                default: return double(!equal);
            }
        });
    }
}

double Interpreter::string_comparison() {
    const std::string left = string();
    const Token symbol = take();
    if (symbol.kind != Token::Kind::symbol) fail(symbol, "expected a comparison after a string");
    const int order = left.compare(string());
    switch (symbol.symbol) {
        case '<': return order < 0;
        case '>': return order > 0;
        case 'l': return order <= 0;
        case 'g': return order >= 0;
        case '=': return order == 0;
        case 'n': return order != 0;
        default: fail(symbol, "expected a comparison after a string");
    }
}

Numbers Interpreter::sum(int wanted) {
    Numbers left = product(wanted);
    for (;;) {
        if (accept('+')) {
            combine(left, product(left.count), [](double a, double b) { return a + b; });
        } else if (accept('-')) {
            combine(left, product(left.count), [](double a, double b) { return a - b; });
        } else {
            return left;
        }
    }
}

Numbers Interpreter::product(int wanted) {
    Numbers left = factor(wanted);
    for (;;) {
        if (accept('*')) {
            combine(left, factor(left.count), [](double a, double b) { return a * b; });
        } else if (peek().is('/')) {
            const Place place = take().place;
            Numbers right = factor(left.count);
            promote(right, left.count);
            for (int i = 0; i < right.count; ++i) {
                if (right.at[i] == 0) fail(place, "division by zero");
            }
            combine(left, right, [](double a, double b) { return a / b; });
        } else {
            return left;
        }
    }
}

Numbers Interpreter::factor(int wanted) {
    const Nesting nesting(*this);
    const bool outer_hold = std::exchange(hold_, false);  // directives may stand in front of an operand
    while (accept('+')) {
    }
    const bool is_negative = accept('-'), is_not = !is_negative && accept('!');
    if (is_negative || is_not)
        hold_ = outer_hold;
    else
        peek();
    Numbers value = is_negative || is_not ? factor(wanted) : primary(wanted);
    hold_ = outer_hold;
    for (int i = 0; i < value.count && is_negative; ++i) value.at[i] = -value.at[i];
    for (int i = 0; i < value.count && is_not; ++i) value.at[i] = is_true(value.at[i]) ? 0 : 1;
    while (accept('.')) component(value);
    return value;
}

Numbers Interpreter::primary(int wanted) {
    const Token token = take();
    switch (token.kind) {
        case Token::Kind::number: return filled(token.number, wanted);
        case Token::Kind::value: return value_of(token, wanted);
        case Token::Kind::symbol:
            if (token.symbol == '(') return in_parentheses(wanted);
            if (token.symbol == '<') return angle_brackets();
            break;
        case Token::Kind::word: {
            double number = 0;
            if (parameter(token.name, number)) return filled(number, wanted);
            if (float_function(token.word, token.place, number)) return filled(checked(number, token.place), wanted);
            V3 vector;
            if (vector_function(token.word, token.place, vector)) {
                Numbers value = filled(0, std::max(wanted, 3));
                for (int i = 0; i < 3; ++i) value.at[i] = vector[i];
                return value;
            }
            if (token.word == Word::t_) return {{0, 0, 0, 1}, 4};
            if (token.word == Word::u_) return {{1, 0}, 2};
            if (token.word == Word::v_) return {{0, 1}, 2};
            break;
        }
        default: break;
    }
    peeked_ = token;
    has_peeked_ = true;
    unexpected("a number or a vector");
}

Numbers Interpreter::in_parentheses(int wanted) {
    Numbers value = expression(wanted);
    expect(')', "an expression");
    return value;
}

bool Interpreter::parameter(NameId name, double& result) const {
    if (!parameters_.function) return false;
    const auto& names = parameters_.function->parameters;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return false;
    result = parameters_.values[static_cast<std::size_t>(found - names.begin())];
    return true;
}

Numbers Interpreter::value_of(const Token& token, int wanted) {
    if (const auto* numbers = token.value->as<Numbers>()) {
        if (numbers->count == 1) return filled(numbers->at[0], wanted);
        Numbers value = *numbers;
        if (value.count == 3) promote(value, wanted);
        return value;
    }
    if (const auto function = token.value->shared<Function>()) {
        return filled(checked(call_function(*function, token.place), token.place), wanted);
    }
    wrong_value(token, "a number or a vector");
}

Numbers Interpreter::angle_brackets() {
    Numbers value;
    value.count = 0;
    while (value.count < 2 || (value.count < 5 && vector_follows())) {
        value.at[value.count++] = number();
        comma();
    }
    expect('>', "a vector of two to five numbers");
    return value;
}

void Interpreter::component(Numbers& numbers) {
    const Token token = take();
    int i = -1;
    switch (token.kind == Token::Kind::word ? token.word : Word::other_) {
        // clang-format off
        case Word::x_: case Word::u_: case Word::red_: i = 0; break;
        case Word::y_: case Word::v_: case Word::green_: i = 1; break;
        case Word::z_: case Word::blue_: i = 2; break;
        case Word::t_: case Word::filter_: i = 3; break;
        case Word::transmit_: i = 4; break;
        case Word::gray_:
            // clang-format on
            promote(numbers, 3);
            // POV-Ray's weights of red, green and blue.
            numbers = filled(0.297 * numbers.at[0] + 0.589 * numbers.at[1] + 0.114 * numbers.at[2], 1);
            return;
        default: fail(token, "expected x, y, z, u, v, t, red, green, blue, filter, transmit or gray after the point");
    }
    if (i >= numbers.count) fail(token, fmt::format("a value of {} components has no '{}'", numbers.count, token.text));
    // The other components stay, as in POV-Ray: where a vector is wanted, <1, 2, 3>.y stands for <2, 2, 3>.
    numbers.at[0] = numbers.at[i];
    numbers.count = 1;
}

double Interpreter::checked(double value, const Place& place) {
    if (!std::isfinite(value)) fail(place, "this is not a finite number; look for an overflow or an undefined power");
    return value;
}

double Interpreter::number() {
    Numbers known;
    if (worked_out(Expression::Rule::sum, 1, known) && known.count == 1) return known.at[0];
    const Place place = peek().place;
    const Numbers value = sum(1);
    if (value.count != 1) fail(place, "found a vector or color; expected a float");
    return checked(value.at[0], place);
}

int Interpreter::integer(std::string_view what, int least, int most) {
    const Place place = peek().place;
    const double value = std::trunc(number());
    if (!(value >= least && value <= most))
        fail(place, fmt::format("{} is {}; it lies between {} and {}", what, value, least, most));
    return static_cast<int>(value);
}

std::size_t Interpreter::count(std::string_view what, std::size_t most) {
    const Place place = peek().place;
    const double value = std::trunc(number() + 1e-10);
    if (!(value >= 0 && value <= static_cast<double>(most))) {
        fail(place, fmt::format("{} is {}; it lies between 0 and {}", what, value, most));
    }
    return static_cast<std::size_t>(value);
}

V2 Interpreter::vector2() {
    Numbers known;
    if (worked_out(Expression::Rule::sum, 2, known) && known.count <= 2) return {known.at[0], known.at[1]};
    const Place place = peek().place;
    const Numbers value = sum(2);
    if (value.count > 2) fail(place, "expected a vector of two components");
    return {checked(value.at[0], place), checked(value.at[1], place)};
}

V3 Interpreter::vector() {
    Numbers known;
    if (worked_out(Expression::Rule::sum, 3, known) && known.count <= 3) return known.xyz();
    const Place place = peek().place;
    const Numbers value = sum(3);
    if (value.count > 3) fail(place, "found a color or 4D vector; expected a vector of three components");
    for (int i = 0; i < 3; ++i) checked(value.at[i], place);
    return value.xyz();
}

}  // namespace rays::sdl
