// make-report-pictures FOLDER: small pictures for the test of the report page, and values of some of their pixels.
// Noise, which no code packs, tries the limit of the page's size.
//
// Each scene is a lit sphere above a checkered floor, painted by formula. The reference is what that formula gives at
// the middle of each pixel, in half floats, with the least and the greatest value of 8 x 8 samples over the pixel and
// half a pixel around it. The student's is the same formula in full floats, with a mistake where asked.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr int kWidth = 160, kHeight = 120;
enum class Mistake { none, no_highlight, shifted, not_a_number };

struct Color {
    double r = 0, g = 0, b = 0;
};
Color operator*(double s, Color c) { return {s * c.r, s * c.g, s * c.b}; }
Color operator+(Color a, Color b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }

struct Painting {
    double phase;  ///< what differs from scene to scene: place, colour and light
    bool highlight = true;

    Color at(double x, double y) const {
        const double u = (x - kWidth / 2.0) / 60, v = (kHeight / 2.0 - y) / 60;
        const double cx = 0.5 * std::sin(phase), cy = 0.1 * std::cos(2 * phase),
                     radius = 0.55 + 0.12 * std::sin(3 * phase);
        const double dx = (u - cx) / radius, dy = (v - cy) / radius, d2 = dx * dx + dy * dy;
        return d2 <= 1 ? sphere(dx, dy, std::sqrt(1 - d2)) : floor_or_sky(u, v, cx);
    }

private:
    Color sphere(double nx, double ny, double nz) const {
        const double lx = 0.5 * std::cos(phase), ly = 0.65, lz = 0.57;
        const double length = std::hypot(lx, ly, lz);
        const double facing = std::max(0.0, (nx * lx + ny * ly + nz * lz) / length);
        const double mirror = std::max(0.0, (2 * facing * nz - lz / length));
        const Color base = {0.5 + 0.4 * std::cos(phase), 0.45 + 0.3 * std::cos(phase + 2.1),
                            0.5 + 0.4 * std::cos(phase + 4.2)};
        return (0.08 + 0.85 * facing) * base + (highlight ? 0.7 * std::pow(mirror, 40) : 0.0) * Color{1, 1, 1};
    }
    Color floor_or_sky(double u, double v, double cx) const {
        if (v > -0.25) return (0.55 + 0.25 * v) * Color{0.36, 0.52, 0.78};
        const double depth = 0.6 / (-v - 0.2), across = u * depth;
        const bool dark = (static_cast<int>(std::floor(across * 2)) + static_cast<int>(std::floor(depth * 2))) & 1;
        const double shade = std::hypot(across - cx * 1.4, (depth - 1.6) * 0.8) < 0.5 ? 0.35 : 0.9;
        return shade * (dark ? Color{0.12, 0.13, 0.16} : Color{0.82, 0.8, 0.74});
    }
};

struct Canvas {
    std::vector<std::string> names;
    std::vector<float> values;  ///< one for each name, pixel by pixel
};

void put(std::vector<float>& values, Color c) {
    for (const double v : {c.r, c.g, c.b}) values.push_back(static_cast<float>(v));
}

Canvas reference(const Painting& painting) {
    Canvas canvas{{"R", "G", "B", "min.R", "min.G", "min.B", "max.R", "max.G", "max.B"}, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            Color low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
            for (int k = 0; k < 64; ++k) {
                const Color c = painting.at(x - 0.5 + (k % 8 + 0.5) / 4, y - 0.5 + (k / 8 + 0.5) / 4);
                low = {std::min(low.r, c.r), std::min(low.g, c.g), std::min(low.b, c.b)};
                high = {std::max(high.r, c.r), std::max(high.g, c.g), std::max(high.b, c.b)};
            }
            for (const Color& c : {painting.at(x + 0.5, y + 0.5), low, high}) put(canvas.values, c);
        }
    return canvas;
}

Canvas student(Painting painting, Mistake mistake) {
    painting.highlight = mistake != Mistake::no_highlight;
    const double shift = mistake == Mistake::shifted ? 1.0 : 0.0;
    Canvas canvas{{"R", "G", "B"}, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) put(canvas.values, painting.at(x + 0.5 + shift, y + 0.5));
    if (mistake == Mistake::not_a_number) {
        for (std::size_t i = 3 * (60 * kWidth + 70); i < 3 * (60 * kWidth + 90); ++i)
            canvas.values[i] = std::numeric_limits<float>::quiet_NaN();
        canvas.values[3 * (20 * kWidth + 10)] = std::numeric_limits<float>::infinity();
    }
    return canvas;
}

