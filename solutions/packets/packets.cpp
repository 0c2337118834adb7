// Step 3 for eight rays at once: what they meet is lit together, and mirrored and refracted together while enough of
// them stay together.
#include "renderer/packets.h"

#include <bit>
#include <cmath>

#include "packets/intersector.h"
#include "packets/shading.h"

namespace rays {
namespace packets {
namespace {

// Of the pixels of a block.
const Reals kColumns{_mm256_setr_pd(0, 1, 2, 3), _mm256_setr_pd(0, 1, 2, 3)};
const Reals kRows{_mm256_setzero_pd(), _mm256_set1_pd(1)};
static_assert(kPacketWidth == 4 && kPacketHeight == 2 && kPacketSize == kLanes);

/// What each ray brings, in memory: lanes are written group by group.
struct Brought {
    alignas(32) float lanes[3][kLanes] = {};

    void set(Mask where, const Radiances& all) {
        const Radiances mixed = select(where, all, load());
        mixed.r.store(lanes[0]), mixed.g.store(lanes[1]), mixed.b.store(lanes[2]);
    }
    void set(int i, const Radiance& one) {
        for (int c = 0; c < 3; ++c) lanes[c][i] = one[c];
    }
    Radiances load() const { return {Floats::load(lanes[0]), Floats::load(lanes[1]), Floats::load(lanes[2])}; }
};

/// Eight branches of one level, all of them in the same media.
struct Branches {
    Rays rays;
    Mask active;
    int level = 0;
    Floats weight{1.0f};
    const Inside& inside;
    bool straight = false;
};

Mask in_raster(const Raster& raster, Block block) {
    const Reals columns = Reals(block.x) + kColumns, rows = Reals(block.y) + kRows;
    return (columns < Reals(raster.width)) & (rows < Reals(raster.height));
}

/// Step 1's camera_ray, its direction made of unit length.
Rays camera_rays(const Camera& camera, const Raster& raster, Block block, Vec2 offset) {
    const Reals from_left = (Reals(block.x) + kColumns + Reals(0.5) + Reals(offset.x)) / Reals(raster.width);
    const Reals from_top = (Reals(block.y) + kRows + Reals(0.5) + Reals(offset.y)) / Reals(raster.height);
    const Reals x = from_left - Reals(0.5), y = Reals(0.5) - from_top;
    const Vec3s right(camera.right), up(camera.up), direction(camera.direction), location(camera.location);
    if (camera.kind == Camera::Kind::orthographic) return {location + x * right + y * up, normalize(direction)};
    return {location, normalize(direction + x * right + y * up)};
}

class Tracer final : public PacketTracer {
public:
    Tracer(const PacketIntersector& intersector, World& world)
        : scene_(world.scene), intersector_(intersector), world_(world), shadows_(intersector, world) {}

    void add_radiance(const Raster& raster, Block block, Vec2 offset, const Inside& inside,
                      Radiance (&sum)[kPacketSize], double (&pruned)[kPacketSize]) override {
        pruned_ = pruned;
        Brought brought;
        trace({camera_rays(scene_.camera, raster, block, offset), in_raster(raster, block), 0, Floats(1.0f), inside},
              brought);
        for (int half = 0; half < kLanes; half += 4) {
            __m128 rows[4] = {_mm_load_ps(&brought.lanes[0][half]), _mm_load_ps(&brought.lanes[1][half]),
                              _mm_load_ps(&brought.lanes[2][half]), _mm_setzero_ps()};
            _MM_TRANSPOSE4_PS(rows[0], rows[1], rows[2], rows[3]);
            for (int i = 0; i < 4; ++i) {
                float* lane = sum[half + i].lane;
                _mm_store_ps(lane, _mm_add_ps(_mm_load_ps(lane), rows[i]));
            }
        }
    }

private:
    /// Below so many rays, single ones are faster; measured (NOTES.md).
    static constexpr int kFewest = 3;

    void trace(const Branches& branches, Brought& brought) {
        const unsigned active = branches.active.bits();
        if (std::popcount(active) < kFewest) return trace_single(branches, brought);
        const Hits hits = intersector_.nearest(branches.rays, branches.active, kNearest, kFarthest);
        brought.set(branches.active - Mask::of(hits.are), Radiances(scene_.background));
        for (unsigned rest = hits.are; rest != 0;) {
            const std::uint32_t material = hits.material[std::countr_zero(rest)];
            unsigned lanes = 0;
            each_lane(rest, [&](int i) { lanes |= unsigned{hits.material[i] == material} << i; });
            rest &= ~lanes;
            outgoing(branches, hits, Mask::of(lanes), scene_.materials[material], brought);
        }
    }

    // ---- One by one ---------------------------------------------------------------------------------------------

