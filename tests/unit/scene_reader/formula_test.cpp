// Functions are worked out once where they can be. What a call gives, and what it complains about, is what its text
// says.
#include <fmt/format.h>

#include <bit>
#include <cstring>
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

// ---- text that repeats

/// Of vectors, arrays, macros and random numbers as well.
class RepeatedExpressions {
public:
    std::string vector(int depth) {
        std::string text = factor(depth);
        for (int n = below(3); n > 0; --n) text += one_of({" + ", " - ", "*", "*", "/"}) + factor(depth);
        return text;
    }

private:
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    std::string one_of(std::initializer_list<const char*> words) { return words.begin()[below(int(words.size()))]; }
    std::string number(int depth) {
        const std::string made = vector(depth - 1);
        switch (below(4)) {
            case 0: return "vlength(" + made + ")";
            case 1: return "vdot(" + made + ", " + vector(depth - 1) + ")";
            case 2: return one_of({"int", "sin", "sqrt"}) + "((" + made + ").y)";
            default: return "(" + made + ")" + one_of({".x", ".y", ".z", ".t"});
        }
    }
    std::string factor(int depth) {
        if (below(8) == 0) return one_of({"-", "+", "!"}) + factor(depth);
        if (depth <= 0 || below(3) == 0)
            return one_of({"A",       "B",       "V",           "V",   "U",    "x",
                           "y",       "2.5",     "0",           "K",   "P[K]", "P[int(A + K)]",
                           "Q[K][1]", "rand(R)", "Twice(A, B)", "V.z", "-V.x", "<A, K, 2>",
                           "P[2].y",  "Unknown", "on"});
        switch (below(8)) {
            case 0: return "(" + vector(depth - 1) + ")";
            case 1: return "<" + number(depth) + ", " + number(depth) + " " + number(depth) + ">";
            case 2: return "M(" + vector(depth - 1) + ", V)";
            case 3: return "N(P, " + one_of({"K", "0", "K + 0.5"}) + ")";
            case 4: return "vcross(" + vector(depth - 1) + ", V)";
            case 5:
                return one_of({"vnormalize(V + ", "vrotate(V, ", "vaxis_rotate(V, y, K + 0*vlength("}) +
                       vector(depth - 1) + ")";
            case 6:
                return "(" + number(depth) + one_of({" < ", " >= ", " = "}) + number(depth) + " ? " +
                       vector(depth - 1) + " : " + vector(depth - 1) + ")";
            default: return one_of({"div", "mod", "select"}) + "(" + number(depth) + ", " + number(depth) + ")";
        }
    }

    std::mt19937 random_{11};
};

const std::string kRepeatedGiven =
    "#declare R = seed(3); #declare Twice = function(p, q) { 2*p + 0.25*q }\n"
    "#macro M(S, T) (S*2 + T/(1 + K)) #end #macro N(Of, I) M(Of[I], Of[2] - I) #end\n"
    "#declare A = 0.3; #declare B = -1.7; #declare V = <1.25, -2, 3>; #declare U = <4, 5>;\n"
    "#declare P = array[4] { <1, 2, 3>, <-4, 5, 6>, <7, 8, -9>, y } #declare Q = array[3][2] { {1, 2}, {3, 4}, {5, 6} "
    "}\n";

/// Spheres where the expression says, for K from 0 to 2: in a loop, or written three times.
std::string spheres(const std::string& expression, bool loops) {
    const std::string body = "sphere { " + expression + ", 1 }\n#declare W = " + expression +
                             ";\nsphere { W, 1 + abs(" + expression + ") }\n#declare A = A + 0.6;\n";
    std::string text = kRepeatedGiven + "#declare K = 0;\n";
    if (loops) return text + "#while (K < 3)\n" + body + "#declare K = K + 1;\n#end\n";
    for (int k = 0; k < 3; ++k) text += body + "#declare K = K + 1;\n";
    return text;
}

TEST(Formula, WhatRepeatsIsWhatIsWrittenThreeTimes) {
    RepeatedExpressions expressions;
    int values = 0, errors = 0;
    for (int n = 0; n < 4000; ++n) {
        const std::string expression = expressions.vector(n % 3);
        const std::string looped = spheres(expression, true), written = spheres(expression, false);
        ASSERT_EQ(complaint(looped), complaint(written)) << looped;
        if (!error_of(looped).empty()) {
            ++errors;
            continue;
        }
        ++values;
        const auto found = scene_of(looped).spheres, expected = scene_of(written).spheres;
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            ASSERT_EQ(std::memcmp(&found[i].center, &expected[i].center, sizeof found[i].center), 0) << looped << i;
            ASSERT_EQ(found[i].radius, expected[i].radius) << looped << i;
        }
    }
    EXPECT_GT(values, 600);
    EXPECT_GT(errors, 800);
}

