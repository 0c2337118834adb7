#include "grader/statistical_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace rays::grader {
namespace {

std::string count(int n, const std::string& one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); }

// Probabilities below a billionth depend on tails that nobody has measured.
std::string chance_text(double chance) {
    if (chance < 1e-9) return "less than once in 10^9 gradings";
    return fmt::format("once in {:.2g} gradings", 1 / std::max(chance, 1e-9));
}

std::string whole_text(const Examination& e) {
    std::string text;
    for (std::size_t c = 0; c < 3; ++c)
        if (e.whole[c].wrong)
            text += fmt::format("{}{} is {}", text.empty() ? "of the whole picture, " : ", ", channel_name(c),
                                difference_text(e.whole[c]));
    return text;
}

std::string worst_text(const Examination& e, Raster raster) {
    const Tile& tile = e.tiles[static_cast<std::size_t>(e.worst_tile)];
    const Difference& d = tile.channels[e.worst_channel];
    return fmt::format(
        "{} of {} tiles wrong, most of all {}: {} is {}, {:.1f} standard errors beyond the {:.2g} allowed",
        e.tiles_wrong, e.tiles.size(), tile_text(tile, raster), channel_name(e.worst_channel), difference_text(d),
        std::abs(d.z), d.margin);
}

// ---- explanations

/// A change of single values or of places that undoes a mistake.
using Change = std::function<RgbImage(const RgbImage&)>;

struct Candidate {
    std::string text;
    Change undo;
};

Change each_value(std::function<double(double)> f) {
    return [f = std::move(f)](const RgbImage& picture) {
        RgbImage changed = picture;
        for (Rgb& p : changed.pixels)
            for (float& v : p) v = static_cast<float>(f(double(v)));
        return changed;
    };
}

Change from_place(std::function<std::pair<int, int>(int, int, const Raster&)> place) {
    return [place = std::move(place)](const RgbImage& picture) {
        RgbImage changed = picture;
        for (int y = 0; y < picture.raster.height; ++y) {
            for (int x = 0; x < picture.raster.width; ++x) {
                const auto [from_x, from_y] = place(x, y, picture.raster);
                changed.at(x, y) = picture.at(std::clamp(from_x, 0, picture.raster.width - 1),
                                              std::clamp(from_y, 0, picture.raster.height - 1));
            }
        }
        return changed;
    };
}

Change channels(std::array<std::size_t, 3> from) {
    return [from](const RgbImage& picture) {
        RgbImage changed = picture;
        for (Rgb& p : changed.pixels) p = {p[from[0]], p[from[1]], p[from[2]]};
        return changed;
    };
}

// The factor and the summand that take the reference to the pictures' mean with the least squared difference.
void add_brightness(const RgbImage& mean, const AveragedReference& truth, std::vector<Candidate>& list) {
    double product = 0, squares = 0, difference = 0;
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = double(mean.pixels[i][c]), right = double(truth.mean.pixels[i][c]);
            product += value * right, squares += right * right, difference += value - right;
        }
    }
    const double factor = squares > 0 ? product / squares : 0, more = difference / (3 * double(mean.pixels.size()));
    if (factor > 0 && std::abs(factor - 1) > 2e-3)
        list.push_back({fmt::format("every value is {:.4g} times the right one", factor),
                        each_value([factor](double v) { return v / factor; })});
    if (std::abs(more) > 0)
        list.push_back({fmt::format("every value is {:.3g} too {}", std::abs(more), more > 0 ? "large" : "small"),
                        each_value([more](double v) { return v - more; })});
}

void add_places(std::vector<Candidate>& list) {
    list.push_back({"the picture is mirrored left to right",
                    from_place([](int x, int y, const Raster& r) { return std::pair(r.width - 1 - x, y); })});
    list.push_back({"the picture is upside down",
                    from_place([](int x, int y, const Raster& r) { return std::pair(x, r.height - 1 - y); })});
    list.push_back({"the picture is turned by half a turn", from_place([](int x, int y, const Raster& r) {
                        return std::pair(r.width - 1 - x, r.height - 1 - y);
                    })});
}

void add_values(std::vector<Candidate>& list) {
    list.push_back({"the values are sRGB encoded: colours must stay linear", each_value([](double v) {
                        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
                    })});
    list.push_back({"the values are gamma encoded (1/2.2): colours must stay linear",
                    each_value([](double v) { return v > 0 ? std::pow(v, 2.2) : v; })});
    list.push_back({"red and blue are swapped", channels({2, 1, 0})});
    list.push_back({"red and green are swapped", channels({1, 0, 2})});
    list.push_back({"green and blue are swapped", channels({0, 2, 1})});
}