/// What pixels might cost: 0 is a student's grid that counts no nodes, 1 the solution's, 2 an octree that asks nobody
/// in every tenth row. The test knows these formulas.
Canvas costs(int map) {
    Canvas canvas{{"tests", "nodes"}, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const int tests = map == 0 ? 1 + x + kWidth * y : map == 1 ? 1 + x : y % 10;
            canvas.values.push_back(static_cast<float>(tests));
            canvas.values.push_back(static_cast<float>(map == 0 ? 0 : map + x % 7));
        }
    return canvas;
}

/// z of tiles of 8 x 8 pixels: mostly 0, some noise, and two by two tiles that are far too dark. The test knows these
/// numbers.
Canvas z_map() {
    Canvas canvas{{"R", "G", "B"}, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const int column = x / 8, row = y / 8;
            const bool dark = (column == 8 || column == 9) && (row == 5 || row == 6);
            const float z = dark                 ? -9
                            : (column + row) % 3 ? 0
                                                 : 0.75f * static_cast<float>((7 * column + 3 * row) % 5 - 2);
            for (const float share : {0.5f, 1.0f, 0.25f}) canvas.values.push_back(share * z);
        }
    return canvas;
}

bool write(const Canvas& canvas, OIIO::TypeDesc format, const std::filesystem::path& file, int width = kWidth,
           int height = kHeight) {
    OIIO::ImageSpec spec(width, height, static_cast<int>(canvas.names.size()), format);
    spec.channelnames = canvas.names;
    spec.attribute("compression", "zip");
    const auto out = OIIO::ImageOutput::create(file.string());
    return out && out->open(file.string(), spec) && out->write_image(OIIO::TypeDesc::FLOAT, canvas.values.data()) &&
           out->close();
}

nlohmann::json pixel(const Canvas& canvas, int x, int y) {
    const auto first = static_cast<std::size_t>(y * kWidth + x) * canvas.names.size();
    return {canvas.values[first], canvas.values[first + 1], canvas.values[first + 2]};
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return std::fprintf(stderr, "usage: make-report-pictures FOLDER\n"), 2;
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    nlohmann::json values;
    bool good = true;
    for (int scene = 0; scene < 25; ++scene) {
        const Painting painting{0.9 * scene};
        const Canvas truth = reference(painting);
        good &= write(truth, OIIO::TypeDesc::HALF, folder / ("reference-" + std::to_string(scene) + ".exr"));
        const Mistake mistakes[] = {Mistake::none, Mistake::no_highlight, Mistake::shifted, Mistake::not_a_number};
        for (int m = 0; m < (scene < 2 ? 4 : 1); ++m) {
            const Canvas own = student(painting, mistakes[m]);
            const std::string name = "student-" + std::to_string(scene) + "-" + std::to_string(m) + ".exr";
            good &= write(own, OIIO::TypeDesc::FLOAT, folder / name);
            for (const auto& [x, y] : {std::pair{0, 0}, {33, 91}, {80, 60}, {101, 44}, {159, 119}})
                values[name].push_back(
                    {{"x", x}, {"y", y}, {"student", pixel(own, x, y)}, {"reference", pixel(truth, x, y)}});
        }
    }
    for (int map = 0; map < 3; ++map)
        good &= write(costs(map), OIIO::TypeDesc::FLOAT, folder / ("costs-" + std::to_string(map) + ".exr"));
    good &= write(z_map(), OIIO::TypeDesc::FLOAT, folder / "z.exr");
    std::mt19937 random(7);
    for (int i = 0; i < 40; ++i) {
        Canvas noise{{"R", "G", "B"}, {}};
        for (int k = 0; k < 3 * kWidth * kHeight; ++k)
            noise.values.push_back(static_cast<float>(random()) / static_cast<float>(random.max()));
        good &= write(noise, OIIO::TypeDesc::FLOAT, folder / ("noise-" + std::to_string(i) + ".exr"));
    }
    Canvas small{{"R", "G", "B"}, std::vector<float>(3 * kWidth * kHeight, 0.5f)};
    good &= write(small, OIIO::TypeDesc::FLOAT, folder / "other-size.exr", kWidth / 2, kHeight / 2);
    std::ofstream(folder / "values.json") << values.dump(1);
    return good ? 0 : 1;
}
