// A function's expression, worked out once: loops call functions a hundred thousand times, and reading the text again
// for each call is most of such a scene's reading.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "scene_reader/words.h"

namespace rays::sdl {

struct Function;

/// Arithmetic, comparisons and the usual functions of floats, in postfix. Gives what reading the text gives, bit by
/// bit.
class Formula {
public:
    /// Nothing where there is an error to tell, with its place: reading the text tells it.
    std::optional<double> operator()(std::span<const double> arguments) const;

    /// Of a call, in tokens (limits.h).
    std::int64_t work() const { return work_; }

private:
    enum class Does : std::uint8_t {
        // clang-format off
        number, argument, call, negate, invert, add, subtract, multiply, divide,
        less, greater, less_equal, greater_equal, equal, unequal, both, either, choose,
        abs, acos, acosh, asin, asinh, atan, atan2, atanh, ceil, cos, cosh, degrees, exp, floor, ln, log, max, min,
        mod, pow, radians, sin, sinh, sqrt, tan, tanh
        // clang-format on
    };
    struct Operation {
        Does does;
        std::uint32_t which = 0;  ///< of an argument its number, of a call that of the formula
        double number = 0;
    };
    class Maker;  // formula_maker.cpp
    friend std::shared_ptr<const Formula> formula_of(const Function& function, Names& names);

    static constexpr std::size_t kMostWaiting = 64;  ///< numbers on the stack

    static std::optional<double> of_one(Does does, double a);
    static std::optional<double> of_two(Does does, double a, double b);
    bool call(const Operation& operation, double* stack, std::size_t& size) const;

    std::vector<Operation> operations_;
    struct Called {
        std::shared_ptr<const Formula> formula;
        std::size_t arguments = 0;
    };
    std::vector<Called> called_;
    std::int64_t work_ = 0;
    int depth_ = 1;  ///< of calls inside of one another
};

/// Null when there is more in the expression than floats, or an error: then the text is read at each call.
std::shared_ptr<const Formula> formula_of(const Function& function, Names& names);

}  // namespace rays::sdl