// What is above 1 is missing, in every picture.
bool cut_at_one(const Pictures& pictures, const AveragedReference& truth) {
    float most = 0, right = 0;
    for (const RgbImage& picture : pictures)
        for (const Rgb& p : picture.pixels) most = std::max({most, p[0], p[1], p[2]});
    for (const Rgb& p : truth.mean.pixels) right = std::max({right, p[0], p[1], p[2]});
    return most == 1 && right > 1;
}

}  // namespace

std::string channel_name(std::size_t channel) { return std::string(1, "RGB"[channel]); }

std::string difference_text(const Difference& d) {
    const char* way = d.value > 0 ? "too bright" : "too dark";
    const std::string values = fmt::format("({:.3g} instead of {:.3g})", d.reference + d.value, d.reference);
    if (std::abs(d.reference) < 1e-6) return fmt::format("{} {}", way, values);
    return fmt::format("{} by {:.2g} % {}", way, 100 * std::abs(d.value / d.reference), values);
}

std::string tile_text(const Tile& t, Raster raster) {
    const auto third = [](double middle, int size) { return std::clamp(static_cast<int>(3 * middle / size), 0, 2); };
    const char* places[3][3] = {
        {"upper left", "top", "upper right"}, {"left", "middle", "right"}, {"lower left", "bottom", "lower right"}};
    return fmt::format("at pixels ({}, {}) to ({}, {}), {}", t.x, t.y, t.x + t.width - 1, t.y + t.height - 1,
                       places[third(t.y + 0.5 * t.height, raster.height)][third(t.x + 0.5 * t.width, raster.width)]);
}

std::string bias_text(const BiasVerdict& v, Raster raster) {
    const Examination& e = v.examination;
    if (e.not_finite > 0)
        return fmt::format("{} of {} pictures {} not finite (NaN or infinite)", count(e.not_finite, "pixel"), e.seeds,
                           e.not_finite == 1 ? "is" : "are");
    const std::string seeds = v.batches == 1 ? fmt::format("{} seeds", e.seeds)
                                             : fmt::format("{} seeds and then {} others", e.seeds / 2, e.seeds);
    if (v.passed) {
        std::string text = fmt::format("the mean of {} is right in all of {} tiles and as a whole",
                                       count(e.seeds, "seed"), e.tiles.size());
        if (v.batches == 2)
            text +=
                fmt::format("; that {} differed in {} of {} seeds was chance, {} others say",
                            v.first_found.size() == 1 ? "one place" : fmt::format("{} places", v.first_found.size()),
                            "a first batch", e.seeds / 2, e.seeds);
        return text;
    }
    std::string text = fmt::format("the mean is wrong in {}: ", seeds);
    const std::string whole = whole_text(e);
    text += whole;
    if (e.tiles_wrong > 0) text += (whole.empty() ? "" : "; ") + worst_text(e, raster);
    return text + "; a right picture would differ so " + chance_text(v.chance);
}

std::string noise_text(const NoiseVerdict& v, const VerdictOptions& options) {
    if (v.equal) return "pictures of different seeds are equal: --seed must decide all random numbers";
    if (v.shared)
        return "neighbouring pixels share their random numbers, so that their noise does not average out: give each "
               "pixel its own";
    const std::string times =
        fmt::format("the noise (mean variance) is {:.3g} times the solution's at as many samples", v.ratio);
    if (v.share == 1) return times;
    if (v.unresolved)
        return fmt::format("{}: so much that a picture too bright by {:.2g} % could not be told from a right one",
                           times, 100 * options.resolution);
    return fmt::format("{}: up to {:.3g} is well, from {:.3g} on it earns nothing", times, options.noise_full,
                       options.noise_none);
}

std::optional<std::string> explain_bias(const Pictures& pictures, const AveragedReference& truth,
                                        const VerdictOptions& options) {
    const RgbImage mean = mean_of(pictures);
    const auto& pixels = mean.pixels;
    if (std::all_of(pixels.begin(), pixels.end(), [](const Rgb& p) { return p == Rgb{0, 0, 0}; }))
        return "the whole picture is black";
    if (cut_at_one(pictures, truth)) return "values above 1 are cut off: colours must stay linear and unbounded";
    std::vector<Candidate> candidates;
    add_brightness(mean, truth, candidates);
    add_places(candidates);
    add_values(candidates);
    for (const Candidate& candidate : candidates) {
        Pictures changed;
        for (const RgbImage& p : pictures) changed.push_back(candidate.undo(p));
        const Examination e = examine(changed, truth, options.batch(options.first_alarm_rate));
        if (e.passed()) return candidate.text;
    }
    return {};
}

}  // namespace rays::grader