TEST(Formula, NamesOfRepeatedTextMayStandForSomethingElse) {
    // A parameter is a float, a vector, an array's element; a macro is defined anew; what was a variable is a function.
    const Scene scene = scene_of(
        "#macro S(X) sphere { 2*X + y, 1 } #end\n"
        "#declare P = array[2] { <1, 2, 3>, 4*x }\n"
        "#declare I = 0; #while (I < 3) S(I) S(<I, 0, I>) S(P[1]) #declare I = I + 1; #end\n"
        "#macro E() (1 + I) #end #declare I = 0;\n"
        "#while (I < 6) #declare W = E(); sphere { W*x, 1 } #if (I = 2) #macro E() (10*I) #end #end #declare I = I + "
        "1; #end\n");
    const auto center = [&](std::size_t i) { return scene.spheres[i].center; };
    for (int i = 0; i < 3; ++i) {
        const std::size_t first = 3 * static_cast<std::size_t>(i);
        EXPECT_TRUE(near(center(first), {2 * i, 2 * i + 1, 2 * i}));
        EXPECT_TRUE(near(center(first + 1), {2 * i, 1, 2 * i}));
        EXPECT_TRUE(near(center(first + 2), {8, 1, 0}));
    }
    for (int i = 0; i < 6; ++i)
        EXPECT_TRUE(near(center(9 + static_cast<std::size_t>(i)), {i <= 2 ? 1 + i : 10 * i, 0, 0}));
}

TEST(Formula, WhatHasNoValueAfterAllDrewNoRandomNumber) {
    // Infinite on the way, which is no error: the text is read instead.
    const std::string body = "sphere { <rand(R), 1/(Big*Big), rand(R)>, 1 }\n";
    const std::string given = "#declare R = seed(1); #declare Big = 1e200; #declare I = 0;\n";
    const auto looped = scene_of(given + "#while (I < 4) " + body + "#declare I = I + 1; #end").spheres;
    const auto written = scene_of(given + body + body + body + body).spheres;
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(looped[i].center, written[i].center);
}

TEST(Formula, AMacroChangesTheVariableItIsGiven) {
    const Scene scene = scene_of(
        "#macro Next(X) #declare X = X + 1; #end #declare P = array[2] { 10, 20 }\n"
        "#declare I = 0; #while (I < 4) sphere { <I, P[0], P[1]>, 1 } Next(I) Next(P[1]) #end");
    ASSERT_EQ(scene.spheres.size(), 4u);
    EXPECT_TRUE(near(scene.spheres[3].center, {3, 10, 23}));
}

TEST(Formula, TheTextBehindIsReadWithIt) {
    // A macro may go on with an operator, and so may what follows a directive.
    const Scene scene = scene_of(
        "#macro More() + 10 #end\n#declare I = 0;\n"
        "#while (I < 3) sphere { I*x, 1 + I More() } sphere { x*(I #if (I > 1) + 5 #end), 1 } #declare I = I + 1; "
        "#end");
    for (int i = 0; i < 3; ++i) {
        const std::size_t first = 2 * static_cast<std::size_t>(i);
        EXPECT_EQ(double(scene.spheres[first].radius), 11 + i);
        EXPECT_EQ(double(scene.spheres[first + 1].center.x), i > 1 ? i + 5 : i);
    }
}

TEST(Formula, ErrorsInRepeatedTextNameTheirPlace) {
    EXPECT_EQ(error_of("#declare I = 4;\n#while (I > -3)\n sphere { x/I, 1 }\n #declare I = I - 1;\n#end"),
              "test.pov:3:12: division by zero");
    EXPECT_EQ(
        error_of("#declare P = array[3] { 1, 2, 3 } #declare I = 0;\n#while (I < 9)\n sphere { P[I]*x, 1 } #declare "
                 "I = I + 1;\n#end"),
        "test.pov:3:13: subscript 3 of an array of 3 elements; count from 0");
}

TEST(Formula, AnArrayMayHaveOtherSizes) {
    EXPECT_TRUE(contains(error_of("#declare A = array[4] { 1, 2, 3, 4 } #declare B = array[2] { 5, 6 }\n"
                                  "#macro S(Of) #declare W = Of[3]; sphere { W*x, 1 } #end S(A) S(A) S(A) S(B)"),
                         "subscript 3 of an array of 2 elements"));
    const Scene scene = scene_of(
        "#declare A = array[2][3] { {0, 1, 2}, {3, 4, 5} } #declare B = array[3][2] { {0, 1}, {2, 3}, {4, 5} }\n"
        "#macro S(Of) #declare W = Of[1][1]; sphere { W*x, 1 } #end S(A) S(A) S(A) S(B)");
    EXPECT_EQ(double(scene.spheres[2].center.x), 4);
    EXPECT_EQ(double(scene.spheres[3].center.x), 3);
}

TEST(Formula, ALoopThatOnlyDrawsEnds) {
    EXPECT_GT(scene_of("#declare R = seed(5); #while (rand(R) < 0.9) sphere { 0, 1 } #end").spheres.size(), 3u);
}

TEST(Formula, TimeInRepeatedTextIsTime) {
    const Scene scene =
        scene_of("#declare I = 0; #while (I < 4) sphere { <I, 3*I*Time, 0>, 1 } #declare I = I + 1; #end");
    EXPECT_EQ(scene.varying.size(), 3u);
    // The text that is worked out need not be the one that was read before.
    EXPECT_FALSE(scene_of("#macro E() (1 + I) #end #declare I = 0;\n"
                          "#while (I < 4) #declare W = E(); sphere { W*x, 1 }\n"
                          "#if (I = 0) #macro E() (3*Time) #end #end #declare I = I + 1; #end")
                     .varying.empty());
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
