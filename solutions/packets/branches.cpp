// What becomes of rays that have met something: step 3's mirrors and glass, for all rays of a batch at once.
#include <algorithm>
#include <cmath>

#include "packets/borders.h"
#include "packets/tracer.h"

namespace rays::packets {

/// Which rays are mirrored, which go through, and how much of them: tasks 3.9 to 3.11.
void Tracer::divide(Frame& f, const Chunk& chunk, const Surfaces& at) {
    f.normal.store(chunk, at.normal);
    const Reflection& mirror = at.finish->reflection;
    const Floats weight = chunk.load(f.batch.weight);
    Radiances share;
    if (!mirror.max.is_black() || !mirror.min.is_black()) {
        share = reflectivity(at, [&] { return fresnel_iors(f, chunk); });
        const unsigned lanes = (at.are & is_not_black(share)).bits();
        f.share.store(chunk, lanes, share);
        alignas(32) float weights[kLanes];
        (weight * (mirror.fresnel ? largest(share) : Floats(std::max(mirror.max.largest(), mirror.min.largest()))))
            .store(weights);
        each_lane(lanes, [&](int i) {
            f.mirrors.add(chunk.of[i]);
            f.mirror_weight[chunk.of[i]] = weights[i];
        });
    }
    const Radiances tint = tint_of(at, share);
    const Floats grey = abs(Floats(0.297f) * tint.r + Floats(0.589f) * tint.g + Floats(0.114f) * tint.b);
    const unsigned lanes = (at.are & is_greater(grey, Floats(scene_.settings.adc_bailout))).bits();
    f.tint.store(chunk, lanes, tint);
    each_lane(lanes, [&](int i) { f.clear.add(chunk.of[i]); });
    alignas(32) float left_out[kLanes];
    (weight * max(Floats(0.0f), largest(tint))).store(left_out);
    each_lane(chunk.lanes & ~lanes, [&](int i) { pruned_[f.batch.pixel[chunk.of[i]]] += left_out[i]; });
}

/// Neighbours mostly border on the same medium.
Reals Tracer::fresnel_iors(const Frame& f, const Chunk& chunk) const {
    Medium last = medium(f, chunk.of[0]);
    Real ior = fresnel_ior(scene_, f.batch.inside, last);
    Spread iors{Reals(ior)};
    for (int i = 1; i < kLanes; ++i) {
        const Medium next = medium(f, chunk.of[i]);
        if (next != last) ior = fresnel_ior(scene_, f.batch.inside, last = next);
        iors.lane[i] = ior;
    }
    return Reals::load(iors.lane);
}

void Tracer::start(Frame& next, const Frame& from, const Inside& inside, bool straight) const {
    next.batch.count = 0;
    next.batch.above = from.batch.above + 1;
    next.batch.level = from.batch.level + (from.batch.straight ? 0 : 1);
    next.batch.straight = straight;
    next.batch.inside = inside;
}

void Tracer::branch(const Frame& from, Number parent, const Spread3& directions, int lane, float weight, Frame& next) {
    Batch& batch = next.batch;
    const GlobalSettings& settings = scene_.settings;
    if (batch.above >= kMostAbove || batch.level >= settings.max_trace_level || weight < settings.adc_bailout) {
        pruned_[from.batch.pixel[parent]] += weight;
        return;
    }
    const auto n = static_cast<Number>(batch.count++);
    for (int a = 0; a < 3; ++a) batch.origin.of[a][n] = from.point.of[a][parent];
    batch.direction.set(n, directions, lane);
    batch.weight[n] = weight;
    batch.pixel[n] = from.batch.pixel[parent];
    batch.parent[n] = parent;
}

/// What comes through: each medium on its own, for what is behind follows from it. Where nothing can be refracted, the
/// mirror ray takes its place.
void Tracer::go_through(std::size_t depth) {
    Frame &f = frame(depth), &next = frame(depth + 1);
    Numbers total_reflection;
    for (Numbers rest = f.clear; rest.count > 0;) {
        const Medium crossed = medium(f, rest.of[0]);
        go_through(depth, take_alike(rest, [&](Number n) { return medium(f, n); }), crossed, total_reflection);
    }
    if (total_reflection.count == 0) return;
    start(next, f, f.batch.inside, false);
    each_chunk(total_reflection, [&](const Chunk& chunk) {
        const Spread3 direction(reflected(f.batch.direction.load(chunk), f.normal.load(chunk)));
        each_lane(chunk.lanes, [&](int i) {
            const Number n = chunk.of[i];
            branch(f, n, direction, i, f.batch.weight[n] * f.tint.largest(n), next);
        });
    });
    trace(depth + 1);
    for (int c = 0; c < next.batch.count; ++c) {
        const Number n = next.batch.parent[c];
        const Interior* fades = fading(f, medium(f, n));
        for (int k = 0; k < 3; ++k) {
            const float brought = next.brought.of[k][c];
            f.brought.of[k][n] += fades ? brought * absorption(*fades, f.distance[n])[k] : brought;
        }
    }
    const Numbers before = f.mirrors;
    f.mirrors.count = 0;
    for (const Number n : before)
        if (std::find(total_reflection.begin(), total_reflection.end(), n) == total_reflection.end()) f.mirrors.add(n);
}

void Tracer::go_through(std::size_t depth, const Numbers& rays, Medium medium, Numbers& total_reflection) {
    Frame &f = frame(depth), &next = frame(depth + 1);
    Inside beyond = f.batch.inside;
    const Real relative_ior = cross_border(scene_, beyond, medium);
    const bool straight = std::abs(relative_ior - 1) < Real(1e-10);
    start(next, f, beyond, straight);
    each_chunk(rays, [&](const Chunk& chunk) {
        const Vec3s d = f.batch.direction.load(chunk);
        const Refracted bent =
            straight ? Refracted{Mask::of(kAllLanes), d} : refracted(d, f.normal.load(chunk), relative_ior);
        const Spread3 direction(bent.direction);
        const unsigned passes = bent.are.bits();
        each_lane(chunk.lanes & passes, [&](int i) {
            const Number n = chunk.of[i];
            branch(f, n, direction, i, f.batch.weight[n] * f.tint.largest(n), next);
        });
        each_lane(chunk.lanes & ~passes, [&](int i) { total_reflection.add(chunk.of[i]); });
    });
    trace(depth + 1);
    if (const Interior* fades = fading(f, medium)) fade(*fades, f, next);
    for (int c = 0; c < next.batch.count; ++c) {
        const Number n = next.batch.parent[c];
        for (int k = 0; k < 3; ++k) f.brought.of[k][n] += f.tint.of[k][n] * next.brought.of[k][c];
    }
}

/// What takes light on the way to hits that border on `medium`, if that is what the way led through: task 3.6.
const Interior* Tracer::fading(const Frame& f, Medium medium) const {
    const Interior* interior = interior_of(scene_, medium);
    const bool fades = interior && interior->fade_distance > 0 && f.batch.inside.contains(medium);
    return fades ? interior : nullptr;
}

/// Takes that from what the rays of `next` bring.
void Tracer::fade(const Interior& interior, const Frame& f, Frame& next) const {
    for (int first = 0; first < next.batch.count; first += kLanes) {
        Spread distances;
        for (int i = 0; i < kLanes; ++i)
            distances.lane[i] = f.distance[next.batch.parent[std::min(first + i, next.batch.count - 1)]];
        next.brought.multiply(first, absorption(interior, Reals::load(distances.lane)));
    }
}

void Tracer::mirror(std::size_t depth) {
    Frame &f = frame(depth), &next = frame(depth + 1);
    start(next, f, f.batch.inside, false);
    each_chunk(f.mirrors, [&](const Chunk& chunk) {
        const Spread3 direction(reflected(f.batch.direction.load(chunk), f.normal.load(chunk)));
        each_lane(chunk.lanes,
                  [&](int i) { branch(f, chunk.of[i], direction, i, f.mirror_weight[chunk.of[i]], next); });
    });
    if (next.batch.count > 0) trace(depth + 1);
    for (int c = 0; c < next.batch.count; ++c) {
        const Number n = next.batch.parent[c];
        const float exponent = scene_.materials[f.material[n]].finish.reflection.exponent;
        for (int k = 0; k < 3; ++k) {
            float brought = next.brought.of[k][c];
            if (exponent != 1) brought = std::pow(std::max(0.0f, brought), exponent);
            f.brought.of[k][n] += f.share.of[k][n] * brought;
        }
    }
}

}  // namespace rays::packets