    Branch branch_of(const Branches& branches, const SpreadRays& rays, int i) const {
        alignas(32) float weights[kLanes];
        branches.weight.store(weights);
        Branch branch;
        branch.ray = rays[i];
        branch.level = branches.level;
        branch.weight = weights[i];
        branch.straight = branches.straight;
        branch.inside = branches.inside;
        return branch;
    }
    void trace_single(const Branches& branches, Brought& brought) {
        const SpreadRays rays(branches.rays);
        each_lane(branches.active.bits(), [&](int i) {
            world_.pruned = pruned_[i];  // goes on from there: sums depend on their order
            brought.set(i, rays::trace(world_, branch_of(branches, rays, i)));
            pruned_[i] = world_.pruned;
        });
    }

    // ---- Together -----------------------------------------------------------------------------------------------

    /// Of hits on the same material: task 3.11.
    void outgoing(const Branches& branches, const Hits& hits, Mask lanes, const Material& material,
                  Brought& brought) {
        const Surfaces at = surfaces_at(scene_, hits, lanes, material, -branches.rays.direction);
        Radiances sum = direct_light(scene_, shadows_, at, branches.inside);
        const Reflection& mirror = material.finish.reflection;
        const bool mirrors = !mirror.max.is_black() || !mirror.min.is_black();
        Radiances share;
        if (mirrors) share = reflectivity(branches, hits, at);
        Mask mirrored_lanes = mirrors ? lanes & is_not_black(share) : Mask::of(0);
        if (lets_light_through(material.pigment)) {
            const Transmitted through = transmitted(branches, hits, at, share);
            sum = select(through.are, sum + through.radiance, sum);
            mirrored_lanes = mirrored_lanes - through.total_reflection;
        }
        if (mirrored_lanes.any())
            sum = select(mirrored_lanes, sum + share * mirrored(branches, at, mirrored_lanes, share), sum);
        brought.set(lanes, sum);
    }

    /// As eight of `rays::Transmitted`.
    struct Transmitted {
        Mask are = Mask::of(0);
        Radiances radiance;
        Mask total_reflection = Mask::of(0);
    };

    /// What comes through surfaces: each medium on its own, for what is behind follows from it. Tasks 3.10 and 3.11.
    Transmitted transmitted(const Branches& from, const Hits& hits, const Surfaces& at, const Radiances& share) {
        Radiances tint = at.clear;
        const Floats one(1.0f);
        if (at.finish->conserve_energy)
            tint = tint * Radiances(min(one, one - share.r), min(one, one - share.g), min(one, one - share.b));
        const Floats grey = abs(Floats(0.297f) * tint.r + Floats(0.589f) * tint.g + Floats(0.114f) * tint.b);
        const Floats weight = from.weight * largest(tint);
        Transmitted through;
        through.are = at.are & is_greater(grey, Floats(scene_.settings.adc_bailout));
        leave_out(at.are - through.are, from.weight * max(Floats(0.0f), largest(tint)));
        Brought brought;
        for (unsigned rest = through.are.bits(); rest != 0;) {
            const Medium medium = medium_of(scene_, hits.object[std::countr_zero(rest)]);
            unsigned lanes = 0;
            each_lane(rest, [&](int i) { lanes |= unsigned{medium_of(scene_, hits.object[i]) == medium} << i; });
            rest &= ~lanes;
            Inside beyond = from.inside;
            const Real relative_ior = cross_border(scene_, beyond, medium);
            const Bent bent = refracted(from.rays.direction, at.normal, relative_ior);
            const Mask total = Mask::of(lanes) - bent.are, passes = Mask::of(lanes) & bent.are;
            follow({Rays(at.point, bent.direction), passes, next_level(from), weight, beyond, bent.straight}, brought);
            if (total.any())
                follow({Rays(at.point, reflected(from.rays.direction, at.normal)), total, next_level(from), weight,
                        from.inside},
                       brought);
            through.total_reflection = through.total_reflection | total;
            absorb(from, hits, lanes, medium, brought);
        }
        const Radiances all = brought.load();
        through.radiance = select(through.total_reflection, all, tint * all);
        return through;
    }

    /// Directions behind a surface: task 3.2.
    struct Bent {
        Mask are;
        Vec3s direction;
        bool straight;
    };
    static Bent refracted(const Vec3s& d, const Vec3s& n, Real relative_ior) {
        if (std::abs(relative_ior - 1) < Real(1e-10)) return {Mask::of(kAllLanes), d, true};
        const Real eta = 1 / relative_ior;
        const Reals cos_incident = -dot(d, n);
        const Reals cos2 = Reals((1 - eta) * (1 + eta)) + Reals(eta * eta) * cos_incident * cos_incident;
        const Vec3s direction = normalize(Reals(eta) * d + (Reals(eta) * cos_incident - sqrt(cos2)) * n);
        return {cos2 >= Reals(0), direction, false};
    }
    static Vec3s reflected(const Vec3s& d, const Vec3s& n) { return normalize(d - (Reals(2) * dot(d, n)) * n); }

    static int next_level(const Branches& from) { return from.level + (from.straight ? 0 : 1); }

