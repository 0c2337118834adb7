// Questions about how far the tree of rays goes (3.8): levels, weights, mirrors in a row.
#include <fmt/format.h>

#include <cmath>

#include "questions/step_3.h"

namespace rays::grader::step_3 {
namespace {

/// Two mirrors that shine a little, 10 apart: a ray along z sees share^k of it at level k.
std::string corridor(double share, double glow, int levels, double adc) {
    const std::string look = fmt::format(
        "pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 emission {} reflection {{ {} }} }}", glow, share);
    return world(levels, adc) + plane("-z", -5, look) + plane("z", -5, look);
}

double geometric(double share, int terms) {
    double sum = 0;
    for (int k = terms - 1; k >= 0; --k) sum = 1 + share * sum;
    return sum;
}

/// An adc_bailout that no power of `share` meets: 0.3 * 0.3 in single precision reaches 0.09 or not, depending on who
/// rounds, and both are right. Weights of some ten factors are good to 1e-6.
double off_the_powers(double share, double adc) {
    for (double weight = 1; weight > adc / 2; weight *= share)
        if (std::abs(weight / adc - 1) < 1e-5) return single(1.01 * adc);
    return adc;
}

}  // namespace

std::vector<Question> prunings(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("3.8");
    for (int i = 0; i < 3; ++i) {
        const int most = dice.whole(1, 20);
        const double adc = i == 0 ? 0 : single(dice.round_between(0.005, 0.2));
        notes.scene(world(most, adc));
        const auto ask = [&](int level, double weight, const char* about) {
            notes.ask(fmt::format("pruned {} {}", level, weight), about, says(level >= most || weight < adc));
        };
        ask(0, 1, "the camera's ray is traced");
        ask(most - 1, 1, "the last level below max_trace_level is traced");
        ask(most, 1, "level max_trace_level is not traced");
        ask(most + 5, 1, "nor is any beyond");
        ask(0, 1.01 * adc + 1e-9, "a weight just above adc_bailout is traced");
        ask(0, 0.99 * adc, "a weight just below adc_bailout is not; an adc_bailout of 0 prunes nothing");
        ask(0, adc, "a weight of exactly adc_bailout is traced");
        ask(most, 0, "too deep and too weak");
    }
    for (const int levels : {1, 2, 3, 4, 8}) {
        const double share = dice.round_between(0.4, 0.9), glow = dice.round_between(0.1, 0.9);
        notes.scene(corridor(share, glow, levels, 0));
        notes.ask("radiance 0 0 0 0 0 1", "between mirrors: as many terms of the series as there are levels",
                  grey(glow * geometric(share, levels)));
    }
    for (int i = 0; i < 4; ++i) {
        const double share = dice.round_between(0.3, 0.8),
                     adc = off_the_powers(share, single(dice.round_between(0.004, 0.1)));
        int terms = 0;
        for (double weight = 1; weight >= adc; weight *= share) ++terms;
        notes.scene(corridor(share, 0.5, 200, adc));
        notes.ask("radiance 0 0 0 0 0 1", "between mirrors: terms as long as their weight reaches adc_bailout",
                  grey(0.5 * geometric(share, terms)));
    }
    return notes.take();
}

}  // namespace rays::grader::step_3
