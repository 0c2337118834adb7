// The render program. One source, linked once with the solutions and once with the student's files.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>

#include <fmt/format.h>

#include "core/error.h"
#include "core/unfinished.h"
#include "renderer/answer.h"
#include "renderer/cost_map.h"
#include "renderer/needs.h"
#include "renderer/picture_file.h"
#include "renderer/private_output.h"
#include "renderer/render.h"
#include "renderer/seen.h"
#include "scene_reader/scene_reader.h"

namespace rays {
namespace {

struct Arguments {
    std::string scene, output, stats, pixel, cost_map, partition = "auto", pattern = "auto", filter = "box";
    RenderOptions options;
    std::vector<std::string> without;
    int max_trace_level = 0;
    bool needs = false, seen = false, json = false, visited = false, answer = false, everything = false;
};

struct Seconds {
    double read = 0, render = 0, write = 0;
};

class Stopwatch {
public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void check(Arguments& a) {
    const auto [width, height] = a.options.raster;
    if (width < 1 || height < 1 || width > 32768 || height > 32768 || std::int64_t{width} * height > (1 << 28))
        throw InputError(fmt::format("a picture of {} x {} pixels: need 1 to 32768 each way and at most 2^28 in all",
                                     width, height));
    if (a.options.samples < 1 || a.options.samples > 1 << 20)
        throw InputError(fmt::format("--samples {}: need 1 to 2^20", a.options.samples));
    if (a.pattern != "auto") {
        a.options.pattern = pattern_named(a.pattern);
        if (!a.options.pattern)
            throw InputError(
                fmt::format("--pattern {}: need auto, regular, random, jittered, multi_jittered or sobol", a.pattern));
    }
    const auto filter = filter_named(a.filter);
    if (!filter) throw InputError(fmt::format("--filter {}: need box, tent or mitchell", a.filter));
    a.options.filter = *filter;
    if (!(a.options.error >= 0)) throw InputError(fmt::format("--error {}: need 0 (off) or more", a.options.error));
    const Pattern pattern = a.options.pattern.value_or(Pattern::sobol);
    if (a.options.error > 0 && pattern != Pattern::sobol && pattern != Pattern::random)
        throw InputError(
            fmt::format("--error needs a pattern that goes on when it is done: sobol or random, not {}", a.pattern));
    const auto partition = partition_named(a.partition);
    if (!partition) throw InputError(fmt::format("--partition {}: need auto, none, grid, octree or bvh", a.partition));
    a.options.partition = *partition;
    if (a.max_trace_level < 0 || a.max_trace_level > 256)
        throw InputError(
            fmt::format("--max-trace-level {}: need 1 to 256, or 0 for the scene's own", a.max_trace_level));
    if (a.options.threads < 0 || a.options.threads > 1024)
        throw InputError(fmt::format("--threads {}: need 0 (one a core) to 1024", a.options.threads));
}

Scene read(const Arguments& a) {
    ReadOptions options;
    options.raster = a.options.raster;
    Scene scene = read_scene(a.scene, options);
    for (const std::string& effect : a.without) remove_effect(scene, effect);
    if (a.max_trace_level > 0)
        scene.settings.max_trace_level = std::min(scene.settings.max_trace_level, a.max_trace_level);
    return scene;
}

Scene stage(const Arguments& a) {
    Scene scene = read(a);
    require_built(scene);
    if (!a.everything) {
        drop_what_is_not_needed(scene);
        drop_small_blur(scene, a.options.raster);
        drop_faint_branches(scene);
    }
    prepare(scene);
    return scene;
}

void list_unfinished() {
    const auto tasks = unfinished_tasks();
    for (const auto& t : tasks) fmt::print(stderr, "unfinished {} {}:{}\n", t.task, t.file, t.line);
    if (!tasks.empty())
        fmt::print(stderr, "striped pixels wait for these tasks; the handout of the step tells what to write\n");
}

// JSON text of a path: control characters and quotes never leave the string.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) >= 0x20) out += c;
    }
    return out + '"';
}

void write_stats(const std::string& path, const Seconds& seconds, const Residual& residual) {
    std::string unfinished;
    for (const auto& t : unfinished_tasks())
        unfinished += fmt::format("{}{{\"task\":{},\"file\":{},\"line\":{}}}", unfinished.empty() ? "" : ",",
                                  quoted(t.task), quoted(t.file), t.line);
    std::ofstream file(path);
    file << fmt::format(R"({{"unfinished":[{}],"seconds":{{"read":{:.6f},"render":{:.6f},"write":{:.6f}}},)",
                        unfinished, seconds.read, seconds.render, seconds.write)
         << fmt::format(R"("residual":{{"mean":{:.9g},"max":{:.9g},"x":{},"y":{}}},"samples":{:.9g}}})", residual.mean,
                        residual.max, residual.x, residual.y, residual.samples)
         << '\n';
    if (!file.flush())
        throw InputError(path + ": cannot write the statistics; check that the folder exists and has room");
}

void show_progress(double done) {
    fmt::print(stderr, "\r{:3.0f} %", 100 * done);
    if (done >= 1) fmt::print(stderr, "\r     \r");
}

int render_picture(Arguments& a) {
    if (a.output.empty()) throw InputError("where to? Give -o PICTURE.exr or -o PICTURE.png");
    Stopwatch watch;
    Seconds seconds;
    const Scene scene = stage(a);
    seconds.read = watch.lap();
    if (isatty(STDERR_FILENO)) a.options.progress = show_progress;
    Residual residual;
    const auto picture = make_picture_file(a.output, a.options.raster);
    render(scene, a.options, *picture, &residual);
    seconds.render = watch.lap();
    picture->finish();
    seconds.write = watch.lap();
    if (!a.stats.empty()) write_stats(a.stats, seconds, residual);
    for (const std::string& note : scene.notes) fmt::print(stderr, "note: {}\n", note);
    list_unfinished();
    return kSuccess;
}

int show_needs(const Arguments& a) {
    const Scene scene = read(a);
    std::cout << (a.json ? needs_to_json(scene) : needs_to_text(scene));
    return kSuccess;
}

int count_seen(const Arguments& a) {
    const Scene scene = stage(a);
    std::cout << seen_to_json(shapes_seen(scene, a.options));
    list_unfinished();
    return kSuccess;
}

int map_costs(const Arguments& a) {
    write_cost_map(cost_map(stage(a), a.options), a.cost_map);
    list_unfinished();
    return kSuccess;
}

int explain_pixel(const Arguments& a) {
    int x = 0, y = 0;
    char rest = 0;
    if (std::sscanf(a.pixel.c_str(), "%d,%d%c", &x, &y, &rest) != 2 || x < 0 || y < 0 || x >= a.options.raster.width ||
        y >= a.options.raster.height)
        throw InputError(fmt::format("--explain {}: need X,Y within {} x {}", a.pixel, a.options.raster.width,
                                     a.options.raster.height));
    PrivateOutput out;
    const Scene scene = stage(a);
    const QueryLog log = explain(scene, a.options, x, y);
    out << (a.visited ? visit_to_json(visit_of(scene, a.options, x, y)) + '\n'
            : a.json  ? log.to_json()
                      : log.to_text());
    list_unfinished();
    return kSuccess;
}

int run(Arguments& a) {
    if (a.answer) {
        std::ios::sync_with_stdio(false);
        PrivateOutput out;
        answer_questions(std::cin, out);
        return kSuccess;
    }
    if (a.scene.empty()) throw InputError("which scene? Give a .pov file, or --help");
    check(a);
    if (a.needs) return show_needs(a);
    if (a.seen) return count_seen(a);
    if (!a.pixel.empty()) return explain_pixel(a);
    if (!a.cost_map.empty()) return map_costs(a);
    return render_picture(a);
}

void declare(CLI::App& app, Arguments& a) {
    app.add_option("scene", a.scene, "the scene, a POV-Ray file (scenes/README.md)");
    app.add_option("-o,--output", a.output, "the picture: .exr (linear floats) or .png");
    app.add_option("--width", a.options.raster.width, "pixels")->capture_default_str();
    app.add_option("--height", a.options.raster.height, "pixels")->capture_default_str();
    app.add_option("--samples", a.options.samples, "a pixel; with --error: at most")->capture_default_str();
    app.add_option("--pattern", a.pattern, "of samples: auto, regular, random, jittered, multi_jittered or sobol")
        ->capture_default_str();
    app.add_option("--filter", a.filter, "of pixels: box, tent or mitchell")->capture_default_str();
    app.add_option("--error", a.options.error,
                   "go on until the standard error of a pixel is at most this; 0: all get --samples")
        ->capture_default_str();
    app.add_option("--seed", a.options.seed, "of everything random")->capture_default_str();
    app.add_option("--threads", a.options.threads, "0: one a core")->capture_default_str();
    app.add_option("--partition", a.partition, "auto, none, grid, octree or bvh; the picture is the same")
        ->capture_default_str();
    app.add_flag("!--no-packets", a.options.packets, "trace ray by ray; the picture is the same");
    app.add_option("--without", a.without, "leave an effect out (see --needs); may be repeated")
        ->allow_extra_args(false);
    app.add_option("--max-trace-level", a.max_trace_level,
                   "at most so many levels of rays, the camera's included; 0: as the scene says");
    app.add_option("--stats", a.stats, "write times and unfinished tasks to this file, as JSON");
    app.add_flag("--everything", a.everything, "compose also what the scene does not need; the picture stays the same");
    app.add_flag("--needs", a.needs, "say what the scene needs and what is left out");
    app.add_flag("--seen", a.seen, "count for each kind of shape the pixels whose centre sees it first, as JSON");
    app.add_option("--explain", a.pixel, "X,Y: the rays of a pixel");
    app.add_flag("--visited", a.visited,
                 "with --explain: the cells or leaves that the pixel's camera ray visits, as JSON");
    app.add_option("--cost-map", a.cost_map,
                   "an .exr with the channels tests and nodes: what every pixel costs with this --partition");
    app.add_flag("--json", a.json, "--needs and --explain in JSON");
    app.add_flag("--answer", a.answer, "answer the grader's questions on standard input");
}

}  // namespace
}  // namespace rays

int main(int argc, char** argv) {
    CLI::App app("Renders a scene.", "render");
    rays::Arguments arguments;
    rays::declare(app, arguments);
    try {
        app.parse(argc, argv);
        return rays::run(arguments);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::Error& e) {
        app.exit(e);
        return rays::kBadInput;
    } catch (const std::bad_alloc&) {
        std::fputs("error: out of memory; the scene or the picture is too large for this machine\n", stderr);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "error: %s\n", e.what());
    }
    return rays::kBadInput;
}
