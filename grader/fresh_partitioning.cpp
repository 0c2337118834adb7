// Fresh scenes for structures: many small things close together, a few alone far away, and long shadows.
#include "grader/fresh_recipes.h"

namespace rays::grader::fresh {
namespace {

V moved(const V& from, const V& by) { return {from[0] + by[0], from[1] + by[1], from[2] + by[2]}; }

/// A thing of this size at this place.
std::string thing(Dice& d, const V& at, double size) {
    const auto near = [&] { return text(moved(at, d.place(size))); };
    switch (d.whole(0, 4)) {
        case 0: return fmt::format("sphere {{ {}, {} {} }}\n", text(at), size, matt(d));
        case 1: return fmt::format("triangle {{ {}, {}, {} {} }}\n", near(), near(), near(), matt(d));
        case 2: return fmt::format("cone {{ {}, {}, {}, 0 open {} }}\n", near(), size / 2, near(), matt(d));
        case 3:
            return fmt::format("box {{ -1, 1 scale {} rotate {} translate {} {} }}\n", size / 2, text(d.place(90)),
                               text(at), matt(d));
        default:
            return fmt::format("mesh {{ triangle {{ {0}, {1}, {2} }} triangle {{ {0}, {2}, {3} }} {4} }}\n", near(),
                               near(), near(), near(), matt(d));
    }
}

/// The floor stays outside of every structure; the small things are what grids are bad at, and the large ones lie in
/// many cells.
std::string crowd(Dice& d) {
    std::string things = fmt::format("plane {{ y, -1.7 {} }}\n", matt(d));
    const V middle = d.place(0.6);
    for (int i = 0; i < 40; ++i) things += thing(d, moved(middle, d.place(0.5)), d.between(0.04, 0.2));
    for (int i = 0; i < 12; ++i) things += thing(d, d.place(1.6), d.between(0.1, 0.5));
    return things;
}

}  // namespace

void add_partitioning(Recipes& recipes) {
    const auto shaded = [](Dice& d) { return lamp(d, "") + lamp(d, ""); };
    for (const char* walk : {"4.4", "4.7"}) recipes[walk] = {crowd, shaded, false};
}

}  // namespace rays::grader::fresh
