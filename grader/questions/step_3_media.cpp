// Questions about media: in and out of glass, absorption, the shadows of clear things (3.5 to 3.7).
#include <fmt/format.h>

#include <cmath>

#include "questions/step_3.h"

namespace rays::grader::step_3 {
namespace {

const char* const kClear = "rgbt 1";

std::string filled(double x, const std::string& interior) { return sphere({x, 0, 0}, 1, kClear, kDark, interior); }

/// Six objects: three kinds of glass, one without an interior, two parts of a union that share theirs.
struct Cabinet {
    double ior[6];

    explicit Cabinet(Dice& dice) {
        for (double& n : ior) n = single(dice.round_between(1.1, 2.4));
        ior[3] = 1;
        ior[5] = ior[4];
    }
    std::string text() const {
        std::string sdl = world();
        for (int i = 0; i < 3; ++i) sdl += filled(3 * i, fmt::format("interior {{ ior {} }}", ior[i]));
        sdl += filled(9, "");
        return sdl + fmt::format(
                         "union {{ sphere {{ <12, 0, 0>, 1 }} sphere {{ <15, 0, 0>, 1 }} pigment {{ rgbt 1 }} "
                         "interior {{ ior {} }} }}\n",
                         ior[4]);
    }
};

std::string list(const std::vector<int>& objects) {
    std::string text = std::to_string(objects.size());
    for (const int o : objects) text += fmt::format(" {}", o);
    return text;
}

/// A ray in these media crosses the border of one: the index, and the media behind.
struct Crossing {
    int object;
    std::vector<int> inside;
    double index;
    std::vector<int> after;
    const char* about;
};

void ask_crossings(Notebook& notes, const Cabinet& c) {
    const double* n = c.ior;
    const Crossing crossings[] = {
        {0, {}, n[0], {0}, "into glass from outside"},
        {1, {0}, n[1] / n[0], {0, 1}, "into glass within glass"},
        {2, {0, 1}, n[2] / n[1], {0, 1, 2}, "into glass: the medium entered last is the near side"},
        {0, {0}, 1 / n[0], {}, "out of glass"},
        {1, {0, 1}, n[0] / n[1], {0}, "out of the inner glass: the outer one lies behind"},
        {1, {2, 0, 1}, n[0] / n[1], {2, 0}, "out of the last glass: the one entered before it lies behind"},
        {0, {0, 1}, 1, {1}, "out of the outer glass first (an overlap): nothing bends, the inner one remains"},
        {2, {2, 0, 1}, 1, {0, 1}, "out of the first of three: nothing bends, the order of the others stays"},
        {3, {}, 1, {3}, "into a thing without an interior: index 1"},
        {3, {0}, 1 / n[0], {0, 3}, "an air bubble in glass"},
        {3, {0, 3}, n[0], {0}, "out of the bubble"},
        {5, {4}, 1 / n[4], {}, "the parts of a union share their interior: leaving the other part's medium"},
        {4, {0}, n[4] / n[0], {0, 4}, "into a union's part within glass"},
    };
    for (const Crossing& x : crossings) {
        std::vector<double> truth{x.index};
        truth.insert(truth.end(), x.after.begin(), x.after.end());
        notes.ask(fmt::format("cross_border {} {}", x.object, list(x.inside)), x.about,
                  starts_with(truth, truth.size(), {2e-6, 1e-6}));
    }
}

void ask_fresnel_iors(Notebook& notes, const Cabinet& c) {
    const double* n = c.ior;
    const auto ask = [&](int object, const std::vector<int>& inside, double truth, const char* about) {
        notes.ask(fmt::format("fresnel_ior {} {}", object, list(inside)), about, close_to(truth, kGeometry));
    };
    ask(0, {}, n[0], "Fresnel's index from outside");
    ask(1, {1}, 1 / n[1], "Fresnel's index from inside of it alone");
    ask(1, {0}, n[1] / n[0], "Fresnel's index from other glass: over the last one's");
    ask(2, {0, 1}, n[2] / n[1], "Fresnel's index from two other kinds: the last one counts");
    ask(0, {0, 1}, n[1] / n[0], "leaving with another around: the last one's index over its own");
    ask(1, {0, 1}, 1, "leaving the last one with another around: its own over its own, nothing is reflected");
}

}  // namespace

std::vector<Question> borders(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("3.5");
    for (int i = 0; i < 2; ++i) {
        const Cabinet cabinet(dice);
        notes.scene(cabinet.text());
        ask_crossings(notes, cabinet);
        ask_fresnel_iors(notes, cabinet);
    }
    return notes.take();
}

std::vector<Question> absorptions(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("3.6");
    const auto fading = [](double distance, double power, const V& color) {
        return world() + filled(0, fmt::format("interior {{ ior 1.5 fade_distance {} fade_power {} fade_color {} }}",
                                               distance, power, rgb(color)));
    };
    const auto beer = [](const V& color, double relative) {
        return V(std::exp((color.x - 1) * relative), std::exp((color.y - 1) * relative),
                 std::exp((color.z - 1) * relative));
    };
    for (const double power : {1000.0, 1001.0}) {
        const V color = dice.color();
        const double unit = dice.round_between(0.2, 3);
        notes.scene(fading(unit, power, color));
        for (int i = 0; i < 5; ++i) {
            const double far = dice.between(0, 4) * unit;
            notes.ask("absorption 0 " + number(far), "Beer: e^(-(1 - color) distance / fade_distance)",
                      close_to(beer(color, far / unit)));
        }
        // Two ways in a row are as one: the product.
        const double once = dice.between(0.5, 2) * unit;
        notes.ask("absorption 0 " + number(2 * once), "Beer: twice the way, the square of what is left",
                  close_to(beer(color, once / unit) * beer(color, once / unit)));
    }
    for (const double power : {1.0, 2.0, 3.5, 999.0}) {
        const V color = dice.color();
        const double unit = dice.round_between(0.2, 3);
        notes.scene(fading(unit, power, color));
        for (int i = 0; i < 2; ++i) {
            const double relative = dice.between(0, 3);
            const double left = 1 / (1 + std::pow(relative, power));
            notes.ask("absorption 0 " + number(relative * unit),
                      "color + (1 - color) / (1 + (d / fade_distance)^power)",
                      close_to(left * V(1) + (1 - left) * color));
        }
        notes.ask("absorption 0 " + number(unit), "at fade_distance: half way to fade_color",
                  close_to(0.5 * (V(1) + color)));
    }
    for (const double power : {1001.0, 2.0}) {
        notes.scene(fading(0.5, power, V(1)));
        notes.ask("absorption 0 " + number(dice.between(1, 9)), "a white fade_color takes nothing", close_to(V(1)));
        notes.scene(fading(0, power, dice.color()));
        notes.ask("absorption 0 " + number(dice.between(1, 9)), "fade_distance 0 takes nothing", close_to(V(1)));
    }
    return notes.take();
}

namespace {

/// Light falls down the y axis onto the point 0; things stand in its way.
struct Column {
    std::string sdl = world() + "light_source { <0, 10, 0>, rgb 1 }\n";
    V left{1};

