// What fresh scenes are made of: dice that throw short numbers, words of the scene language, recipes.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <string>

namespace rays::grader::fresh {

using V = std::array<double, 3>;

/// Numbers of three decimals: exact in every reader, and easy to read.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double between(double low, double high) {
        const double unit = static_cast<double>(engine_() >> 11) * 0x1p-53;
        return std::round(1000 * (low + (high - low) * unit)) / 1000;
    }
    int whole(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool heads() { return engine_() >> 63; }
    V place(double reach) { return {between(-reach, reach), between(-reach, reach), between(-reach, reach)}; }
    V direction() {
        V v;
        do v = place(1);
        while (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] < 0.1 || v[0] * v[0] + v[1] * v[1] + v[2] * v[2] > 1);
        return v;
    }

private:
    std::mt19937_64 engine_;
};

inline std::string text(const V& v) { return fmt::format("<{}, {}, {}>", v[0], v[1], v[2]); }
inline std::string color(Dice& d) {
    return fmt::format("rgb <{}, {}, {}>", d.between(0.2, 1), d.between(0.2, 1), d.between(0.2, 1));
}

// Matt and bright from every side, so that a picture about shapes depends on shapes and normals only.
inline std::string matt(Dice& d) {
    return fmt::format("pigment {{ {} }} finish {{ ambient 0.2 diffuse 0.7 }}", color(d));
}

inline std::string lamp(Dice& d, const std::string& more = "shadowless") {
    return fmt::format("light_source {{ {}, rgb {} {} }}\n",
                       text({d.between(-9, 9), d.between(6, 12), d.between(-9, 9)}), d.between(0.7, 1), more);
}

/// A scene of a task: what stands in it, and what lights it. Global settings among the things add to the usual ones.
struct Recipe {
    std::function<std::string(Dice&)> things, lamps = [](Dice&d) { return lamp(d); };
    /// Single rays through it tell mistakes apart. Not so where only a structure that is asked for by name makes them.
    bool probes = true;
    bool noisy = false;  ///< its picture is an estimate
};
using Recipes = std::map<std::string, Recipe>;  ///< by task

/// The recipes of step 3.
void add_recursion(Recipes& recipes);
/// And of step 4.
void add_partitioning(Recipes& recipes);
/// And of step 5: their pictures are noisy.
void add_distributed(Recipes& recipes);

}  // namespace rays::grader::fresh
