#include "grader/explain_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace rays::grader {
namespace {

/// The changed picture's pixel, or nothing where the change leads out of the picture.
using Change = std::function<std::optional<Rgb>(int x, int y)>;

// An explanation may leave this share of what it covers unexplained: silhouettes move with a shift.
constexpr double kUnexplained = 0.02;
// ... and must explain nine tenths of what was wrong.
constexpr double kImprovement = 0.1;

struct Share {
    double wrong = 0;
    bool covered = false;  ///< is most of the picture covered?
};

Share share_wrong(const Change& change, const Reference& truth, const Tolerance& tolerance) {
    int covered = 0, wrong = 0;
    for (int y = 0; y < truth.frame.raster.height; ++y) {
        for (int x = 0; x < truth.frame.raster.width; ++x) {
            const auto value = change(x, y);
            if (!value) continue;
            ++covered;
            wrong += !within(*value, truth.frame.at(x, y), tolerance);
        }
    }
    const int pixels = truth.frame.raster.width * truth.frame.raster.height;
    return {covered ? double(wrong) / covered : 1, 2 * covered > pixels};
}

template <class F>
Change each_channel(const RgbImage& picture, F f) {
    return [&picture, f](int x, int y) -> std::optional<Rgb> {
        Rgb c = picture.at(x, y);
        for (float& v : c) v = static_cast<float>(f(double(v)));
        return c;
    };
}

struct Candidate {
    std::string text;
    Change change;
};

Change moved(const RgbImage& picture, int dx, int dy) {
    return [&picture, dx, dy](int x, int y) -> std::optional<Rgb> {
        if (x + dx < 0 || x + dx >= picture.raster.width || y + dy < 0 || y + dy >= picture.raster.height) return {};
        return picture.at(x + dx, y + dy);
    };
}

std::string pixels(int count) { return fmt::format("{} pixel{}", std::abs(count), std::abs(count) == 1 ? "" : "s"); }

std::string shift_text(int dx, int dy) {
    std::string text = "the picture is shifted";
    if (dx) text += fmt::format(" {} to the {}", pixels(dx), dx > 0 ? "right" : "left");
    if (dy) text += fmt::format("{} {} {}", dx ? " and" : "", pixels(dy), dy > 0 ? "down" : "up");
    return text;
}

void add_flips(const RgbImage& p, std::vector<Candidate>& list) {
    const int w = p.raster.width - 1, h = p.raster.height - 1;
    list.push_back(
        {"the picture is mirrored left to right", [&p, w](int x, int y) { return std::optional(p.at(w - x, y)); }});
    list.push_back({"the picture is upside down", [&p, h](int x, int y) { return std::optional(p.at(x, h - y)); }});
    list.push_back({"the picture is turned by half a turn",
                    [&p, w, h](int x, int y) { return std::optional(p.at(w - x, h - y)); }});
}

void add_shifts(const RgbImage& p, std::vector<Candidate>& list) {
    for (int r = 1; r <= 3; ++r)
        for (int dy = -r; dy <= r; ++dy)
            for (int dx = -r; dx <= r; ++dx)
                if (std::max(std::abs(dx), std::abs(dy)) == r) list.push_back({shift_text(dx, dy), moved(p, dx, dy)});
}

double srgb_encode(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }
double srgb_decode(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

void add_curves(const RgbImage& p, std::vector<Candidate>& list) {
    list.push_back({"the values are sRGB encoded: colours must stay linear", each_channel(p, srgb_decode)});
    list.push_back({"the values are gamma encoded (1/2.2): colours must stay linear",
                    each_channel(p, [](double v) { return std::pow(v, 2.2); })});
    list.push_back({"the values were decoded from sRGB once too often", each_channel(p, srgb_encode)});
    list.push_back(
        {"gamma 2.2 was applied once too often", each_channel(p, [](double v) { return std::pow(v, 1 / 2.2); })});
}

void add_channels(const RgbImage& p, std::vector<Candidate>& list) {
    const struct {
        const char* text;
        std::array<std::size_t, 3> from;
    } orders[] = {{"red and blue are swapped", {2, 1, 0}},
                  {"red and green are swapped", {1, 0, 2}},
                  {"green and blue are swapped", {0, 2, 1}},
                  {"the channels are rotated", {1, 2, 0}},
                  {"the channels are rotated", {2, 0, 1}}};
    for (const auto& order : orders) {
        list.push_back({order.text, [&p, from = order.from](int x, int y) {
                            const Rgb& c = p.at(x, y);
                            return std::optional(Rgb{c[from[0]], c[from[1]], c[from[2]]});
                        }});
    }
}

// The median of picture / reference over channels that are bright in the reference.
std::optional<double> common_factor(const RgbImage& picture, const RgbImage& reference) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            if (reference.pixels[i][c] > 0.01f && std::isfinite(picture.pixels[i][c]))
                ratios.push_back(double(picture.pixels[i][c]) / double(reference.pixels[i][c]));
    if (ratios.empty()) return {};
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    return *middle > 0 && std::abs(*middle - 1) > 1e-3 ? std::optional(*middle) : std::nullopt;
}

void add_scale(const RgbImage& p, const Reference& truth, std::vector<Candidate>& list) {
    const auto factor = common_factor(p, truth.frame);
    if (!factor) return;
    const std::string text = *factor > 1 ? fmt::format("every value is {:.4g} times too bright", *factor)
                                         : fmt::format("every value is too dark: {:.4g} times the right one", *factor);
    list.push_back({text, each_channel(p, [f = *factor](double v) { return v / f; })});
}

std::optional<std::string> uniform(const RgbImage& p, const Reference& truth) {
    const auto flat = [](const RgbImage& q) {
        return std::all_of(q.pixels.begin(), q.pixels.end(), [&](const Rgb& c) { return c == q.pixels.front(); });
    };
    if (!flat(p) || flat(truth.frame)) return {};
    const Rgb& c = p.pixels.front();
    if (c == Rgb{0, 0, 0}) return "the whole picture is black";
    return fmt::format("the whole picture has one colour ({:.4g}, {:.4g}, {:.4g})", c[0], c[1], c[2]);
}

}  // namespace

std::optional<std::string> explain_picture(const RgbImage& picture, const Reference& truth,
                                           const Tolerance& tolerance) {
    if (picture.pixels.empty() || picture.raster.width != truth.frame.raster.width ||
        picture.raster.height != truth.frame.raster.height)
        return {};
    if (auto text = uniform(picture, truth)) return text;
    const double before = share_wrong(moved(picture, 0, 0), truth, tolerance).wrong;
    if (before == 0) return {};
    std::vector<Candidate> candidates;
    add_flips(picture, candidates);
    add_channels(picture, candidates);
    add_curves(picture, candidates);
    add_scale(picture, truth, candidates);
    add_shifts(picture, candidates);
    std::optional<std::string> best;
    double best_share = std::min(kUnexplained, kImprovement * before);
    for (const Candidate& candidate : candidates) {
        const Share share = share_wrong(candidate.change, truth, tolerance);
        if (!share.covered || share.wrong > best_share || (best && share.wrong == best_share)) continue;
        best = candidate.text;
        best_share = share.wrong;
    }
    return best;
}

}  // namespace rays::grader