    void sheet(double height, const std::string& pigment, const V& clear, const std::string& more = "") {
        sdl += fmt::format("disc {{ <0, {}, 0>, y, 2 pigment {{ {} }} {} }}\n", height, pigment, more);
        left *= clear;
    }
    void ball(double height, double radius, const std::string& pigment, const std::string& interior) {
        sdl += sphere({0, height, 0}, radius, pigment, kDark, interior);
    }
};

std::string filter_of(const V& color, double filter, double transmit) {
    return fmt::format("rgbft <{}, {}, {}, {}, {}>", color.x, color.y, color.z, filter, transmit);
}

const char* const kBeerGlass = "interior { ior 1.5 fade_distance 1 fade_power 1001 fade_color rgb <0.2, 0.5, 0.8> }";
V beer_glass(double distance) {
    return {std::exp(-0.8 * distance), std::exp(-0.5 * distance), std::exp(-0.2 * distance)};
}

class ShadowBook {
public:
    explicit ShadowBook(Notebook& notes) : notes_(notes) {}
    void ask(const Column& column, const char* about, const char* media = "0") {
        notes_.scene(column.sdl);
        notes_.ask(fmt::format("visibility 0 0 0 0 {}", media), about, close_to(column.left));
    }

private:
    Notebook& notes_;
};

void ask_sheets(ShadowBook& book, Dice& dice) {
    book.ask({}, "nothing in the way: all of it");
    for (int i = 0; i < 6; ++i) {
        Column column;
        for (int sheets = 1 + i % 3; sheets > 0; --sheets) {
            const V color = dice.color();
            const double filter = i == 1 ? 0 : dice.round_between(0.1, 0.6),
                         transmit = i == 0 ? 0 : dice.round_between(0.1, 0.4);
            column.sheet(2 * sheets, filter_of(color, filter, transmit), filter * color + V(transmit));
        }
        book.ask(column, "each sheet multiplies by color * filter + transmit");
    }
    for (const double height : {3.0, 7.0}) {
        Column column;
        column.sheet(5, "rgbt 0.6", V(0.6));
        column.sheet(height, "rgb 1", V(0));
        book.ask(column, "an opaque thing before or behind a clear one blocks");
    }
    Column shadowless;
    shadowless.sheet(5, "rgb 1", V(1), "no_shadow");
    shadowless.sheet(6, filter_of(V(0.5), 0.4, 0.2), V(0.4));
    book.ask(shadowless, "what has no_shadow does nothing");
    Column beyond;
    beyond.sheet(12, "rgb 1", V(1));
    beyond.sheet(3, "rgbt 0.3", V(0.3));
    book.ask(beyond, "what stands beyond the light does nothing");
    Column touching;
    touching.sheet(0.0005, "rgb 1", V(1));
    book.ask(touching, "what is nearer than the tolerance does nothing: the surface itself");
    Column checkered;
    checkered.sheet(4.5, "checker rgbt <1, 1, 1, 0.7>, rgb 0 translate <0.3, 0.3, 0.3>", V(0.7));
    checkered.sheet(5.5, "checker rgb 0, rgbt <1, 1, 1, 0.6> translate <0.3, 0.3, 0.3>", V(0.6));
    book.ask(checkered, "a checkered sheet: the colour where the light passes");
}

void ask_balls(ShadowBook& book, Dice& dice) {
    for (int i = 0; i < 4; ++i) {
        Column column;
        const double radius = dice.round_between(0.5, 2);
        const V color = dice.color();
        column.ball(5, radius, filter_of(color, 0.9, 0), i % 2 ? kBeerGlass : "");
        column.left = 0.81 * color * color * (i % 2 ? beer_glass(2 * radius) : V(1));
        book.ask(column, i % 2 ? "a ball of glass absorbs over the way through it, and filters twice"
                               : "a ball has two surfaces");
    }
    for (int i = 0; i < 2; ++i) {
        Column column;
        const double inner = dice.round_between(0.2, 0.9);
        column.ball(5, 1, kClear, kBeerGlass);
        column.ball(5, inner, kClear, "interior { ior 1 }");
        column.left = beer_glass(1 - inner);
        book.ask(column, "glass around a bubble: absorbed from the last surface on, as POV-Ray has it");
    }
    for (int i = 0; i < 2; ++i) {
        Column column;
        const double radius = dice.round_between(1, 3);
        column.ball(0.5, radius, kClear, kBeerGlass);
        column.left = beer_glass(radius + 0.5);
        book.ask(column, "from within glass, which the shadow ray knows: absorbed up to its surface", "1 0");
    }
    Column outside;
    outside.ball(5, 1.5, kClear, kBeerGlass);
    outside.sheet(8, "rgbt 0.5", V(0.5));
    outside.left *= beer_glass(3);
    book.ask(outside, "nothing is absorbed outside of the glass");
    Column rational;
    rational.ball(5, 0.5, kClear, "interior { ior 1.5 fade_distance 1 fade_power 2 fade_color rgb <0.2, 0.5, 0.8> }");
    rational.left = 0.5 * (V(1) + V(0.2, 0.5, 0.8));
    book.ask(rational, "the other law of absorption, too");
}

}  // namespace

std::vector<Question> glass_shadows(std::uint64_t seed) {
    Dice dice(seed);
    Notebook notes("3.7");
    ShadowBook book(notes);
    ask_sheets(book, dice);
    ask_balls(book, dice);
    Dice more(seed + 1);
    ask_balls(book, more);
    return notes.take();
}

}  // namespace rays::grader::step_3
