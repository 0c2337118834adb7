#include "packets/tracer.h"

#include <algorithm>
#include <array>

namespace rays::packets {
namespace {

/// Fewer rays are faster one by one; measured (NOTES.md).
constexpr int kFewest = 3;

/// 0, 1, 2, ..
constexpr auto kInOrder = [] {
    std::array<Number, Block::kSize> numbers{};
    for (int n = 0; n < Block::kSize; ++n) numbers[static_cast<std::size_t>(n)] = static_cast<Number>(n);
    return numbers;
}();

/// Step 1's camera_ray for the pixels of a block, directions made of unit length.
class CameraRays {
public:
    CameraRays(const Camera& camera, const Raster& raster, Block block, Vec2 offset) : camera_(camera) {
        for (int part = 0; part < kParts; ++part) {
            const Reals count = Reals(double(part * kLanes)) + Reals(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0);
            const Reals from_left = (Reals(block.x) + count + Reals(0.5) + Reals(offset.x)) / Reals(raster.width);
            const Reals from_top = (Reals(block.y) + count + Reals(0.5) + Reals(offset.y)) / Reals(raster.height);
            column_[part] = from_left - Reals(0.5);
            row_[part] = Spread(Reals(0.5) - from_top);
        }
    }

    /// Those from `first` on: two rows of four pixels.
    Rays eight(int first) const {
        const int row = 2 * Block::down(first / kLanes), across = Block::across(first / kLanes);
        const Reals& eight = column_[across / 2];
        const __m256d columns = across % 2 == 0 ? eight.first_four() : eight.last_four();
        const Spread& rows = row_[row / kLanes];
        const Reals x(columns, columns), y(_mm256_set1_pd(rows[row % kLanes]), _mm256_set1_pd(rows[row % kLanes + 1]));
        const Vec3s right(camera_.right), up(camera_.up), direction(camera_.direction), location(camera_.location);
        if (camera_.kind == Camera::Kind::orthographic) return {location + x * right + y * up, normalize(direction)};
        return {location, normalize(direction + x * right + y * up)};
    }

private:
    static constexpr int kParts = Block::kSide / kLanes;  ///< of eight columns and eight rows
    const Camera& camera_;
    Reals column_[kParts];  ///< on the film, from the left to the right edge -1/2 to 1/2
    Spread row_[kParts];    ///< downwards, 1/2 to -1/2
};

}  // namespace

Tracer::Tracer(const PacketIntersector& intersector, World& world)
    : scene_(world.scene),
      intersector_(intersector),
      world_(world),
      lamps_(world.scene.lights.begin(), world.scene.lights.end()),
      look_alikes_(look_alikes(world.scene)),
      shadows_(intersector, world),
      has_exponents_(std::any_of(scene_.materials.begin(), scene_.materials.end(),
                                 [](const Material& m) { return m.finish.reflection.exponent != 1; })) {}

Tracer::Frame& Tracer::frame(std::size_t depth) {
    while (frames_.size() <= depth) frames_.push_back(std::make_unique<Frame>());
    return *frames_[depth];
}

void Tracer::add_radiance(const Raster& raster, Block block, Vec2 offset, const Inside& inside,
                          Radiance (&sum)[Block::kSize], double (&pruned)[Block::kSize]) {
    pruned_ = pruned;
    Frame& first = frame(0);
    first.batch.count = first.batch.above = first.batch.level = 0;
    first.batch.straight = false;
    first.batch.inside = inside;
    add_camera_rays(raster, block, offset, first);
    trace(0);
    if (first.batch.count == Block::kSize) return first.brought.add_to(sum);
    for (int n = 0; n < first.batch.count; ++n) sum[first.batch.pixel[n]] += first.brought[static_cast<Number>(n)];
}

void Tracer::trace(const SampleRays& rays, const Inside& inside, Radiance (&brought)[SampleRays::kMost],
                   double (&pruned)[SampleRays::kMost]) {
    pruned_ = pruned;
    samples_ = &rays;
    Frame& first = frame(0);
    Batch& batch = first.batch;
    batch.count = rays.count;
    batch.above = batch.level = 0;
    batch.straight = false;
    batch.inside = inside;
    for (int a = 0; a < 3; ++a) {
        std::copy(rays.origin[a], rays.origin[a] + rays.count, batch.origin.of[a]);
        std::copy(rays.direction[a], rays.direction[a] + rays.count, batch.direction.of[a]);
    }
    std::fill(batch.weight, batch.weight + rays.count, 1.0f);
    for (int n = 0; n < rays.count; ++n) batch.pixel[n] = static_cast<Number>(n);
    trace(0);
    for (int n = 0; n < rays.count; ++n) brought[n] = first.brought[static_cast<Number>(n)];
    samples_ = nullptr;
}

void Tracer::add_camera_rays(const Raster& raster, Block block, Vec2 offset, Frame& frame) const {
    Batch& batch = frame.batch;
    std::fill(batch.weight, batch.weight + Block::kSize, 1.0f);
    const CameraRays camera_rays(scene_.camera, raster, block, offset);
    for (int first = 0; first < Block::kSize; first += kLanes) {
        const Rays rays = camera_rays.eight(first);
        if (block.column(first + 3) < raster.width && block.row(first + 4) < raster.height) {
            batch.origin.store(batch.count, rays.origin);
            batch.direction.store(batch.count, rays.direction);
            for (int i = 0; i < kLanes; ++i) batch.pixel[batch.count++] = static_cast<Number>(first + i);
            continue;
        }
        const Spread3 origin(rays.origin), direction(rays.direction);
        for (int i = 0; i < kLanes; ++i) {
            if (block.column(first + i) >= raster.width || block.row(first + i) >= raster.height) continue;
            const auto n = static_cast<Number>(batch.count++);
            batch.origin.set(n, origin, i);
            batch.direction.set(n, direction, i);
            batch.pixel[n] = static_cast<Number>(first + i);
        }
    }
}

void Tracer::trace(std::size_t depth) {
    Frame& f = frame(depth);
    if (f.batch.count < kFewest) return trace_single(f);
    f.mirrors.count = f.clear.count = 0;
    meet(f);
    while (f.hits.count > 0) {
        take_alike(f.hits, f.alike, [&](Number n) { return look_alikes_[f.material[n]]; });
        light(f, f.alike);
    }
    if (f.clear.count > 0) go_through(depth);
    if (f.mirrors.count > 0) mirror(depth);
}

void Tracer::trace_single(Frame& f) {
    world_.above = f.batch.above;
    for (int i = 0; i < f.batch.count; ++i) {
        const auto n = static_cast<Number>(i);
        Branch branch;
        branch.ray = f.batch.ray(n);
        branch.level = f.batch.level;
        branch.straight = f.batch.straight;
        branch.weight = f.batch.weight[n];
        branch.inside = f.batch.inside;
        if (samples_) see_as(f.batch.pixel[n]);
        world_.pruned = pruned_[f.batch.pixel[n]];  // goes on from there: sums depend on their order
        f.brought.set(n, rays::trace(world_, branch));
        pruned_[f.batch.pixel[n]] = world_.pruned;
    }
}

/// The world as a sample has it.
void Tracer::see_as(Number sample) {
    if (!samples_->light.empty()) {
        lights_ = scene_.lights;
        for (std::size_t l = 0; l < lights_.size(); ++l) {
            for (int a = 0; a < 3; ++a) lights_[l].location[a] = samples_->light[3 * l + std::size_t(a)][sample];
            lights_[l].area = false;
        }
        world_.lights = lights_;
    }
    single_roughness_.samples = samples_;
    single_roughness_.ray = sample;
    world_.roughness = samples_->roughness ? &single_roughness_ : nullptr;
}

/// As trace() of step 3 does it, lane by lane. True normals and those for shading are the same here: nobody
/// gives other scenes to packets.
void Tracer::tilt(const Frame& f, const Chunk& chunk, Surfaces& at) const {
    const Spread3 point(at.point), normal(at.normal), viewer(at.to_viewer);
    Spread tilted[3] = {Spread(at.normal.x), Spread(at.normal.y), Spread(at.normal.z)};
    each_lane(chunk.lanes, [&](int i) {
        Surface surface;
        surface.point = point[i];
        surface.normal = surface.geometric_normal = normal[i];
        surface.to_viewer = viewer[i];
        surface.finish = at.finish;
        samples_->roughness->tilt(at.tree[i], surface, f.batch.above);
        for (int a = 0; a < 3; ++a) tilted[a].lane[i] = surface.normal[a];
    });
    at.normal = {Reals::load(tilted[0].lane), Reals::load(tilted[1].lane), Reals::load(tilted[2].lane)};
}

/// Finds what the rays meet. The others bring the background.
void Tracer::meet(Frame& f) const {
    Numbers& met = f.hits;
    met.count = 0;
    const Radiances background(scene_.background);
    const auto meet_chunk = [&](const Chunk& chunk) {
        const Hits hits =
            intersector_.nearest(f.batch.load(chunk), Mask::of(chunk.lanes), {Reals(kNearest), Reals(kFarthest)});
        f.brought.store(chunk, chunk.lanes & ~hits.are, background);
        if (hits.are == 0) return;
        if (chunk.is_run) {  // what is stored for those that meet nothing is not looked at
            const Number first = chunk.of[0];
            std::copy(hits.t.lane, hits.t.lane + kLanes, f.distance + first);
            f.point.store(first, hits.point.load());
            f.normal.store(first, hits.normal.load());
            std::copy(hits.object, hits.object + kLanes, f.object + first);
            std::copy(hits.material, hits.material + kLanes, f.material + first);
            met.add(chunk.of, hits.are);
            return;
        }
        each_lane(hits.are, [&](int i) {
            const Number n = chunk.of[i];
            met.add(n);
            f.distance[n] = hits.t[i];
            f.point.set(n, hits.point, i);
            f.normal.set(n, hits.normal, i);
            f.object[n] = hits.object[i];
            f.material[n] = hits.material[i];
        });
    };
    // Camera rays go the same way as they are.
    if (f.batch.level == 0 || intersector_.takes_any_way())
        for (int first = 0; first < f.batch.count; first += kLanes)
            meet_chunk(Chunk(kInOrder.data(), first, f.batch.count));
    else
        each_chunk_by_way(f.batch.direction, f.batch.count, meet_chunk);
}

/// Direct light of hits on materials that look alike, and what becomes of their rays.
void Tracer::light(Frame& f, const Numbers& hits) {
    const Material& material = scene_.materials[f.material[hits.of[0]]];
    const Reflection& mirror = material.finish.reflection;
    const bool goes_on = lets_light_through(material.pigment) || !mirror.max.is_black() || !mirror.min.is_black();
    each_chunk(hits, [&](const Chunk& chunk) {
        std::uint32_t materials[kLanes];
        for (int i = 0; i < kLanes; ++i) materials[i] = f.material[chunk.of[i]];
        Surfaces at = surfaces_at(scene_, Mask::of(chunk.lanes), f.point.load(chunk), f.normal.load(chunk),
                                  -f.batch.direction.load(chunk), materials);
        for (int i = 0; i < kLanes; ++i) at.object[i] = f.object[chunk.of[i]];
        if (samples_) {
            for (int i = 0; i < kLanes; ++i) at.tree[i] = f.batch.pixel[chunk.of[i]];
            if (samples_->roughness && material.finish.glossy > 0) tilt(f, chunk, at);
        }
        f.brought.store(chunk, chunk.lanes, direct_light(scene_, lamps_, shadows_, samples_, at, f.batch.inside));
        if (goes_on) divide(f, chunk, material, at);
    });
}

}  // namespace rays::packets
