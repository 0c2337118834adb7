// Questions about the whole tree of rays (3.11): what adds up, and what is missing.
#include <fmt/format.h>

#include <cmath>

#include "questions/step_3.h"

namespace rays::grader::step_3 {
namespace {

/// A slab of glass, 1 thick, between a red wall behind the camera and a green one beyond.
std::string slab(double ior, int levels, const std::string& finish, const std::string& tint = "rgbt 1",
                 const std::string& fade = "") {
    return world(levels) +
           fmt::format(
               "box {{ <-900, -900, 0>, <900, 900, 1> pigment {{ {} }} finish {{ ambient 0 diffuse 0 {} }} interior {{ "
               "ior {} {} }} }}\n",
               tint, finish, ior, fade) +
           plane("z", -20, shining({1, 0, 0})) + plane("-z", -20, shining({0, 1, 0}));
}

const char* const kConserving = "reflection { 0, 1 fresnel on } conserve_energy";

}  // namespace

std::vector<Question> trees(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("3.11");
    const auto slab_sees = [&](const std::string& ray, const V& truth, const char* about) {
        notes.ask("radiance " + ray, about, close_to(truth));
    };
    for (int i = 0; i < 4; ++i) {
        const double n = single(dice.round_between(1.3, 2.4)), angle = i == 0 ? 0 : dice.between(0.1, 1.2);
        const double r = reflectance(angle, n);
        notes.scene(slab(n, 60, kConserving));
        slab_sees(numbers({0, 0, -5}) + " " + numbers({std::sin(angle), 0, std::cos(angle)}),
                  {2 * r / (1 + r), (1 - r) / (1 + r), 0},
                  "a slab of glass: T = (1 - R) / (1 + R), the rest comes back");
    }
    for (const int levels : {2, 3, 4, 5, 6, 7}) {
        // Level 0 meets the slab, level 1 goes through it, level 2 leaves; two levels more for each round trip.
        const double n = single(dice.round_between(1.3, 2.4)), r = reflectance(0, n);
        double through = 0, back = levels >= 2 ? r : 0;
        for (int k = 0; 3 + 2 * k <= levels; ++k) through += (1 - r) * (1 - r) * std::pow(r, 2 * k);
        for (int k = 0; 4 + 2 * k <= levels; ++k) back += (1 - r) * (1 - r) * std::pow(r, 2 * k + 1);
        notes.scene(slab(n, levels, kConserving));
        slab_sees("0 0 -5 0 0 1", {back, through, 0}, "a slab: one more term of the series every second level");
    }
    for (int i = 0; i < 3; ++i) {
        const double r = dice.round_between(0.1, 0.6);
        const V paint = dice.color(), tint = (1 - r) * 0.8 * paint;
        notes.scene(world(3) +
                    fmt::format("disc {{ 0, z, 5 pigment {{ rgbf <{}, {}, {}, 0.8> }} finish {{ ambient 0 diffuse 0 "
                                "reflection {{ {} }} conserve_energy }} }}\n",
                                paint.x, paint.y, paint.z, r) +
                    plane("z", -20, shining({1, 0, 0})) + plane("-z", -20, shining({0, 1, 0})));
        slab_sees("0 0 -5 0 0 1", {r, tint.y, 0}, "conserve_energy: what is mirrored does not come through as well");
    }
    for (int i = 0; i < 3; ++i) {
        const double r = dice.round_between(0.1, 0.6), t = dice.round_between(0.2, 0.9),
                     glow = dice.round_between(0.1, 0.5);
        notes.scene(world(3) +
                    fmt::format("disc {{ 0, z, 5 pigment {{ rgbt <1, 1, 1, {}> }} finish {{ ambient 0 diffuse 0 "
                                "emission {} reflection {{ {} }} }} }}\n",
                                t, glow, r) +
                    plane("z", -20, shining({1, 0, 0})) + plane("-z", -20, shining({0, 1, 0})));
        const double own = (1 - t) * glow;
        slab_sees("0 0 -5 0 0 1", {r + own, t + own, own},
                  "own light, what is mirrored and what comes through are added");
    }
    for (int i = 0; i < 4; ++i) {
        const double n = single(dice.round_between(1.2, 2.4));
        notes.scene(world(40, 0, "rgb 1") + "sphere { 0, 1 " + lossless(n) + " }\n");
        const V target = dice.between(0, 0.95) * dice.unit(), from = 4.0 * dice.unit();
        slab_sees(numbers(from) + " " + numbers(target - from), V(1),
                  "the furnace: lossless glass in uniform light is not to be seen");
    }
    for (int i = 0; i < 2; ++i) {
        const int levels = dice.whole(2, 4);
        notes.scene(world(levels, 0, "rgb 1") + "sphere { 0, 1 " + lossless(1.5) + " }\n");
        const V target = 0.8 * dice.unit(), from = 4.0 * dice.unit();
        notes.ask("residual " + numbers(from) + " " + numbers(target - from),
                  "the furnace: what is missing is the weight of what was not traced", [](const Answer& a) {
                      Judgement j{false, 1, "radiance + pruned = 1"};
                      if (a.kind != Answer::Kind::value || a.numbers.size() != 4) return j;
                      j.error = std::abs(a.numbers[0] + a.numbers[3] - 1);
                      j.ok = j.error <= 1e-5 && a.numbers[3] > 0;
                      return j;
                  });
    }
    {
        // From within glass, beyond the critical angle: all of it comes back, once.
        const V in(std::sin(1.0), 0, -std::cos(1.0));
        notes.scene(world(10, 0) + "plane { -z, 0 " + lossless(1.5) + " }\n" + plane("-z", -20, shining({0, 1, 0})) +
                    plane("z", -20, shining({1, 0, 0})));
        slab_sees(numbers({0, 0, 2}) + " " + numbers(in), {0, 1, 0},
                  "total reflection: the mirror ray is traced once, not twice");
    }
    for (int i = 0; i < 2; ++i) {
        // A constant reflection does not know of total reflection: only the one mirror ray may be added.
        const double angle = dice.between(0.9, 1.4), share = dice.round_between(0.2, 0.6);
        notes.scene(
            world(10, 0) +
            fmt::format("plane {{ -z, 0 pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 reflection {{ {} }} }} "
                        "interior {{ ior 1.5 }} }}\n",
                        share) +
            plane("-z", -20, shining({0, 1, 0})));
        slab_sees(numbers({0, 0, 2}) + " " + numbers({std::sin(angle), 0, -std::cos(angle)}), {0, 1, 0},
                  "total reflection is all there is: no reflection of the finish is added");
    }
    for (int i = 0; i < 2; ++i) {
        const double blue = dice.round_between(0.5, 1), adc = 0.2;
        notes.scene(
            world(5, adc) +
            fmt::format("disc {{ 0, z, 5 pigment {{ rgbf <0, 0, {}, 1> }} finish {{ ambient 0 diffuse 0 }} }}\n",
                        blue) +
            plane("-z", -20, shining(V(1))));
        slab_sees("0 0 -5 0 0 1", V(0), "the grey of blue is dark: below adc_bailout, though its weight is not");
    }
    for (const double adc : {0.05, 0.3}) {
        notes.scene(world(5, adc) + "disc { 0, z, 5 pigment { rgbt 0.2 } finish { ambient 0 diffuse 0 } }\n" +
                    plane("-z", -20, shining(V(1))));
        slab_sees("0 0 -5 0 0 1", V(adc < 0.2 ? 0.2 : 0),
                  "nothing is traced through a surface whose grey is not above adc_bailout");
        notes.ask("residual 0 0 -5 0 0 1", "what is not traced through a surface counts as pruned",
                  starts_with({adc < 0.2 ? 0.2 : 0, adc < 0.2 ? 0.2 : 0, adc < 0.2 ? 0.2 : 0, adc < 0.2 ? 0 : 0.2}, 4,
                              kLight));
    }
    for (int i = 0; i < 2; ++i) {
        const double filter = dice.round_between(0.3, 0.9);
        const V paint = dice.color();
        notes.scene(
            world(5, 0) + "light_source { <0, 0, -10>, rgb 1 }\n" +
            fmt::format(
                "disc {{ <0, 0, -2>, z, 5 pigment {{ rgbf <{}, {}, {}, {}> }} finish {{ ambient 0 diffuse 0 }} }}\n",
                paint.x, paint.y, paint.z, filter) +
            plane("z", 0, "pigment { rgb 1 } finish { ambient 0 diffuse 1 }"));
        slab_sees("0 0 -1 0 0 1", filter * paint, "light through a clear sheet: its shadow is tinted");
    }
    return notes.take();
}

}  // namespace rays::grader::step_3
