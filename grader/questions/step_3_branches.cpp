// Questions about one branch of the tree of rays: what a mirror shows (3.9), what comes through (3.10).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "questions/step_3.h"

namespace rays::grader::step_3 {
namespace {

/// "OX OY OZ DX DY DZ LEVEL WEIGHT N O1 .." of a ray on its way.
std::string on_its_way(const V& origin, const V& direction, int level, double weight, const std::string& media = "0") {
    return fmt::format("{} {} {} {} {}", numbers(origin), numbers(direction), level, weight, media);
}

/// A black plane z = 0 that mirrors, seen from z < 0.
std::string mirror(const std::string& reflection, const std::string& more = "") {
    return plane(
        "z", 0,
        fmt::format("pigment {{ rgb 0 }} finish {{ ambient 0 diffuse 0 reflection {{ {} }} {} }}", reflection, more));
}

double largest(const V& v) { return std::max(v.x, std::max(v.y, v.z)); }

class Transmissions {
public:
    Transmissions(Notebook& notes, Dice& dice) : notes_(notes), dice_(dice) {}

    void bends_into_water() {
        turn_ = dice_.between(0, 6);
        const double n = single(dice_.round_between(1.2, 2.2)), angle = dice_.between(0.1, 1.3);
        const V in = at(angle), inner = at(angle_behind(angle, n)), glow = dice_.color(), tint = dice_.color();
        notes_.scene(world() + pool(n, "") + lamp(4.0 * inner, glow));
        ask(on_its_way(-3.0 * in, in, 0, 1), tint, tint * glow, 0, false, "bent by Snell's law into the glass, tinted");
    }
    void bends_out_of_water() {
        turn_ = dice_.between(0, 6);
        const double n = single(dice_.round_between(1.2, 2.2)),
                     angle = dice_.between(0.1, 0.95) * critical_angle(1 / n);
        const V in = -at(angle), out = -at(angle_behind(angle, 1 / n)), glow = dice_.color(), tint = dice_.color();
        notes_.scene(world() + pool(n, "") + lamp(4.0 * out, glow));
        ask(on_its_way(-3.0 * in, in, 0, 1, "1 0"), tint, tint * glow, 0, false,
            "bent by Snell's law out of the glass");
    }
    void goes_straight() {
        turn_ = dice_.between(0, 6);
        const double angle = dice_.between(0.1, 1.4);
        const V in = at(angle), glow = dice_.color(), tint = dice_.color();
        const int levels = 3;
        notes_.scene(world(levels) + plane("z", 0, "inverse pigment { rgbt 1 } finish { ambient 0 diffuse 0 }") +
                     lamp(4.0 * in, glow));
        ask(on_its_way(-3.0 * in, in, levels - 2, 1), tint, tint * glow, 0, false, "index 1: straight on");
    }
    void is_mirrored_totally() {
        turn_ = dice_.between(0, 6);
        const double n = single(dice_.round_between(1.3, 2.2));
        const double angle = critical_angle(1 / n) + dice_.between(0.05, 0.9) * (1.5 - critical_angle(1 / n));
        const V in = -at(angle), back(in.x, in.y, -in.z), glow = dice_.color(), tint = dice_.color();
        notes_.scene(world() + pool(n, "fade_distance 1 fade_power 1001 fade_color rgb <0.9, 0.6, 0.3>") +
                     lamp(4.0 * back, glow));
        const V left(std::exp(-0.1 * 3), std::exp(-0.4 * 3), std::exp(-0.7 * 3));
        ask(on_its_way(-3.0 * in, in, 0, 1, "1 0"), tint, left * glow, 0, true,
            "total reflection: the mirror direction, untinted; absorbed on the way before it");
    }
    void absorbs_within() {
        const double depth = dice_.round_between(0.5, 3);
        const V sky = dice_.color(), tint = dice_.color();
        notes_.scene(world(10, 0, rgb(sky)) +
                     pool(1.4, "fade_distance 1 fade_power 1001 fade_color rgb <0.2, 0.5, 0.8>"));
        const V left(std::exp(-0.8 * depth), std::exp(-0.5 * depth), std::exp(-0.2 * depth));
        ask(on_its_way({0, 0, depth}, {0, 0, -1}, 0, 1, "1 0"), tint, tint * left * sky, 0, false,
            "out of the glass: absorbed over the way within it");
        ask(on_its_way({0, 0, -depth}, {0, 0, 1}, 0, 1), tint, tint * sky, 0, false,
            "into the glass: nothing was absorbed outside");
    }
    void is_pruned() {
        const V sky = dice_.color();
        V tint = dice_.color();
        const double weight = dice_.round_between(0.2, 1), adc = 0.1;
        if (largest(tint) < 1.1 * adc) tint = 3.0 * tint;  // else it is pruned at every level
        notes_.scene(world(6, adc, rgb(sky)) + pool(1.5, ""));
        ask(on_its_way({0, 0, -1}, {0, 0, 1}, 4, 1), tint, tint * sky, 0, false, "one level below the last: traced");
        ask(on_its_way({0, 0, -1}, {0, 0, 1}, 5, weight), tint, V(0), weight * largest(tint), false,
            "too deep: black; the weight times the largest lane of the tint is missing");
        const V faint = 0.09 / largest(tint) * tint;
        ask(on_its_way({0, 0, -1}, {0, 0, 1}, 0, 1), faint, V(0), 0.09, false, "too small a share: black");
    }

private:
    V at(double angle) const {
        return {std::sin(angle) * std::cos(turn_), std::sin(angle) * std::sin(turn_), std::cos(angle)};
    }
    /// Glass where z > 0. POV-Ray's planes are full on the side away from their normal.
    static std::string pool(double ior, const std::string& fade) {
        return plane(
            "-z", 0,
            fmt::format("pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 }} interior {{ ior {} {} }}", ior, fade));
    }
    static std::string lamp(const V& at, const V& glow) {
        return sphere(at, 0.1, "rgb 1", fmt::format("ambient 0 diffuse 0 emission {}", rgb(glow)));
    }
    void ask(const std::string& way, const V& tint, const V& truth, double pruned, bool total, const char* about) {
        notes_.ask("transmitted " + way + " " + numbers(tint), about,
                   starts_with({truth.x, truth.y, truth.z, pruned, total ? 1.0 : 0.0}, 5, kLight));
    }

