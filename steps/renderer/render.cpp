#include "renderer/render.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <thread>
#include <vector>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"
#include "renderer/brute_force.h"
#include "renderer/camera_media.h"
#include "renderer/distribute.h"
#include "renderer/packets.h"
#include "renderer/radiance.h"
#include "renderer/rows.h"

namespace rays {
namespace {

/// From the scene's numbers to the light that they stand for. Samples of a pixel are averaged before, as in POV-Ray.
void develop(Film& film, const Gamma& gamma) {
    if (gamma.is_linear()) return;
    for (int y = 0; y < film.raster().height; ++y) {
        float known[3] = {0, 0, 0}, light[3] = {to_light(0, gamma), to_light(0, gamma), to_light(0, gamma)};
        for (int x = 0; x < film.raster().width; ++x) {
            Radiance& pixel = film.at(x, y);
            for (int c = 0; c < 3; ++c) {  // flat parts of a picture cost nothing
                if (pixel[c] != known[c]) light[c] = to_light(known[c] = pixel[c], gamma);
                pixel[c] = light[c];
            }
        }
    }
}

/// A regular grid of points in a pixel, as offsets from its centre.
class Grid {
public:
    explicit Grid(int samples) : side_(static_cast<int>(std::lround(std::sqrt(samples)))) {}

    template <class What>
    void each(What what) const {
        for (int j = 0; j < side_; ++j)
            for (int i = 0; i < side_; ++i)
                what(Vec2((i + Real(0.5)) / side_ - Real(0.5), (j + Real(0.5)) / side_ - Real(0.5)));
    }
    float weight() const { return weight_; }
    Radiance mean(const Radiance& sum) const { return weight_ * sum; }

private:
    int side_;
    float weight_ = 1.0f / static_cast<float>(side_ * side_);
};

void render_row(World& world, const CameraMedia& media, const RenderOptions& options, int y, Film& lines, int first,
                Residuals& residuals) {
    const Grid grid(options.samples);
    for (int x = 0; x < options.raster.width; ++x) {
        world.pruned = 0;
        Radiance sum;
        grid.each([&](Vec2 offset) {
            const Ray ray = camera_ray(world.scene.camera, options.raster, x, y, offset);
            sum += radiance(world, ray, media.at(ray.origin));
        });
        lines.at(x, y - first) = take_unfinished_task() ? striped(grid.mean(sum), x, y) : grid.mean(sum);
        residuals.add(x, y, world.pruned / options.samples);
    }
}

/// What the pixels of a block have gathered. Copied and emptied as a whole: pixel by pixel that took as long as finding
/// out that nothing is there.
class Gathered {
public:
    Radiance sum[Block::kSize];
    double pruned[Block::kSize] = {};

