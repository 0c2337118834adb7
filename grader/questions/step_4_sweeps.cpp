// Stability of step 4: where structures lose hits, time or memory.
#include <fmt/format.h>

#include <cmath>

#include "questions/step_4.h"

namespace rays::grader {
namespace {

using namespace step_4;
using construct::number;
using construct::numbers;
using construct::vector;

Question question(const std::string& task, const std::string& objects, const std::string& query,
                  const std::string& about, Judge judge) {
    return {task, construct::scene_of(objects), query, about, std::move(judge)};
}

/// What is charted of a walk that must find a known sphere: how far its t is off.
Judge hits_object(L t, int object, L speed) {
    return [=](const Answer& answer) {
        const std::string expected = fmt::format("hit {} on object {}", number(t), object);
        if (!has(answer, 2) || answer.numbers[1] != object) return verdict(false, expected);
        const L off = std::abs(answer.numbers[0] - t) * speed;
        return verdict(off <= 1e-3L + 1e-14L * t * speed, expected, static_cast<double>(off));
    };
}

/// Spheres on a lattice around the origin, the i-th at a known place, and a ray at one that faces it.
std::string lattice() {
    return "#declare I = 0;\n#while (I < 125)\n"
           "sphere { <mod(I, 5) - 2, mod(floor(I / 5), 5) - 2, floor(I / 25) - 2>, 0.3 }\n#declare I = I + 1;\n#end\n";
}

Question from_afar(const std::string& task, const std::string& structure, Dice& dice, L distance, L zero) {
    const int x = dice.whole(0, 4), y = dice.whole(0, 4);
    const V center(x - 2, y - 2, -2);
    // From the side that nothing hides, at a point of the sphere near its front.
    const V n = glm::normalize(V(dice.between(-0.2, 0.2), dice.between(-0.2, 0.2), -1));
    const V target = center + 0.3L * n;
    const V d = zero < 0 ? glm::normalize(V(dice.between(-0.1, 0.1), dice.between(-0.1, 0.1), 1))
                         : V(dice.coin() ? zero : -zero, dice.coin() ? zero : -zero, 1);
    const construct::Shot shot = construct::aim(target, glm::normalize(d), distance);
    const V exact = zero < 0 ? shot.direction : construct::rounded(d);
    const Beam beam{construct::rounded(target - distance * exact), exact};
    // Where the rounded ray meets the sphere.
    const V o = beam.origin - center;
    const L a = glm::dot(exact, exact), nearest = -glm::dot(o, exact) / a;
    const V past = o + nearest * exact;  // of about the radius: no square of the distance to lose it in
    const L t = nearest - std::sqrt((0.09L - glm::dot(past, past)) / a);
    return question(task, lattice(), fmt::format("nearest_{} {}", structure, beam.text()),
                    "the sphere that was aimed at", hits_object(t, x + 5 * y, glm::length(exact)));
}

Sweep far_origins(const std::string& task, const std::string& structure, Dice& dice) {
    Sweep sweep{task + ".far",
                task,
                "Origins farther and farther away (" + structure + ")",
                "distance of the origin, in cells",
                "distance of the hit from the sphere",
                true,
                true,
                1,
                1e8,
                {}};
    for (int e = 0; e <= 12; ++e) {
        Sweep::Point point{std::pow(10.0, e), {}};
        for (int i = 0; i < 8; ++i) point.questions.push_back(from_afar(task, structure, dice, std::pow(10.0L, e), -1));
        sweep.points.push_back(std::move(point));
    }
    return sweep;
}

Sweep near_zeros(const std::string& task, const std::string& structure, Dice& dice) {
    Sweep sweep{task + ".zeros",
                task,
                "Directions nearer and nearer to an axis (" + structure + ")",
                "the two small components",
                "distance of the hit from the sphere",
                true,
                true,
                1e-300,
                0.01,
                {}};
    for (const int e : {-2, -4, -8, -12, -16, -17, -20, -50, -100, -150, -200, -250, -300, -310}) {
        Sweep::Point point{std::pow(10.0, e), {}};
        for (int i = 0; i < 8; ++i) point.questions.push_back(from_afar(task, structure, dice, 10, std::pow(10.0L, e)));
        sweep.points.push_back(std::move(point));
    }
    return sweep;
}

/// As many primitives in one place, or one in the other: every ray agrees, in the time and the memory of the sandbox.
Sweep crowded(const std::string& task, const std::string& name, const std::string& structure, const std::string& title,
              const std::string& sphere, Dice& dice) {
    Sweep sweep{task + "." + name,
                task,
                title,
                "spheres",
                "rays that differ from asking every primitive",
                true,
                false,
                10,
                3000,
                {}};
    for (const int n : {10, 30, 100, 300, 1000, 3000}) {
        const std::string sdl = fmt::format(
            "#declare N = {};\n#declare I = 0;\n#while (I < N)\nsphere {{ {} }}\n#declare I = I + 1;\n#end\n", n,
            sphere);
        sweep.points.push_back(
            {double(n),
             {question(task, sdl, fmt::format("agreement_{} 100 {} 1", structure, dice.whole(1, 1000000)), title,
                       all_agree())}});
    }
    return sweep;
}

/// Primitives asked for a ray through a cloud of ever more, ever smaller spheres.
Sweep growth(const std::string& task, const std::string& structure, Dice& dice) {
    Sweep sweep{task + ".growth",
                task,
                "Primitives asked for a ray, as their number grows (" + structure + ")",
                "spheres",
                "tests for a ray",
                true,
                true,
                100,
                10000,
                {}};
    for (const int n : {10, 30, 100, 300, 1000, 3000, 10000, 30000}) {
        const auto judge = [n](const Answer& answer) {
            // The cloud is as dense as before: a good walk asks about as many as before. Half a hundred is a lot.
            const double tests = has(answer, 2) ? answer.numbers[0] : INFINITY;
            Judgement j = verdict(tests > 0 && tests <= 50 + 2 * std::cbrt(n),
                                  fmt::format("at most {:.0f} tests for a ray of {}", 50 + 2 * std::cbrt(n), n), tests);
            j.error = tests;
            return j;
        };
        sweep.points.push_back({double(n),
                                {question(task, random_spheres(n, dice.whole(1, 1000)),
                                          fmt::format("effort_{} 200 {}", structure, dice.whole(1, 1000000)),
                                          "a cloud of spheres", judge)}});
    }
    return sweep;
}

Sweep clips_near_zero() {
    Sweep sweep{"4.2.zeros",
                "4.2",
                "A ray nearer and nearer to the planes of a slab",
                "components of the direction",
                "relative error of the exit",
                true,
                true,
                1e-300,
                0.1,
                {}};
    for (const int e : {-1, -4, -8, -16, -32, -64, -128, -200, -250, -300, -307}) {
        Sweep::Point point{std::pow(10.0, e), {}};
        for (int i = 0; i < 6; ++i) {
            const Box box{V(0), V(1)};
            const L small = std::pow(10.0L, e);
            Beam beam{V(0.5L, 0.25L, -2), construct::rounded(V(i & 1 ? small : -small, i & 2 ? small : 0, 1))};
            if (i >= 4)
                beam.origin.x = i == 4 ? 0 : 1,
                beam.direction.x = i == 4 ? std::abs(beam.direction.x) : -std::abs(beam.direction.x);
            const Stretch s = stretch_in(box, beam);
            point.questions.push_back(question(
                "4.2", "sphere { 0, 1 }\n", "clip " + box.text() + " " + beam.text(), "almost in the plane of a face",
                [=](const Answer& answer) {
                    const bool ok =
                        has(answer, 2) && close(answer.numbers[0], s.enter) && close(answer.numbers[1], s.exit);
                    const std::string expected = fmt::format("hit {} {}", number(s.enter), number(s.exit));
                    return verdict(ok, expected,
                                   ok ? static_cast<double>(std::abs(answer.numbers[1] - s.exit) / s.exit) : 0);
                }));
        }
        sweep.points.push_back(std::move(point));
    }
    return sweep;
}

}  // namespace

std::vector<Sweep> sweeps_4_partitioning(std::uint64_t seed) {
    Dice dice(seed * 16 + 15);
    std::vector<Sweep> sweeps{clips_near_zero()};
    sweeps.push_back(
        crowded("4.3", "nested", "grid", "Shells within shells, in a grid", "<0, 1, 0>, 0.2 + I / N", dice));
    sweeps.push_back(far_origins("4.4", "grid", dice));
    sweeps.push_back(near_zeros("4.4", "grid", dice));
    sweeps.push_back(growth("4.4", "grid", dice));
    sweeps.push_back(
        crowded("4.6", "coincident", "octree", "Equal spheres in one place, in an octree", "<1, 2, 3>, 0.5", dice));
    sweeps.push_back(
        crowded("4.6", "nested", "octree", "Shells within shells, in an octree", "<0, 1, 0>, 0.2 + I / N", dice));
    sweeps.push_back(far_origins("4.7", "octree", dice));
    sweeps.push_back(near_zeros("4.7", "octree", dice));
    sweeps.push_back(growth("4.7", "octree", dice));
    return sweeps;
}

}  // namespace rays::grader