    /// Traces what pruning leaves of the branches.
    void follow(Branches branches, Brought& brought) {
        prune(branches);
        if (branches.active.any()) trace(branches, brought);
    }

    /// What the way through the medium that was left or crossed takes: task 3.6.
    void absorb(const Branches& from, const Hits& hits, unsigned lanes, Medium medium, Brought& brought) const {
        const Interior* interior = interior_of(scene_, medium);
        if (!interior || !(interior->fade_distance > 0) || !from.inside.contains(medium)) return;
        each_lane(lanes, [&](int i) {
            const Radiance left = absorption(*interior, hits.t[i]);
            for (int c = 0; c < 3; ++c) brought.lanes[c][i] *= left[c];
        });
    }

    /// How much a finish mirrors: task 3.4.
    Radiances reflectivity(const Branches& branches, const Hits& hits, const Surfaces& at) const {
        const Reflection& r = at.finish->reflection;
        const Reals cosine = dot(at.normal, at.to_viewer), zero(0), one(1);
        const Reals c = select(cosine < zero, zero, select(cosine > one, one, cosine));
        Reals f = one - c;
        if (r.fresnel) {
            Spread shares(zero), cosines(c);
            each_lane(at.are.bits(), [&](int i) {
                const Real ior = fresnel_ior(scene_, branches.inside, medium_of(scene_, hits.object[i]));
                shares.lane[i] = fresnel(cosines[i], ior);
            });
            f = Reals::load(shares.lane);
        } else if (r.falloff != 1) {
            const Mask positive = f > zero;
            f = select(positive, power(positive, f, r.falloff), Reals(std::pow(Real(0), Real(r.falloff))));
        }
        Radiances share = Floats(f) * Radiances(r.max) + Floats(one - f) * Radiances(r.min);
        if (r.metallic != 0) share = share * metal_tint(at, c, r.metallic);
        return share;
    }

    static Radiances metal_tint(const Surfaces& at, Reals c, float metallic) {
        const Spread cosines(c);
        alignas(32) float tints[kLanes] = {};
        each_lane(at.are.bits(), [&](int i) {
            const Real x = std::acos(cosines[i]) / (kPi / 2) - Real(1.12);
            const Real grazing = std::clamp(Real(0.014567225) / (x * x) - Real(0.011612903), Real(0), Real(1));
            tints[i] = metallic * static_cast<float>(1 - grazing);
        });
        const Radiances white(Floats(1.0f), Floats(1.0f), Floats(1.0f));
        return white + Floats::load(tints) * (at.color - white);
    }

    /// What the mirror directions bring: tasks 3.1, 3.8 and 3.9.
    Radiances mirrored(const Branches& from, const Surfaces& at, Mask lanes, const Radiances& share) {
        const Reflection& mirror = at.finish->reflection;
        const Floats most = mirror.fresnel ? largest(share)
                                           : Floats(std::max(mirror.max.largest(), mirror.min.largest()));
        Brought brought;
        follow({Rays(at.point, reflected(from.rays.direction, at.normal)), lanes, next_level(from), from.weight * most,
                from.inside},
               brought);
        if (mirror.exponent != 1)
            for (auto& lane : brought.lanes)
                for (float& v : lane) v = std::pow(v, mirror.exponent);
        return brought.load();
    }

    /// Takes away the branches that are too deep or bring too little: task 3.8.
    void prune(Branches& branches) {
        const GlobalSettings& settings = scene_.settings;
        const Mask light = is_less(branches.weight, Floats(settings.adc_bailout));
        const Mask pruned = branches.active & (branches.level >= settings.max_trace_level ? branches.active : light);
        leave_out(pruned, branches.weight);
        branches.active = branches.active - pruned;
    }
    void leave_out(Mask lanes, Floats weights) {
        const unsigned bits = lanes.bits();
        if (bits == 0) return;
        alignas(32) float weight[kLanes];
        weights.store(weight);
        each_lane(bits, [&](int i) { pruned_[i] += weight[i]; });
    }

    const Scene& scene_;
    const PacketIntersector& intersector_;
    World& world_;
    Shadows shadows_;
    double* pruned_ = nullptr;  ///< of the packet in hand
};

class ScenePackets final : public Packets {
public:
    explicit ScenePackets(const Scene& scene) : intersector_(scene) {}
    const Intersector& intersector() const override { return intersector_.single(); }
    std::unique_ptr<PacketTracer> tracer(World& world) const override {
        return std::make_unique<Tracer>(intersector_, world);
    }

private:
    PacketIntersector intersector_;
};

}  // namespace
}  // namespace packets

std::unique_ptr<Packets> make_packets(const Scene& scene) {
    // Below 0, what weighs nothing is traced, too: that is for single rays.
    if (!(scene.settings.adc_bailout >= 0) || scene.settings.max_trace_level < 1) return nullptr;
    return std::make_unique<packets::ScenePackets>(scene);
}

}  // namespace rays
