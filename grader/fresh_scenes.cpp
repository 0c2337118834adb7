#include "grader/fresh_scenes.h"

#include <fmt/format.h>

#include <cmath>

#include "grader/fresh_recipes.h"

namespace rays::grader {
namespace {

using namespace fresh;

constexpr double kTwoPi = 6.283185307179586;

struct View {
    V location{0, 0, -6};
    std::string sdl;
};

View camera(Dice& d) {
    View view;
    const double turn = d.between(0, kTwoPi), height = d.between(-2, 3), away = d.between(5, 7);
    view.location = {std::round(1000 * away * std::sin(turn)) / 1000, height,
                     std::round(1000 * away * std::cos(turn)) / 1000};
    view.sdl = fmt::format("camera {{ perspective location {} right 4/3*x up y angle {} look_at {} }}\n",
                           text(view.location), d.between(45, 60), text(d.place(0.3)));
    return view;
}

// ---- shapes
// ----------------------------------------------------------------------------------------------------------

std::string sphere(Dice& d) {
    return fmt::format("sphere {{ {}, {} {} }}\n", text(d.place(1.4)), d.between(0.3, 0.9), matt(d));
}

std::string plane(Dice& d) {
    return fmt::format("plane {{ {}, {} {} }}\n", text(d.direction()), d.between(-1.5, -0.5), matt(d));
}

std::string triangle(Dice& d) {
    if (d.heads())
        return fmt::format("triangle {{ {}, {}, {} {} }}\n", text(d.place(2)), text(d.place(2)), text(d.place(2)),
                           matt(d));
    return fmt::format("smooth_triangle {{ <-1.6, {}, 0>, {}, <1.5, {}, 0.3>, {}, <0.2, 1.8, {}>, {} {} }}\n",
                       d.between(-1, 0), text({-0.4, 0.1, d.between(-1, -0.6)}), d.between(-1, 0),
                       text({0.4, 0.1, d.between(-1, -0.6)}), d.between(-0.5, 0.5), text({0, 0.5, d.between(-1, -0.6)}),
                       matt(d));
}

std::string contour(Dice& d, double from, double to, int corners) {
    std::string points;
    V first{};
    for (int i = 0; i < corners; ++i) {
        const double angle = kTwoPi * i / corners, radius = d.between(from, to);
        const V p{std::round(1000 * radius * std::cos(angle)) / 1000,
                  std::round(1000 * radius * std::sin(angle)) / 1000, 0};
        if (i == 0) first = p;
        points += text(p) + ", ";
    }
    return points + text(first);
}

// A star with a hole: concave all around.
std::string polygon(Dice& d) {
    const int outer = d.whole(5, 9), inner = d.whole(3, 5);
    return fmt::format("polygon {{ {}, {}, {} rotate {} translate {} {} }}\n", outer + inner + 2,
                       contour(d, 0.8, 2.0, outer), contour(d, 0.2, 0.6, inner),
                       text({d.between(0, 360), d.between(0, 360), d.between(0, 360)}), text(d.place(0.8)), matt(d));
}

std::string box_or_disc(Dice& d) {
    if (d.heads()) {
        const V a = d.place(1.2);
        return fmt::format("box {{ {}, {} {} }}\n", text(a),
                           text({a[0] + d.between(0.4, 1.5), a[1] + d.between(0.4, 1.5), a[2] + d.between(0.4, 1.5)}),
                           matt(d));
    }
    const double radius = d.between(0.6, 1.6);
    return fmt::format("disc {{ {}, {}, {}, {} {} }}\n", text(d.place(1)), text(d.direction()), radius,
                       d.heads() ? d.between(0.1, 0.5) : 0.0, matt(d));
}

std::string cone(Dice& d) {
    const char* open = d.heads() ? " open" : "";
    if (d.heads())
        return fmt::format("cylinder {{ {}, {}, {}{} {} }}\n", text(d.place(1.4)), text(d.place(1.4)),
                           d.between(0.2, 0.7), open, matt(d));
    return fmt::format("cone {{ {}, {}, {}, {}{} {} }}\n", text(d.place(1.4)), d.between(0.4, 1), text(d.place(1.4)),
                       d.heads() ? 0.0 : d.between(0.1, 0.3), open, matt(d));
}

// Ellipsoids, cylinders and hyperboloids, slightly sheared.
std::string quadric(Dice& d) {
    const double k = d.heads() ? d.between(0.4, 1.5) : -d.between(0.1, 0.6);
    return fmt::format("quadric {{ <{}, {}, {}>, <{}, {}, {}>, {}, {} {} }}\n", d.between(0.5, 2), d.between(0.5, 2), k,
                       d.between(-0.4, 0.4), d.between(-0.4, 0.4), d.between(-0.4, 0.4), text(d.place(0.3)),
                       d.between(-1.5, -0.5), matt(d));
}

std::string torus(Dice& d) {
    return fmt::format("torus {{ {}, {} rotate {} translate {} {} }}\n", d.between(0.8, 1.4), d.between(0.15, 0.6),
                       text({d.between(0, 360), d.between(0, 360), 0}), text(d.place(0.6)), matt(d));
}

std::string patch(Dice& d) {
    std::string points;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            points += fmt::format(", {}", text({-1.8 + 1.2 * column + d.between(-0.3, 0.3),
                                                -1.8 + 1.2 * row + d.between(-0.3, 0.3), d.between(-0.9, 0.9)}));
    return fmt::format("bicubic_patch {{ type 1 flatness 0 u_steps 5 v_steps 5{} {} }}\n", points, matt(d));
}

std::string transformed(Dice& d) {
    return fmt::format(
        "sphere {{ 0, 0.8 scale <{}, {}, {}> rotate {} matrix <1, {}, 0, 0, 1, {}, {}, 0, 1, 0, 0, 0> translate {} {} "
        "}}\n",
        d.between(0.4, 1.8), d.between(0.4, 1.8), d.between(0.4, 1.8),
        text({d.between(0, 360), d.between(0, 360), d.between(0, 360)}), d.between(-0.5, 0.5), d.between(-0.5, 0.5),
        d.between(-0.5, 0.5), text(d.place(1)), matt(d));
}

// A closed octahedron, its corners pulled.
std::string mesh(Dice& d) {
    const V right{d.between(1, 2), 0, 0}, left{-d.between(1, 2), 0, 0}, top{0, d.between(1, 2), 0},
        bottom{0, -d.between(1, 2), 0}, back{0, 0, d.between(1, 2)}, front{0, 0, -d.between(1, 2)};
    std::string points;
    for (const V& v : {right, left, top, bottom, back, front}) points += ", " + text(v);
    return fmt::format(
        "mesh2 {{ vertex_vectors {{ 6{} }} face_indices {{ 8, <0,2,5>, <2,1,5>, <1,3,5>, <3,0,5>, <2,0,4>, <1,2,4>, "
        "<3,1,4>, <0,3,4> }} {} }}\n",
        points, matt(d));
}

// Two or three shapes, one of them clipped.
std::string several(Dice& d) {
    return sphere(d) + box_or_disc(d) +
           fmt::format("sphere {{ {}, {} clipped_by {{ plane {{ {}, {} }} }} {} }}\n", text(d.place(0.6)),
                       d.between(0.8, 1.4), text(d.direction()), d.between(-0.2, 0.4), matt(d));
}

// ---- light
// -----------------------------------------------------------------------------------------------------------

std::string lit(Dice& d, const std::string& pigment, const std::string& finish) {
    std::string things;
    for (int i = 0; i < 2; ++i)
        things += fmt::format("sphere {{ {}, {} pigment {{ {} }} finish {{ {} }} }}\n", text(d.place(1.3)),
                              d.between(0.6, 1.2), pigment.empty() ? color(d) : pigment, finish);
    return things;
}

std::string checkers(Dice& d) {
    return lit(d,
               fmt::format("checker {}, {} scale {} rotate {} translate {}", color(d), color(d), d.between(0.2, 0.6),
                           text({d.between(5, 85), d.between(5, 85), d.between(5, 85)}), text(d.place(0.2))),
               "ambient 0.3 diffuse 0.6");
}
std::string ambient(Dice& d) {
    return lit(d, "",
               fmt::format("ambient rgb {} emission {} diffuse 0.3",
                           text({d.between(0, 0.6), d.between(0, 0.6), d.between(0, 0.6)}), d.between(0, 0.4)));
}
std::string diffuse(Dice& d) { return lit(d, "", fmt::format("ambient 0 diffuse {}", d.between(0.3, 1))); }
std::string phong(Dice& d) {
    return lit(d, "",
               fmt::format("ambient 0.05 diffuse 0.4 phong {} phong_size {} metallic {}", d.between(0.4, 1),
                           d.between(2, 60), d.heads() ? d.between(0.3, 1) : 0.0));
}
std::string blinn(Dice& d) {
    return lit(d, "",
               fmt::format("ambient 0.05 diffuse 0.4 specular {} roughness {} metallic {}", d.between(0.4, 1),
                           d.between(0.01, 0.2), d.heads() ? d.between(0.3, 1) : 0.0));
}

std::string fading_lamp(Dice& d) {
    return lamp(d, fmt::format("fade_distance {} fade_power {} shadowless", d.between(2, 9), d.whole(1, 3)));
}
std::string spot(Dice& d) {
    const double radius = d.between(3, 10);
    return lamp(d, fmt::format("spotlight point_at {} radius {} falloff {} tightness {} shadowless", text(d.place(0.8)),
                               radius, radius + d.between(1, 9), d.between(0, 3)));
}
std::string parallel(Dice& d) { return lamp(d, fmt::format("parallel point_at {} shadowless", text(d.place(0.8)))); }
std::string room(Dice& d) { return fmt::format("plane {{ y, -2 {} }}\n", matt(d)); }

const Recipes& recipes() {
    const auto twice = [](std::string (*make)(Dice&)) { return [make](Dice& d) { return make(d) + make(d); }; };
    static const Recipes table = [&] {
        Recipes all{
            {"1.1", {[](Dice& d) { return sphere(d) + sphere(d) + plane(d); }}},
            {"1.2", {[](Dice& d) { return sphere(d) + sphere(d) + plane(d); }}},
            {"1.3", {[](Dice& d) { return sphere(d) + sphere(d) + sphere(d); }}},
            {"1.4", {twice(plane)}},
            {"1.5", {twice(triangle)}},
            {"1.6", {twice(polygon)}},
            {"1.7", {twice(box_or_disc)}},
            {"1.8", {twice(cone)}},
            {"1.9", {quadric}},
            {"1.10", {twice(torus)}},
            {"1.11", {patch}},
            {"1.12", {twice(transformed)}},
            {"1.14", {mesh}},
            {"1.15", {several}},
            {"2.1", {checkers}},
            {"2.2", {ambient}},
            {"2.3", {diffuse}},
            {"2.4", {phong}},
            {"2.5", {blinn}},
            {"2.6", {diffuse, fading_lamp}},
            {"2.7", {[](Dice& d) { return room(d) + diffuse(d); }, spot}},
            {"2.8",
             {[](Dice& d) { return room(d) + diffuse(d); }, [](Dice& d) { return parallel(d) + fading_lamp(d); }}},
            {"2.9",
             {[](Dice& d) {
                  return room(d) + sphere(d) + torus(d) +
                         fmt::format("box {{ <-0.4, 2, -0.4>, <0.4, 2.2, 0.4> no_shadow {} }}\n", matt(d));
              },
              [](Dice& d) { return lamp(d, ""); }}},
            {"2.10",
             {[](Dice& d) { return room(d) + phong(d) + blinn(d); },
              [](Dice& d) { return lamp(d, "") + lamp(d, "") + spot(d); }}},
        };
        add_recursion(all);
        add_partitioning(all);
        add_distributed(all);
        return all;
    }();
    return table;
}

std::string orthographic(Dice& d, View& view) {
    view.location = {d.between(-3, 3), d.between(-1, 3), d.between(-6, -4)};
    return fmt::format("camera {{ orthographic location {} right {}*x up {}*y look_at 0 }}\n", text(view.location),
                       d.between(4.5, 6), d.between(3.2, 4.5));
}

}  // namespace

std::optional<FreshScene> fresh_scene(const std::string& task, std::uint64_t seed) {
    const auto recipe = recipes().find(task);
    if (recipe == recipes().end()) return {};
    std::uint64_t mixed = seed;
    for (const char c : task) mixed = mixed * 1099511628211u + static_cast<unsigned char>(c);
    Dice dice(mixed);
    FreshScene scene;
    View view = camera(dice);
    if (task == "1.2") view.sdl = orthographic(dice, view);
    if (task == "5.7")
        view.sdl.replace(view.sdl.rfind('}'), 1,
                         fmt::format("aperture {} focal_point {} }}", dice.between(0.4, 1.6), text(dice.place(1))));
    scene.sdl = "#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\nbackground { rgb <0.1, 0.15, 0.25> }\n" +
                view.sdl + recipe->second.lamps(dice) + recipe->second.things(dice);
    for (int i = 0; i < kProbes; ++i) {
        const V target = dice.place(1.2);
        scene.rays.push_back(fmt::format("{} {} {} {} {} {}", view.location[0], view.location[1], view.location[2],
                                         target[0] - view.location[0], target[1] - view.location[1],
                                         target[2] - view.location[2]));
    }
    return scene;
}

bool has_noisy_fresh_scenes(const std::string& task) {
    const auto recipe = recipes().find(task);
    return recipe != recipes().end() && recipe->second.noisy;
}

std::vector<Question> probe_questions(const std::vector<std::string>& tasks, std::uint64_t seed) {
    std::vector<Question> questions;
    for (const std::string& task : tasks) {
        const auto recipe = recipes().find(task);
        if (recipe == recipes().end() || !recipe->second.probes) continue;
        for (std::uint64_t i = 0; i < kProbeScenes; ++i) {
            const auto scene = fresh_scene(task, seed + i);
            for (const std::string& ray : scene->rays)
                questions.push_back({task, scene->sdl, "radiance " + ray, "a ray through a fresh scene", {}});
        }
    }
    return questions;
}

}  // namespace rays::grader
