// Fresh scenes of mirrors and glass.
#include "grader/fresh_recipes.h"

namespace rays::grader::fresh {
namespace {

const char* const kDeep = "global_settings { max_trace_level 8 adc_bailout 0 }\n";

std::string floor_of(Dice& d) {
    return fmt::format(
        "plane {{ y, -1.6 pigment {{ checker {}, {} translate 0.013 }} finish {{ ambient 0.2 diffuse 0.6 }} }}\n",
        color(d), color(d));
}

std::string ball(Dice& d, const std::string& look) {
    return fmt::format("sphere {{ {}, {} {} }}\n", text(d.place(1.3)), d.between(0.4, 0.9), look);
}
std::string block(Dice& d, const std::string& look) {
    return fmt::format("box {{ -{0}, {0} rotate {1} translate {2} {3} }}\n", d.between(0.4, 0.9),
                       text({d.between(5, 85), d.between(5, 85), d.between(5, 85)}), text(d.place(1)), look);
}
std::string matt_ball(Dice& d) { return ball(d, matt(d)); }

std::string mirror(Dice& d) {
    return fmt::format("pigment {{ {} }} finish {{ ambient 0.1 diffuse 0.3 reflection {{ {} }} }}", color(d),
                       d.between(0.3, 0.9));
}

std::string finish(Dice& d) {
    const char* kinds[] = {"fresnel on", "falloff 3", "metallic", "falloff 2 metallic 0.6"};
    return fmt::format(
        "pigment {{ {} }} finish {{ ambient 0.1 diffuse 0.3 reflection {{ {}, {} {} }} }} interior {{ ior {} }}",
        color(d), color(d), color(d), kinds[d.whole(0, 3)], d.between(1.2, 2.4));
}

std::string clear(Dice& d, const std::string& interior) {
    return fmt::format(
        "pigment {{ rgbft <{}, {}, {}, {}, {}> }} finish {{ ambient 0 diffuse 0.1 reflection {{ 0, 1 fresnel on }} "
        "conserve_energy }} interior {{ ior {} {} }}",
        d.between(0.5, 1), d.between(0.5, 1), d.between(0.5, 1), d.between(0.4, 0.6), d.between(0.2, 0.4),
        d.between(1.1, 2.2), interior);
}
std::string glass(Dice& d) { return clear(d, ""); }
std::string coloured(Dice& d) {
    return clear(d, fmt::format("fade_distance {} fade_power {} fade_color {}", d.between(0.3, 1),
                                d.heads() ? 1001 : d.whole(1, 3), color(d)));
}
std::string tinted(Dice& d) {
    return fmt::format("pigment {{ rgbf <{}, {}, {}, {}> }} finish {{ ambient 0.1 diffuse 0.4 }}", d.between(0.3, 1),
                       d.between(0.3, 1), d.between(0.3, 1), d.between(0.5, 0.9));
}

/// Three shells around one place, and a ball that cuts through them.
std::string shells(Dice& d) {
    const V center = d.place(0.4);
    std::string things;
    for (const double radius : {1.2, 0.9, 0.5})
        things += fmt::format("sphere {{ {}, {} {} }}\n", text(center), radius, glass(d));
    return things + fmt::format("sphere {{ {}, 0.7 {} }}\n",
                                text({center[0] + 1, center[1] + d.between(-0.5, 0.5), center[2]}), glass(d));
}

std::string shallow(Dice& d) {
    return fmt::format("global_settings {{ max_trace_level {} adc_bailout {} }}\n", d.whole(2, 4),
                       d.heads() ? 0.0 : d.between(0.02, 0.2));
}

}  // namespace

void add_recursion(Recipes& recipes) {
    const auto shaded = [](Dice& d) { return lamp(d, "") + lamp(d, ""); };
    const auto in_room = [](const char* settings, std::string (*look)(Dice&)) {
        return [=](Dice& d) {
            return settings + floor_of(d) + ball(d, look(d)) + block(d, look(d)) + matt_ball(d) + matt_ball(d);
        };
    };
    recipes["3.1"] = {in_room(kDeep, mirror)};
    recipes["3.2"] = {in_room(kDeep, glass)};
    recipes["3.3"] = {in_room(kDeep, glass)};
    recipes["3.4"] = {in_room(kDeep, finish)};
    recipes["3.5"] = {[](Dice& d) { return kDeep + floor_of(d) + shells(d); }};
    recipes["3.6"] = {in_room(kDeep, coloured)};
    recipes["3.7"] = {in_room("", tinted), shaded};
    recipes["3.8"] = {[](Dice& d) {
        return shallow(d) + floor_of(d) + ball(d, mirror(d)) + ball(d, glass(d)) + block(d, mirror(d));
    }};
    recipes["3.9"] = {
        [](Dice& d) { return kDeep + ball(d, mirror(d)) + ball(d, mirror(d)) + block(d, mirror(d)) + matt_ball(d); }};
    recipes["3.10"] = {
        [](Dice& d) { return kDeep + floor_of(d) + block(d, glass(d)) + ball(d, coloured(d)) + matt_ball(d); }};
    recipes["3.11"] = {
        [](Dice& d) { return floor_of(d) + ball(d, finish(d)) + shells(d) + block(d, coloured(d)) + matt_ball(d); },
        shaded};
}

}  // namespace rays::grader::fresh
