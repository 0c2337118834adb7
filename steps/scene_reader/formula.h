// An expression, worked out once: loops, macros and functions come by the same text a hundred thousand times, and
// reading it anew each time is most of such a scene's reading.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "scene_reader/value.h"

namespace rays::sdl {

class Scanner;

/// Arithmetic on floats, one operation after the other; a vector is several of them. Gives what reading the text gives,
/// bit by bit. What is equal is computed once.
class Formula {
public:
    /// A name in the text, and what it has to stand for: else the formula is none of this text's.
    struct Name {
        enum class Is : std::uint8_t { numbers, array, function, macro } is;
        NameId name = 0;
        int count = 0;                   ///< numbers: components; function: parameters
        std::vector<std::size_t> sizes;  ///< of the array
        const char* body = nullptr;      ///< of the macro
    };
    /// What the names stand for now, in their order: numbers one after the other, arrays, functions.
    struct World {
        std::span<const double> numbers;
        std::span<const Array* const> arrays;
        std::span<const Formula* const> functions;
        std::vector<std::uint32_t>* random = nullptr;  ///< rand()'s streams
    };
    static constexpr std::size_t kMostNumbers = 128;  ///< of a World
    static constexpr std::size_t kMostThings = 16;    ///< arrays, and functions

    /// False where there is an error to tell, with its place: reading the text tells it. Nothing was drawn from
    /// rand()'s streams then.
    bool operator()(const World& world, Numbers& result) const;
    /// Of a function: nothing where there is an error.
    std::optional<double> operator()(std::span<const double> arguments) const;

    const std::vector<Name>& names() const { return names_; }
    const char* end() const { return end_; }  ///< of its text
    /// The value of a variable or of an array's element, and nothing else.
    bool is_a_name() const { return is_a_name_; }
    bool draws() const { return draws_; }     ///< from rand()
    int macros() const { return macros_; }    ///< calls of macros in it, all worked out
    int nesting() const { return nesting_; }  ///< of its text
    int macro_nesting() const { return macro_nesting_; }
    /// Of an evaluation, in tokens (limits.h), without the functions of World.
    std::int64_t work() const { return work_; }

private:
    enum class Does : std::uint8_t {
        // clang-format off
        negate, invert, abs, acos, acosh, asin, asinh, atan, atanh, ceil, cos, cosh, degrees, exp, floor, integer, ln,
        log, radians, sin, sinh, sqrt, tan, tanh,  // of one
        add, subtract, multiply, divide, less, greater, less_equal, greater_equal, equal, unequal, both, either,
        atan2, div, max, min, mod, pow,  // of two
        choose,     // a ? b : c
        subscript,  // index a of an array, in the next dimension: element b of c
        element,    // of array number a, index b: component c % 8 of c / 8
        call,       // function number a, with c arguments from operands_[b] on
        draw,       // from rand()'s stream a
        rotate,     // operands_[a ...]: a vector and three angles; the result takes three places
        spin,       // the same, with an axis and an angle
        rest        // of such a result
        // clang-format on
    };
    struct Operation {
        Does does;
        std::uint16_t a = 0, b = 0, c = 0;
    };
    class Writer;  // formula_writer.h
    class Maker;   // formula_maker.cpp
    friend std::shared_ptr<const Formula> formula_of(const Function& function, Names& names);
    friend struct Expression;

    static constexpr std::size_t kMostPlaces = 672;
    static constexpr std::size_t kMostDraws = 32;

    static int operands_of(Does does);
    static double compute(Does does, double a, double b, double c);
    static double constant(Does does, double a, double b, double c);  ///< the same, once
    bool run(const World& world, double* places) const;
    double call(const Operation& o, const World& world, const double* places) const;

    // Places: constants, the world's numbers, and what each operation gives.
    std::vector<double> constants_;
    std::size_t numbers_ = 0;
    std::vector<Operation> operations_;
    std::vector<std::uint16_t> operands_;
    std::uint16_t results_[5] = {};
    int count_ = 1;
    std::vector<Name> names_;
    std::vector<std::shared_ptr<const Formula>> kept_;  ///< functions that a function captured
    std::vector<const Formula*> functions_;             ///< the same
    const char* end_ = nullptr;
    std::int64_t work_ = 0;
    int depth_ = 1;  ///< of functions' calls inside of one another
    int macros_ = 0, nesting_ = 0, macro_nesting_ = 0;
    bool is_a_name_ = false, draws_ = false;
};

/// Null when there is more in the expression than numbers, or an error: then the text is read at each call.
std::shared_ptr<const Formula> formula_of(const Function& function, Names& names);

/// An expression that stands in a scene's text, up to a symbol or a reserved word that ends it.
struct Expression {
    enum class Rule : std::uint8_t {
        sum,
        whole,
        argument
    };  ///< `whole`: with comparisons; `argument`: sum, of a macro
    Rule rule = Rule::sum;
    int wanted = 1;  ///< components (expressions.cpp)
    const Source* source = nullptr;
    const char* at = nullptr;

    /// Null as above. `value_of`: what a name stands for, references followed; null: nothing. `tokens` were read.
    std::unique_ptr<const Formula> worked_out(Names& names, const std::function<const Value*(NameId)>& value_of,
                                              int& tokens) const;
};

}  // namespace rays::sdl
