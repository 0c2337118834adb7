// Functions are worked out once where they can be. What a call gives, and what it complains about, is what its text
// says.
#include <fmt/format.h>

#include <bit>
#include <random>

#include "read.h"

namespace rays {
namespace {

/// Expressions by chance, of the numbers A, B and C. Many have no value somewhere.
class Expressions {
public:
    std::string sum(int depth) {
        std::string text = product(depth);
        for (int n = below(3); n > 0; --n) text += one_of({" + ", " - "}) + product(depth);
        return text;
    }

private:
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    std::string one_of(std::initializer_list<const char*> words) { return words.begin()[below(int(words.size()))]; }

    std::string product(int depth) {
        std::string text = factor(depth);
        for (int n = below(3); n > 0; --n) text += one_of({"*", "*", "/"}) + factor(depth);
        return text;
    }
    std::string factor(int depth) {
        if (below(8) == 0) return one_of({"-", "+", "!", "+-"}) + factor(depth);
        if (depth == 0 || below(4) == 0) return one_of({"A", "B", "C", "0.5", "3", "pi", "D", "0"});
        switch (below(4)) {
            case 0: return "(" + condition(depth - 1) + ")";
            case 1:
                return one_of({"sin",     "cos",  "abs",  "sqrt", "exp",   "ln",    "log",
                               "floor",   "ceil", "atan", "tanh", "acos",  "asin",  "degrees",
                               "radians", "tan",  "sinh", "cosh", "asinh", "acosh", "atanh"}) +
                       "(" + condition(depth - 1) + ")";
            case 2:
                return one_of({"max", "min", "mod", "pow", "atan2", "Twice"}) + "(" + sum(depth - 1) + ", " +
                       sum(depth - 1) + ")";
            default: return "(" + sum(depth - 1) + ")";
        }
    }
    std::string condition(int depth) {
        const auto compared = [&] {
            return sum(depth) + one_of({" < ", " > ", " <= ", " >= ", " = ", " != "}) + sum(depth);
        };
        switch (below(6)) {
            case 0: return compared();
            case 1: return compared() + one_of({" & ", " | "}) + compared();
            case 2: return "(" + compared() + " ? " + sum(depth) + " : " + sum(depth) + ")";
            default: return sum(depth);
        }
    }

    std::mt19937 random_{7};
};

const std::string kGiven = "#declare D = -1.25; #declare Twice = function(p, q) { 2*p + 0.25*q - D }\n";

std::string declared(double a, double b, double c) {
    return fmt::format("#declare A = {}; #declare B = {}; #declare C = {};\n", a, b, c);
}

/// What the reader says but for the place: a function's text stands elsewhere, on a line of its own.
std::string complaint(const std::string& text) {
    const std::string error = error_of(text);
    return error.substr(std::min(error.size(), error.find(": ")));
}

TEST(Formula, GivesWhatItsTextGives) {
    Expressions expressions;
    std::mt19937 random(3);
    int values = 0, errors = 0;
    for (int n = 0; n < 3000; ++n) {
        const std::string expression = expressions.sum(n % 3);
        const auto number = [&] { return std::uniform_real_distribution(-2.0, 2.0)(random); };
        const double a = number(), b = number(), c = n % 5 == 0 ? 0 : number();
        const std::string read_at_once = kGiven + declared(a, b, c) + "#declare V = " + expression + ";\n";
        const std::string called = kGiven + "#declare F = function(A, B, C) {\n" + expression + "\n}\n" +
                                   declared(a, b, c) + "#declare V = F(A, B, C);\n";
        const std::string show = "sphere { V*x, 1 }";
        ASSERT_EQ(complaint(called + show), complaint(read_at_once + show)) << expression;
        if (!error_of(called + show).empty()) {
            ++errors;
            continue;
        }
        ++values;
        const double expected = scene_of(read_at_once + show).spheres[0].center.x;
        const double found = scene_of(called + show).spheres[0].center.x;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(found), std::bit_cast<std::uint64_t>(expected))
            << expression << " of " << a << ", " << b << ", " << c << ": " << found << ", not " << expected;
    }
    EXPECT_GT(values, 1400);
    EXPECT_GT(errors, 300);
}

TEST(Formula, ComplaintsNameThePlaceInTheFunction) {
    EXPECT_EQ(error_of("#declare F = function(x) {\n 1/x }\nsphere { F(0)*x, 1 }"), "test.pov:2:3: division by zero");
    EXPECT_EQ(error_of("#declare F = function(x) { 2 }\nsphere { F(1 2), 1 }").substr(0, 14), "test.pov:2:14:");
}

TEST(Formula, WhatIsNoFloatIsReadAgain) {
    EXPECT_EQ(scene_of("#declare V = <1, 2, 3>; #declare F = function(x) { vdot(V, V)*x + V.y } sphere { F(2)*x, 1 }")
                  .spheres[0]
                  .center.x,
              30);
    EXPECT_EQ(scene_of("#declare F = function { x + 10*y + 100*z } sphere { F(1, 2, 3)*x, 1 }").spheres[0].center.x,
              321);
}

TEST(Formula, VariablesAreThoseOfItsDefinition) {
    EXPECT_EQ(scene_of("#declare D = 1; #declare F = function(x) { D + x } #declare D = 5; sphere { F(2)*x, 1 }")
                  .spheres[0]
                  .center.x,
              3);
}

TEST(Formula, TimeInAFunctionIsTime) {
    const Scene scene = scene_of("#declare F = function(x) { x + 3*Time } sphere { F(2)*x, 1 }");
    EXPECT_FALSE(scene.varying.empty());
}

}  // namespace
}  // namespace rays