    /// Moves the light, times `weight`, to the lines that begin where the block does: all of it, or as far as the block
    /// is in the picture.
    void move_light(const Block& block, float weight, Film& lines) {
        const Raster& raster = lines.raster();
        const bool is_whole = block.x + Block::kSide <= raster.width && Block::kSide <= raster.height;
        for (int i = 0; i < Block::kSize; i += Block::kRun) {
            const int x = block.column(i), y = block.row(i) - block.y;
            if (!is_whole && y >= raster.height) continue;
            const int count = is_whole ? Block::kRun : std::clamp(raster.width - x, 0, Block::kRun);
            for (int k = 0; k < count; ++k)
                for (int c = 0; c < 4; ++c) lines.at(x + k, y)[c] = weight * sum[i + k][c];
        }
        std::fill(sum, sum + Block::kSize, Radiance());
    }
    void move_pruned(const Block& block, int samples, Residuals& residuals) {
        static constexpr double kNothing[Block::kSize] = {};
        if (std::memcmp(pruned, kNothing, sizeof kNothing) == 0) return;
        for (int i = 0; i < Block::kSize; ++i)
            if (pruned[i] != 0) residuals.add(block.column(i), block.row(i), pruned[i] / samples);
        std::fill(pruned, pruned + Block::kSize, 0.0);
    }
};

/// A row of blocks from y downwards, as far as they are in the picture.
void render_packets(PacketTracer& tracer, const Inside& media, const RenderOptions& options, int y, Film& lines,
                    Residuals& residuals) {
    const Grid grid(options.samples);
    Gathered gathered;
    for (Block block{0, y}; block.x < options.raster.width; block.x += Block::kSide) {
        grid.each([&](Vec2 offset) {
            tracer.add_radiance(options.raster, block, offset, media, gathered.sum, gathered.pruned);
        });
        gathered.move_light(block, grid.weight(), lines);
        gathered.move_pruned(block, options.samples, residuals);
    }
}

}  // namespace

void prepare(Scene& scene) {
    for (Polygon& polygon : scene.polygons) prepare(polygon);
    for (Mesh& mesh : scene.meshes) prepare(mesh);
    for (BicubicPatch& patch : scene.patches) prepare(patch);
    take_unfinished_task();
}

std::unique_ptr<Intersector> make_intersector(const Scene& scene, Partition partition) {
    const bool chosen = partition == Partition::automatic;
    if (chosen) partition = choose_partition(scene);
    std::unique_ptr<Intersector> structure;
    if (partition != Partition::none) structure = make_structure(scene, partition);
    // Asking everybody stands in for what is not written. Who asked for that very structure is told so in every pixel.
    const char* waits_for = take_unfinished_task();
    if (!structure) structure = std::make_unique<BruteForce>(scene, chosen ? nullptr : waits_for);
    return structure;
}

namespace {

constexpr int kLinesTogether = 4;  ///< ray by ray: few, so that threads end together

/// One sample in each pixel's centre, or a regular grid of them.
void render_regularly(const Scene& scene, const RenderOptions& options, FilmLines& picture, Residual* residual) {
    // Packets take the place of the automatic choice only.
    const bool may_pack = options.packets && options.partition == Partition::automatic;
    const auto packets = may_pack ? make_packets(scene) : nullptr;
    const auto own = packets ? nullptr : make_intersector(scene, options.partition);
    const World prototype = make_world(scene, packets ? packets->intersector() : *own);
    const CameraMedia media(prototype);
    // All rays of a packet must start in the same media.
    const auto everywhere = packets ? media.everywhere() : std::nullopt;
    Residuals residuals(options.raster.height);
    const int together = everywhere ? Block::kSide : kLinesTogether;
    std::atomic<int> next_row{0};
    const auto work = [&](bool reports) {
        World world = prototype;
        const auto tracer = everywhere ? packets->tracer(world) : nullptr;
        Film lines({options.raster.width, together});
        for (int y; (y = next_row.fetch_add(together)) < options.raster.height;) {
            const int end = std::min(y + together, options.raster.height);
            if (end - y < together) lines = Film({options.raster.width, end - y});
            if (tracer)
                render_packets(*tracer, *everywhere, options, y, lines, residuals);
            else
                for (int row = y; row < end; ++row) render_row(world, media, options, row, lines, y, residuals);
            develop(lines, scene.settings.gamma);
            picture.take(lines, y);
            if (reports && options.progress) options.progress(double(end) / options.raster.height);
        }
    };
    const int wanted = options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
    std::vector<std::jthread> helpers;
    for (int i = 1; i < std::min(wanted, options.raster.height); ++i) helpers.emplace_back(work, false);
    work(true);
    helpers.clear();
    if (residual) *residual = residuals.over(options.raster), residual->samples = options.samples;
}

bool is_square(int n) {
    const auto side = std::lround(std::sqrt(n));
    return side * side == n;
}

}  // namespace

bool is_distributed(const Scene& scene, const RenderOptions& options) {
    return needs_distribution(scene) || options.pattern || options.filter != Filter::box || options.error > 0 ||
           !is_square(options.samples);
}

void render(const Scene& scene, const RenderOptions& options, FilmLines& picture, Residual* residual) {
    if (!is_distributed(scene, options)) return render_regularly(scene, options, picture, residual);
    Film film = render_distributed(scene, options, residual);
    develop(film, scene.settings.gamma);
    picture.take(film, 0);
}

Film render(const Scene& scene, const RenderOptions& options, Residual* residual) {
    WholeFilm whole(options.raster);
    render(scene, options, whole, residual);
    return std::move(whole.film);
}

QueryLog explain(const Scene& scene, const RenderOptions& options, int column, int row) {
    if (needs_distribution(scene)) {
        const Distribution distribution(scene, options);
        SampleTracer tracer(distribution);
        QueryLog log;
        query_log = &log;
        tracer.sample(column, row, distribution.draw(column, row, 0, static_cast<std::uint32_t>(options.samples)));
        query_log = nullptr;
        return log;
    }
    const auto intersector = make_intersector(scene, options.partition);
    World world = make_world(scene, *intersector);
    const Ray ray = camera_ray(scene.camera, options.raster, column, row);
    QueryLog log;
    query_log = &log;
    radiance(world, ray, CameraMedia(world).at(ray.origin));
    query_log = nullptr;
    return log;
}

}  // namespace rays
