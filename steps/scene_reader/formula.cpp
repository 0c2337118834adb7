#include "scene_reader/formula.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rays::sdl {

namespace {

bool is_true(double value) { return std::abs(value) > 1e-10; }

}  // namespace

std::optional<double> Formula::of_one(Does does, double a) {
    constexpr double kDegree = std::numbers::pi / 180;
    switch (does) {
        case Does::abs: return std::abs(a);
        case Does::acos: return std::acos(std::clamp(a, -1.0, 1.0));
        case Does::acosh: return std::acosh(a);
        case Does::asin: return std::asin(std::clamp(a, -1.0, 1.0));
        case Does::asinh: return std::asinh(a);
        case Does::atan: return std::atan(a);
        case Does::atanh: return std::atanh(a);
        case Does::ceil: return std::ceil(a);
        case Does::cos: return std::cos(a);
        case Does::cosh: return std::cosh(a);
        case Does::degrees: return a / kDegree;
        case Does::exp: return std::exp(a);
        case Does::floor: return std::floor(a);
        case Does::ln: return a > 0 ? std::optional(std::log(a)) : std::nullopt;
        case Does::log: return a > 0 ? std::optional(std::log10(a)) : std::nullopt;
        case Does::radians: return a * kDegree;
        case Does::sin: return std::sin(a);
        case Does::sinh: return std::sinh(a);
        case Does::sqrt: return a < 0 ? std::nullopt : std::optional(std::sqrt(a));
        case Does::tan: return std::tan(a);
        default: return std::tanh(a);
    }
}

std::optional<double> Formula::of_two(Does does, double a, double b) {
    switch (does) {
        case Does::atan2:
            if (std::abs(a) <= 1e-10 && std::abs(b) <= 1e-10) return std::nullopt;
            return std::atan2(a, b);
        case Does::max: return std::max(a, b);
        case Does::min: return std::min(a, b);
        case Does::mod: return std::fmod(a, b);
        default:
            if (a == 0 && b == 0) return std::nullopt;
            return std::pow(a, b);
    }
}

/// Puts the value of a function in the place of its arguments; false where it has none.
bool Formula::call(const Operation& o, double* stack, std::size_t& size) const {
    const bool takes_two = o.does == Does::atan2 || o.does == Does::max || o.does == Does::min || o.does == Does::mod ||
                           o.does == Does::pow;
    const std::size_t arguments = o.does == Does::call ? called_[o.which].arguments : takes_two ? 2 : 1;
    size -= arguments;
    const double* first = stack + size;
    // Where the text has number() for an argument, it must be finite.
    if (arguments != 1 || o.does == Does::call)
        if (!std::all_of(first, first + arguments, [](double a) { return std::isfinite(a); })) return false;
    const auto value = o.does == Does::call ? (*called_[o.which].formula)({first, arguments})
                       : takes_two          ? of_two(o.does, first[0], first[1])
                                            : of_one(o.does, first[0]);
    if (!value || !std::isfinite(*value)) return false;
    stack[size++] = *value;
    return true;
}

std::optional<double> Formula::operator()(std::span<const double> arguments) const {
    std::array<double, kMostWaiting> stack;
    std::size_t size = 0;
    const auto pop = [&] { return stack[--size]; };
    const auto combine = [&](auto operation) {
        const double b = pop();
        stack[size - 1] = operation(stack[size - 1], b);
    };
    for (const Operation& o : operations_) {
        switch (o.does) {
            case Does::number: stack[size++] = o.number; break;
            case Does::argument: stack[size++] = arguments[o.which]; break;
            case Does::negate: stack[size - 1] = -stack[size - 1]; break;
            case Does::invert: stack[size - 1] = is_true(stack[size - 1]) ? 0 : 1; break;
            case Does::add: combine([](double a, double b) { return a + b; }); break;
            case Does::subtract: combine([](double a, double b) { return a - b; }); break;
            case Does::multiply: combine([](double a, double b) { return a * b; }); break;
            case Does::divide:
                if (stack[size - 1] == 0) return std::nullopt;
                combine([](double a, double b) { return a / b; });
                break;
            case Does::less: combine([](double a, double b) { return double(a < b); }); break;
            case Does::greater: combine([](double a, double b) { return double(a > b); }); break;
            case Does::less_equal: combine([](double a, double b) { return double(a <= b || !is_true(a - b)); }); break;
            case Does::greater_equal:
                combine([](double a, double b) { return double(a >= b || !is_true(a - b)); });
                break;
            case Does::equal: combine([](double a, double b) { return double(!is_true(a - b)); }); break;
            case Does::unequal: combine([](double a, double b) { return double(is_true(a - b)); }); break;
            case Does::both: combine([](double a, double b) { return double(is_true(a) && is_true(b)); }); break;
            case Does::either: combine([](double a, double b) { return double(is_true(a) || is_true(b)); }); break;
            case Does::choose: {
                const double if_false = pop(), if_true = pop();
                stack[size - 1] = is_true(stack[size - 1]) ? if_true : if_false;
                break;
            }
            default:
                if (!call(o, stack.data(), size)) return std::nullopt;
        }
    }
    return std::isfinite(stack[0]) ? std::optional(stack[0]) : std::nullopt;
}

}  // namespace rays::sdl