    Notebook& notes_;
    Dice& dice_;
    double turn_ = 0;
};

}  // namespace

std::vector<Question> reflections(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("3.9");
    const auto ask = [&](const std::string& way, const V& share, const V& brought, double pruned, const char* about) {
        notes.ask("reflected " + way + " " + numbers(share), about,
                  starts_with({share.x * brought.x, share.y * brought.y, share.z * brought.z, pruned}, 4, kLight));
    };
    for (int i = 0; i < 8; ++i) {
        // A small shining ball where the mirror direction leads, and only there.
        const double angle = dice.between(0.1, 1.3), turn = dice.between(0, 6);
        const V in(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle));
        const V out(in.x, in.y, -in.z), glow = dice.color(), share = dice.color();
        notes.scene(world() + mirror("0.7") +
                    sphere(4.0 * out, 0.1, "rgb 1", fmt::format("ambient 0 diffuse 0 emission {}", rgb(glow))));
        ask(on_its_way(-3.0 * in, in, 0, 1), share, glow, 0,
            "what stands in the mirror direction, times the reflectivity");
    }
    for (int i = 0; i < 6; ++i) {
        const V sky = dice.color(), share = dice.color(), low = dice.color(), high = dice.color();
        const int levels = dice.whole(2, 9);
        const double weight = dice.round_between(0.1, 1);
        const bool fresnel = i % 2 == 1;
        notes.scene(world(levels, 0, rgb(sky)) +
                    mirror(fmt::format("{}, {} {}", rgb(low), rgb(high), fresnel ? "fresnel on" : "falloff 2")));
        const V in = tilted(V(0, 0, 1), 0.5, dice.between(0, 6));
        ask(on_its_way(-in, in, levels - 2, weight), share, sky, 0, "one level below the last: traced");
        const double whole = fresnel ? largest(share) : std::max(largest(low), largest(high));
        ask(on_its_way(-in, in, levels - 1, weight), share, V(0), weight * whole,
            fresnel ? "too deep: black, and the weight times the largest lane of the reflectivity is missing"
                    : "too deep: black, and the weight times the largest lane of min and max is missing");
    }
    for (int i = 0; i < 4; ++i) {
        const V sky = dice.color(), share = dice.color();
        const double adc = 0.05, weight = i < 2 ? 0.09 : 0.12;
        notes.scene(world(10, adc, rgb(sky)) + mirror("0.5"));
        ask(on_its_way({0, 0, -1}, {0, 0, 1}, 0, weight), share, i < 2 ? V(0) : sky, i < 2 ? 0.5 * weight : 0,
            "pruned when the weight times the finish's reflection is below adc_bailout");
    }
    for (int i = 0; i < 3; ++i) {
        const V sky = dice.color(), share = dice.color();
        const double exponent = dice.round_between(0.4, 2.5);
        notes.scene(world(10, 0, rgb(sky)) + mirror("0.8", fmt::format("reflection_exponent {}", exponent)));
        ask(on_its_way({0, 0, -1}, {0, 0, 1}, 0, 1), share,
            V(std::pow(sky.x, 1 / exponent), std::pow(sky.y, 1 / exponent), std::pow(sky.z, 1 / exponent)), 0,
            "the exponent is applied to what the ray brings, before the reflectivity");
    }
    for (int i = 0; i < 3; ++i) {
        // A mirror on the ground of a pool: up again, and out of the water by Snell's law.
        const double n = single(dice.round_between(1.2, 1.8)), inner = dice.between(0.1, 0.9) * critical_angle(1 / n);
        const double outer = angle_behind(inner, 1 / n);
        const V down(std::sin(inner), 0, std::cos(inner)), exit(2 * std::tan(inner), 0, 0), glow = dice.color(),
                                                                                            share = dice.color();
        notes.scene(
            world() +
            fmt::format(
                "plane {{ -z, 0 pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 }} interior {{ ior {} }} }}\n", n) +
            "plane { -z, -2 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 1 } } }\n" +
            sphere(exit + 4.0 * V(std::sin(outer), 0, -std::cos(outer)), 0.1, "rgb 1",
                   fmt::format("ambient 0 diffuse 0 emission {}", rgb(glow))));
        ask(on_its_way(V(0, 0, 2) - down, down, 0, 1, "1 0"), share, glow, 0,
            "the mirror ray is in the media of the ray that came");
    }
    return notes.take();
}

