// Fresh scenes for distributed ray tracing: something to blur before and behind, one kind of blur each.
#include "grader/fresh_recipes.h"

namespace rays::grader::fresh {
namespace {

std::string checkers(Dice& d) {
    return fmt::format("pigment {{ checker {}, {} scale {} }} finish {{ ambient 0.2 diffuse 0.7 }}", color(d), color(d),
                       d.between(0.4, 0.9));
}

std::string thing(Dice& d, const V& at, const std::string& wears, const std::string& moves = "") {
    switch (d.whole(0, 2)) {
        case 0: return fmt::format("sphere {{ {}, {} {} {} }}\n", text(at), d.between(0.25, 0.6), wears, moves);
        case 1:
            return fmt::format("box {{ -1, 1 scale {} rotate {} translate {} {} {} }}\n",
                               text({d.between(0.2, 0.5), d.between(0.2, 0.5), d.between(0.2, 0.5)}), text(d.place(90)),
                               text(at), wears, moves);
        default:
            return fmt::format("cylinder {{ {}, {}, {} {} {} }}\n", text(at),
                               text({at[0] + d.between(-0.8, 0.8), at[1] + 0.9, at[2] + d.between(-0.8, 0.8)}),
                               d.between(0.1, 0.4), wears, moves);
    }
}

std::string floor(Dice& d, const std::string& wears) {
    return fmt::format("plane {{ y, {} {} }}\n", d.between(-1.8, -1.3), wears);
}

std::string some_things(Dice& d, int count) {
    std::string all = floor(d, checkers(d));
    for (int i = 0; i < count; ++i) all += thing(d, d.place(1.4), d.heads() ? matt(d) : checkers(d));
    return all;
}

std::string area_lamp(Dice& d) {
    const std::string kind = d.heads() ? "" : d.heads() ? " circular" : " circular orient";
    const double u = d.between(1, 4);
    const V across = kind == " circular orient" ? V{0, 0, u} : V{0, d.between(-1, 1), d.between(1, 4)};
    return lamp(d, fmt::format("area_light {}, {}, 4, 4{}", text({u, 0, 0}), text(across), kind));
}

std::string moving_things(Dice& d) {
    std::string all = floor(d, matt(d)) + thing(d, d.place(1), matt(d));
    all += thing(d, d.place(1), checkers(d), fmt::format("translate Time*{}", text(d.place(2))));
    all += thing(d, d.place(1), checkers(d), fmt::format("rotate Time*{}*y", d.between(40, 120)));
    return all;
}

/// A mirror and a plate that are rough, and what they show. Little is left after two of them.
std::string rough_things(Dice& d) {
    const std::string gloss = fmt::format("glossy {}", d.between(0.005, 0.2));
    std::string all = floor(
        d,
        fmt::format("pigment {{ {} }} finish {{ ambient 0.1 diffuse 0.3 phong 0.4 phong_size 20 reflection 0.5 {} }}",
                    color(d), gloss));
    for (int i = 0; i < 3; ++i) all += thing(d, d.place(1.2), checkers(d));
    return all + fmt::format(
                     "sphere {{ {}, 0.6 pigment {{ rgbf <1, 1, 1, 0.9> }} finish {{ diffuse 0.05 {} }} interior {{ ior "
                     "1.3 }} }}\n",
                     text(d.place(1)), gloss);
}

}  // namespace

void add_distributed(Recipes& recipes) {
    const auto shaded = [](Dice& d) { return lamp(d, "") + lamp(d, ""); };
    recipes["5.7"] = {[](Dice& d) { return some_things(d, 6); }, shaded, false, true};
    recipes["5.8"] = {[](Dice& d) { return some_things(d, 5); }, area_lamp, false, true};
    recipes["5.9"] = {moving_things, shaded, false, true};
    recipes["5.10"] = {rough_things, shaded, false, true};
}

}  // namespace rays::grader::fresh
