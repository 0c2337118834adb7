// The built-in functions of floats and vectors.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "scene_reader/functions.h"
#include "scene_reader/interpreter.h"

namespace rays::sdl {

double Interpreter::argument() {
    expect('(', "a function's call");
    Numbers value;
    if (!worked_out(Expression::Rule::whole, 1, value) || value.count != 1) {
        const Place place = peek().place;
        value = expression(1);
        if (value.count != 1) fail(place, "found a vector or color; expected a float");
    }
    expect(')', "a function's call");
    return value.at[0];
}

void Interpreter::two_arguments(double& a, double& b) {
    expect('(', "a function's call");
    a = number();
    comma();
    b = number();
    expect(')', "a function's call");
}

double Interpreter::extreme(bool largest) {
    expect('(', "min or max");
    double value = number();
    while (accept(',')) value = largest ? std::max(value, number()) : std::min(value, number());
    expect(')', "min or max");
    return value;
}

double Interpreter::bits(Word word) {
    expect('(', "a bitwise function");
    int value = to_int(number());
    while (accept(',')) {
        const int other = to_int(number());
        value = word == Word::bitwise_and_ ? value & other : word == Word::bitwise_or_ ? value | other : value ^ other;
    }
    expect(')', "a bitwise function");
    return value;
}

double Interpreter::select() {
    expect('(', "select");
    const double value = number();
    comma();
    const double if_less = number();
    comma();
    const double if_equal = number();
    const double if_greater = accept(',') ? number() : if_equal;
    expect(')', "select");
    return value < 0 ? if_less : value == 0 ? if_equal : if_greater;
}

double Interpreter::random(const Place& place) {
    const double stream = argument();
    std::uint32_t* state = random_stream(random_, stream);
    if (!state) fail(place, "rand needs a stream that seed() made: #declare R = seed(1);");
    ++changes_;
    return draw_random(*state);
}

double Interpreter::dimension(Word word) {
    expect('(', "dimension_size");
    const Token name = take();
    const auto* held = name.kind == Token::Kind::value ? name.value->as<std::shared_ptr<Array>>() : nullptr;
    if (!held) fail(name, "expected an array");
    const std::shared_ptr<Array> array = *held;
    double result = static_cast<double>(array->sizes.size());
    if (word == Word::dimension_size_) {
        comma();
        const double which = std::trunc(number());
        result =
            which >= 1 && which <= result ? static_cast<double>(array->sizes[static_cast<std::size_t>(which) - 1]) : 0;
    }
    expect(')', "dimension_size");
    return result;
}

bool Interpreter::float_function(Word word, const Place& place, double& result) {
    constexpr double kDegree = std::numbers::pi / 180;
    double a = 0, b = 0;
    switch (word) {
        case Word::abs_: result = std::abs(argument()); return true;
        case Word::acos_: result = std::acos(std::clamp(argument(), -1.0, 1.0)); return true;
        case Word::acosh_: result = std::acosh(argument()); return true;
        case Word::asin_: result = std::asin(std::clamp(argument(), -1.0, 1.0)); return true;
        case Word::asinh_: result = std::asinh(argument()); return true;
        case Word::atan_: result = std::atan(argument()); return true;
        case Word::atan2_:
            two_arguments(a, b);
            if (std::abs(a) <= 1e-10 && std::abs(b) <= 1e-10) fail(place, "atan2(0, 0) is undefined");
            result = std::atan2(a, b);
            return true;
        case Word::atanh_: result = std::atanh(argument()); return true;
        case Word::bitwise_and_:
        case Word::bitwise_or_:
        case Word::bitwise_xor_: result = bits(word); return true;
        case Word::ceil_: result = std::ceil(argument()); return true;
        case Word::clock_: result = options_.clock; return true;
        case Word::clock_on_: result = options_.frame_number != 0; return true;
        case Word::cos_: result = std::cos(argument()); return true;
        case Word::cosh_: result = std::cosh(argument()); return true;
        case Word::defined_: result = is_declared(); return true;
        case Word::degrees_: result = argument() / kDegree; return true;
        case Word::dimension_size_:
        case Word::dimensions_: result = dimension(word); return true;
        case Word::div_:
            two_arguments(a, b);
            result = to_int(checked(a / b, place));
            return true;
        case Word::exp_: result = std::exp(argument()); return true;
        case Word::floor_: result = std::floor(argument()); return true;
        case Word::int_: result = to_int(argument()); return true;
        case Word::ln_:
        case Word::log_:
            a = argument();
            if (!(a > 0)) fail(place, fmt::format("the logarithm of {} is undefined", a));
            result = word == Word::ln_ ? std::log(a) : std::log10(a);
            return true;
        case Word::max_:
        case Word::min_: result = extreme(word == Word::max_); return true;
        case Word::mod_:
            two_arguments(a, b);
            result = std::fmod(a, b);
            return true;
        case Word::now_: fail(place, "now would make a different picture each time; declare a constant instead");
        case Word::pi_: result = std::numbers::pi; return true;
        case Word::pow_:
            two_arguments(a, b);
            if (a == 0 && b == 0) fail(place, "pow(0, 0) is undefined");
            result = std::pow(a, b);
            return true;
        case Word::radians_: result = argument() * kDegree; return true;
        case Word::rand_: result = random(place); return true;
        case Word::seed_:
            if (random_.size() >= 1'000'000) fail(place, "more than a million random streams");
            random_.push_back(static_cast<std::uint32_t>(to_int(argument())));
            ++changes_;
            result = static_cast<double>(random_.size() - 1);
            return true;
        case Word::select_: result = select(); return true;
        case Word::sin_: result = std::sin(argument()); return true;
        case Word::sinh_: result = std::sinh(argument()); return true;
        case Word::sqrt_:
            a = argument();
            if (a < 0) fail(place, fmt::format("the square root of {} is undefined", a));
            result = std::sqrt(a);
            return true;
        case Word::tan_: result = std::tan(argument()); return true;
        case Word::tanh_: result = std::tanh(argument()); return true;
        case Word::true_:
        case Word::yes_:
        case Word::on_: result = 1; return true;
        case Word::false_:
        case Word::no_:
        case Word::off_: result = 0; return true;
        case Word::vdot_: {
            expect('(', "vdot");
            const V3 left = vector();
            comma();
            result = glm::dot(left, vector());
            expect(')', "vdot");
            return true;
        }
        case Word::vlength_:
            expect('(', "vlength");
            result = glm::length(vector());
            expect(')', "vlength");
            return true;
        case Word::version_: result = version_; return true;
        default: return string_function(word, place, result);
    }
}

bool Interpreter::vector_function(Word word, const Place& place, V3& result) {
    // Inside of a function the names of the axes are its parameters.
    switch (word) {
        case Word::x_: result = {1, 0, 0}; return true;
        case Word::y_: result = {0, 1, 0}; return true;
        case Word::z_: result = {0, 0, 1}; return true;
        case Word::vaxis_rotate_:
        case Word::vcross_:
        case Word::vrotate_: break;
        case Word::vnormalize_: {
            expect('(', "vnormalize");
            const V3 v = vector();
            expect(')', "vnormalize");
            if (v == V3(0)) note(place, "vnormalize of the zero vector gives the zero vector");
            result = v == V3(0) ? v : v / glm::length(v);
            return true;
        }
        default: return false;
    }
    expect('(', "a vector function");
    const V3 a = vector();
    comma();
    const V3 b = vector();
    if (word == Word::vcross_) {
        result = glm::cross(a, b);
    } else if (word == Word::vrotate_) {
        result = Affine::rotation(b).vector(a);
    } else {
        comma();
        const double degrees = number();
        if (b == V3(0)) fail(place, "the axis of vaxis_rotate is the zero vector");
        result = Affine::axis_rotation(b, degrees).vector(a);
    }
    expect(')', "a vector function");
    return true;
}

}  // namespace rays::sdl
