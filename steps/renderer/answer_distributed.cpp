// The queries of step 5: patterns, what their points mean, and when they are enough.
#include <algorithm>
#include <cmath>
#include <vector>

#include "5_distributed/distributed.h"
#include "renderer/question.h"

namespace rays::questions {
namespace {

/// Answers have room for this many points.
constexpr int kMostPoints = 4096;
constexpr std::uint32_t kMostSamples = 1u << 30;

using questions::text;
std::string text(const Vec2& v) { return text(v.x) + " " + text(v.y); }

/// One after the other, on one line.
class Line {
public:
    void add(const std::string& words) {
        if (!all_.empty()) all_ += ' ';
        all_ += words;
    }
    std::string take() { return std::move(all_); }

private:
    std::string all_;
};

// ---- Patterns ----------------------------------------------------------------------------------------------------------

/// What the points of an answer differ by.
void go_on(Draw& draw, const std::string& along, std::uint32_t by) {
    if (along == "seed")
        draw.seed += by;
    else if (along == "pixel")
        draw.pixel += by;
    else if (along == "dimension")
        draw.dimension += by;
    else if (along == "sample")
        draw.sample += by;
    else if (along == "samples")
        draw.samples += by;
    else if (along != "nothing")
        throw InputError("nothing goes along " + along);
}

std::string points(const Stage&, Words& words) {
    const std::string name = words.word();
    const auto pattern = pattern_named(name);
    if (!pattern) throw InputError("no pattern " + name);
    Draw first;
    first.seed = words.whole<std::uint64_t>(0, 1ull << 52);
    first.pixel = words.whole<std::uint32_t>(0, kMostSamples);
    first.dimension = words.whole<std::uint32_t>(0, kMostSamples);
    first.sample = words.whole<std::uint32_t>(0, kMostSamples);
    first.samples = words.whole<std::uint32_t>(1, kMostSamples);
    const std::string along = words.word();
    const int count = words.whole(1, kMostPoints);
    const std::string then_along = words.word();
    const int then = words.whole(1, kMostPoints / count);
    Line line;
    for (int j = 0; j < then; ++j)
        for (int i = 0; i < count; ++i) {
            Draw draw = first;
            go_on(draw, along, static_cast<std::uint32_t>(i));
            go_on(draw, then_along, static_cast<std::uint32_t>(j));
            if (draw.sample >= draw.samples)
                throw InputError(fmt::format("no sample {} of {}", draw.sample, draw.samples));
            line.add(text(point_of(*pattern, draw)));
        }
    return line.take();
}

// ---- What points mean --------------------------------------------------------------------------------------------------

/// Three numbers in [0, 1).
struct Chance {
    Vec2 u;
    Real u3;
};

/// `U V W`, or `grid COLUMNS ROWS W`: the centres of that many cells, row by row; the third number goes on from W by
/// the golden section, modulo 1, so that it is as even whatever the grid.
std::vector<Chance> chances(Words& words) {
    const std::string word = words.word();
    if (word != "grid") {
        const Real x = words.number(word), y = words.number();
        return {{{x, y}, words.number()}};
    }
    const int columns = words.whole(1, kMostPoints), rows = words.whole(1, kMostPoints / columns);
    const Real start = words.number();
    std::vector<Chance> all;
    for (int i = 0; i < columns * rows; ++i) {
        const double third = static_cast<double>(start) + i * 0.6180339887498949;
        const Vec2 center((i % columns + Real(0.5)) / Real(columns), (i / columns + Real(0.5)) / Real(rows));
        all.push_back({center, static_cast<Real>(third - std::floor(third))});
    }
    return all;
}

template <class F>
std::string for_each(const std::vector<Chance>& all, F f) {
    Line line;
    for (const Chance& chance : all) line.add(f(chance));
    return line.take();
}

std::string disc(const Stage&, Words& words) {
    return for_each(chances(words), [](const Chance& c) { return text(disc_point(c.u)); });
}

std::string polygon(const Stage&, Words& words) {
    const int corners = words.whole(3, 64);
    return for_each(chances(words), [=](const Chance& c) { return text(polygon_point(c.u, corners)); });
}

std::string ball(const Stage&, Words& words) {
    return for_each(chances(words), [](const Chance& c) { return text(ball_point(c.u, c.u3)); });
}

std::string filtered(const Stage&, Words& words) {
    const std::string name = words.word();
    const auto filter = filter_named(name);
    if (!filter) throw InputError("no filter " + name);
    return for_each(chances(words), [=](const Chance& c) {
        const FilterPoint p = filter_point(*filter, c.u);
        return text(p.offset) + fmt::format(" {:.9g}", p.weight);
    });
}

Raster raster(Words& words) {
    const int width = words.whole(1, 1 << 20);
    return {width, words.whole(1, 1 << 20)};
}

std::string through_lens(const Stage& stage, Words& words) {
    const Raster size = raster(words);
    const int column = words.integer(), row = words.integer();
    const Real dx = words.number();
    const Vec2 offset(dx, words.number());
    return for_each(chances(words), [&](const Chance& c) {
        const Ray ray = lens_ray(stage.scene.camera, size, column, row, offset, c.u);
        return text(ray.origin) + " " + text(ray.direction);
    });
}

std::string part_of_light(const Stage& stage, Words& words) {
    const Light& light = stage.light(words);
    return for_each(chances(words), [&](const Chance& c) {
        const Light point = light_at(light, c.u, c.u3);
        return fmt::format("{} {} {} {}", text(point.location), text(point.point_at), text(point.color),
                           text(point.area));
    });
}

std::string shutter(const Stage& stage, Words& words) {
    return for_each(chances(words), [&](const Chance& c) { return text(shutter_time(stage.scene.camera, c.u.x)); });
}

/// FIRST LAST N SAMPLES, then M TIMES: all the values.
std::string table(const Stage&, Words& words) {
    Varying varying;
    varying.first = words.number();
    varying.last = words.number();
    for (int n = words.whole(1, kMostPoints); n > 0; --n) varying.samples.push_back(words.number());
    Line line;
    for (int n = words.whole(1, 64); n > 0; --n) line.add(text(value_at(varying, words.number())));
    return line.take();
}

std::string tilt(const Stage& stage, Words& words) {
    Surface surface;
    surface.finish = &stage.material(words).finish;
    if (!(surface.finish->glossy > 0)) throw InputError("the object is not rough");
    surface.normal = words.vector();
    surface.geometric_normal = words.vector();
    surface.to_viewer = words.vector();
    return for_each(chances(words), [&](const Chance& c) { return text(tilted_normal(surface, c.u)); });
}

// ---- Enough? -----------------------------------------------------------------------------------------------------------

std::string error_of(const Stage&, Words& words) {
    Estimate estimate;
    estimate.samples = words.whole<std::uint32_t>(0, kMostSamples);
    for (Radiance& sum : estimate.sum)
        for (int lane = 0; lane < 4; ++lane) sum[lane] = static_cast<float>(words.number());
    return fmt::format("{:.9g}", standard_error(estimate));
}

std::string enough(const Stage&, Words& words) {
    const auto own = static_cast<float>(words.number()), wanted = static_cast<float>(words.number());
    std::vector<float> around;
    for (int n = words.whole(0, 8); n > 0; --n) around.push_back(static_cast<float>(words.number()));
    return text(is_enough(own, around, wanted));
}

/// In a scene with a lens: of pixel, lens, time, then of every light and its ball, then of so many rough surfaces.
std::string dimensions(const Stage&, Words& words) {
    const auto lights = words.whole<std::uint32_t>(0, 1024), surfaces = words.whole<std::uint32_t>(0, 1024);
    Line line;
    const auto add = [&](Purpose purpose, std::uint32_t number) {
        line.add(fmt::format("{}", dimension_of(purpose, number, {.lens = true, .lights = lights})));
    };
    for (const Purpose p : {Purpose::pixel, Purpose::lens, Purpose::time}) add(p, 0);
    for (std::uint32_t i = 0; i < lights; ++i) add(Purpose::light, i), add(Purpose::ball_light, i);
    for (std::uint32_t i = 0; i < surfaces; ++i) add(Purpose::rough_surface, i);
    return line.take();
}

std::string blur(const Stage& stage, Words& words) {
    const Raster size = raster(words);
    const Real nearest = words.number();
    return text(largest_blur_px(stage.scene.camera, size, nearest, words.number()));
}

std::string penumbra(const Stage&, Words& words) {
    const Real diameter = words.number(), to_edge = words.number();
    return text(widest_penumbra(diameter, to_edge, words.number()));
}

}  // namespace

void add_distributed(Answerers& answerers) {
    answerers.insert({{"points", points},
                      {"disc", disc},
                      {"polygon", polygon},
                      {"ball", ball},
                      {"filter", filtered},
                      {"lens_ray", through_lens},
                      {"light_at", part_of_light},
                      {"shutter", shutter},
                      {"value_at", table},
                      {"tilt", tilt},
                      {"standard_error", error_of},
                      {"is_enough", enough},
                      {"dimensions", dimensions},
                      {"blur", blur},
                      {"penumbra", penumbra}});
}

}  // namespace rays::questions