std::vector<Question> transmissions(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("3.10");
    Transmissions ask(notes, dice);
    for (int i = 0; i < 4; ++i) {
        ask.bends_into_water();
        ask.bends_out_of_water();
        ask.is_mirrored_totally();
    }
    for (int i = 0; i < 2; ++i) {
        ask.goes_straight();
        ask.absorbs_within();
        ask.is_pruned();
    }
    for (int i = 0; i < 4; ++i) {
        // Through a slab: parallel to itself, moved sideways by t sin(a) (1 - cos(a) / sqrt(n^2 - sin(a)^2)).
        const double n = single(dice.round_between(1.2, 2.4)), angle = dice.between(0.1, 1.4);
        const V in(std::sin(angle), 0, std::cos(angle));
        notes.scene(world() + fmt::format("box {{ <-900, -900, 0>, <900, 900, 1> pigment {{ rgbt 1 }} finish {{ "
                                          "ambient 0 diffuse 0 }} interior {{ ior {} }} }}\n",
                                          n));
        const V exit(std::tan(angle_behind(angle, n)), 0, 1);
        notes.ask("last_ray " + numbers(-2.0 * in) + " " + numbers(in),
                  "a slab: out of it in the direction it came in, moved sideways",
                  starts_with({exit.x, 0, 1, in.x, 0, in.z, 3}, 7, kGeometry));
    }
    for (int i = 0; i < 3; ++i) {
        // Straight rays are no levels: sheets before a wall.
        const int sheets = dice.whole(2, 8);
        std::string sdl = world(2) + plane("-z", -20, shining(V(1)));
        for (int k = 0; k < sheets; ++k)
            sdl += fmt::format("disc {{ <0, 0, {}>, z, 5 pigment {{ rgbt 0.9 }} finish {{ ambient 0 diffuse 0 }} }}\n",
                               k + 1);
        notes.scene(sdl);
        notes.ask("radiance 0 0 0 0 0 1", "any number of thin sheets is one level", grey(std::pow(0.9, sheets)));
    }
    return notes.take();
}

}  // namespace rays::grader::step_3
