// What becomes of rays that have met something: step 3's mirrors and glass, for all rays of a batch at once.
#include <algorithm>
#include <cmath>

#include "packets/borders.h"
#include "packets/tracer.h"

namespace rays::packets {

/// Which rays are mirrored, which go through, and how much of them: tasks 3.9 to 3.11.
void Tracer::divide(Frame& f, const Chunk& chunk, const Material& material, const Surfaces& at) {
    f.normal.store(chunk, at.normal);
    const Reflection& mirror = material.finish.reflection;
    const Floats weight = chunk.load(f.batch.weight);
    Radiances share;
    if (!mirror.max.is_black() || !mirror.min.is_black()) {
        share = reflectivity(at, [&] { return fresnel_iors(f, chunk); });
        const unsigned lanes = (at.are & is_not_black(share)).bits();
        const Floats most =
            mirror.fresnel ? largest(share) : Floats(std::max(mirror.max.largest(), mirror.min.largest()));
        f.share.store(chunk, lanes, share);
        chunk.store(f.mirror_weight, lanes, weight * most);
        f.mirrors.add(chunk.of, lanes);
    }
    if (!lets_light_through(material.pigment)) return;
    const Radiances tint = tint_of(at, share);
    const Floats grey = abs(Floats(0.297f) * tint.r + Floats(0.589f) * tint.g + Floats(0.114f) * tint.b);
    const unsigned lanes = (at.are & is_greater(grey, Floats(scene_.settings.adc_bailout))).bits();
    f.tint.store(chunk, lanes, tint);
    f.clear.add(chunk.of, lanes);
    prune(f, chunk, chunk.lanes & ~lanes, weight * max(Floats(0.0f), largest(tint)));
}

/// Leaves out what these rays would have brought.
void Tracer::prune(const Frame& f, const Chunk& chunk, unsigned rays, Floats weight) {
    if (rays == 0) return;
    alignas(32) float weights[kLanes];
    weight.store(weights);
    each_lane(rays, [&](int i) { pruned_[f.batch.pixel[chunk.of[i]]] += weights[i]; });
}

/// Neighbours mostly border on the same medium.
Reals Tracer::fresnel_iors(const Frame& f, const Chunk& chunk) const {
    Medium last = medium(f, chunk.of[0]);
    Real ior = fresnel_ior(scene_, f.batch.inside, last);
    if (std::all_of(chunk.of + 1, chunk.of + kLanes, [&](Number n) { return medium(f, n) == last; })) return ior;
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

void Tracer::branch(const Frame& from, const Chunk& chunk, unsigned rays, const Vec3s& directions, Floats weight,
                    Frame& next) {
    Batch& batch = next.batch;
    const GlobalSettings& settings = scene_.settings;
    if (batch.above >= kMostAbove || batch.level >= settings.max_trace_level) return prune(from, chunk, rays, weight);
    const unsigned too_little = is_less(weight, Floats(settings.adc_bailout)).bits() & rays;
    prune(from, chunk, too_little, weight);
    batch.add(from.batch, chunk, rays & ~too_little, {from.point.load(chunk), directions}, weight);
}

// A tree may be a thousand levels deep: what has registers full of lanes on the stack stays out of the functions that
// wait for the next level.

/// What comes through: each medium on its own, for what is behind follows from it. Where nothing can be refracted, the
/// mirror ray takes its place.
void Tracer::go_through(std::size_t depth) {
    Frame &f = frame(depth), &next = frame(depth + 1);
    f.total_reflection.count = 0;
    while (f.clear.count > 0) {
        const Medium crossed = medium(f, f.clear.of[0]);
        take_alike(f.clear, f.alike, [&](Number n) { return medium(f, n); });
        send_through(f, crossed, next);
        trace(depth + 1);
        if (const Interior* fades = fading(f, crossed)) fade(*fades, f, next);
        bring_home(f, next, &f.tint);
    }
    if (f.total_reflection.count == 0) return;
    send_mirrored(f, f.total_reflection, next);
    trace(depth + 1);
    for (int c = 0; c < next.batch.count; ++c) {
        const Number n = next.batch.parent[c];
        if (const Interior* fades = fading(f, medium(f, n))) {
            const Radiance left = absorption(*fades, f.distance[n]);
            for (int k = 0; k < 3; ++k) next.brought.of[k][c] *= left[k];
        }
    }
    bring_home(f, next, nullptr);
    const Numbers& all = f.total_reflection;
    const auto is_total = [&](Number n) { return std::find(all.begin(), all.end(), n) != all.end(); };
    f.mirrors.count =
        static_cast<int>(std::remove_if(f.mirrors.of, f.mirrors.of + f.mirrors.count, is_total) - f.mirrors.of);
}

/// Rays that are `alike`, into the medium or out of it. Those that cannot are listed, with the weight of their mirror
/// ray.
[[gnu::noinline]] void Tracer::send_through(Frame& f, Medium medium, Frame& next) {
    Inside beyond = f.batch.inside;
    const Real relative_ior = cross_border(scene_, beyond, medium);
    const bool straight = std::abs(relative_ior - 1) < Real(1e-10);
    start(next, f, beyond, straight);
    each_chunk(f.alike, [&](const Chunk& chunk) {
        const Vec3s d = f.batch.direction.load(chunk);
        const Refracted bent = straight ? Refracted{Mask::of(kAllLanes), d}
                                        : refracted(Mask::of(chunk.lanes), d, f.normal.load(chunk), relative_ior);
        const unsigned passes = bent.are.bits() & chunk.lanes, reflected = chunk.lanes & ~passes;
        const Floats weight = chunk.load(f.batch.weight) * largest(f.tint.load(chunk));
        branch(f, chunk, passes, bent.direction, weight, next);
        chunk.store(f.mirror_weight, reflected, weight);
        f.total_reflection.add(chunk.of, reflected);
    });
}

[[gnu::noinline]] void Tracer::send_mirrored(const Frame& f, const Numbers& rays, Frame& next) {
    start(next, f, f.batch.inside, false);
    each_chunk(rays, [&](const Chunk& chunk) {
        branch(f, chunk, chunk.lanes,
               reflected(Mask::of(chunk.lanes), f.batch.direction.load(chunk), f.normal.load(chunk)),
               chunk.load(f.mirror_weight), next);
    });
}

/// Adds what the rays of `next` bring, or their share of it, to what those bring that they come from.
[[gnu::noinline]] void Tracer::bring_home(Frame& f, const Frame& next, const LightColumns* share) const {
    for (int first = 0; first < next.batch.count; first += kLanes) {
        const Chunk parents(next.batch.parent, first, next.batch.count);
        const Radiances brought = next.brought.load(first);
        f.brought.store(parents, parents.lanes,
                        f.brought.load(parents) + (share ? share->load(parents) * brought : brought));
    }
}

/// What takes light on the way to hits that border on `medium`, if that is what the way led through: task 3.6.
const Interior* Tracer::fading(const Frame& f, Medium medium) const {
    const Interior* interior = interior_of(scene_, medium);
    const bool fades = interior && interior->fade_distance > 0 && f.batch.inside.contains(medium);
    return fades ? interior : nullptr;
}

/// Takes that from what the rays of `next` bring.
[[gnu::noinline]] void Tracer::fade(const Interior& interior, const Frame& f, Frame& next) const {
    for (int first = 0; first < next.batch.count; first += kLanes) {
        Spread distances;
        for (int i = 0; i < kLanes; ++i)
            distances.lane[i] = f.distance[next.batch.parent[std::min(first + i, next.batch.count - 1)]];
        next.brought.multiply(first, absorption(interior, Reals::load(distances.lane)));
    }
}

void Tracer::mirror(std::size_t depth) {
    Frame &f = frame(depth), &next = frame(depth + 1);
    send_mirrored(f, f.mirrors, next);
    if (next.batch.count > 0) trace(depth + 1);
    if (has_exponents_) raise(f, next);
    bring_home(f, next, &f.share);
}

/// What mirrors with an exponent make of what the rays of `next` bring.
void Tracer::raise(const Frame& f, Frame& next) const {
    for (int c = 0; c < next.batch.count; ++c) {
        const float exponent = scene_.materials[f.material[next.batch.parent[c]]].finish.reflection.exponent;
        if (exponent == 1) continue;
        for (auto& brought : next.brought.of) brought[c] = std::pow(std::max(0.0f, brought[c]), exponent);
    }
}

}  // namespace rays::packets
