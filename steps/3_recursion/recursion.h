// Step 3, recursion: the contract. From one ray to the tree of rays that mirrors and glass make of it.
//
// `direction` always runs with the ray, has unit length and points *into* the surface; `normal` has unit length and
// points to the side the ray comes from, so direction . normal <= 0. A relative index of refraction is that of the far
// side over that of the near side. The rules for depth, pruning and nested glass are POV-Ray's (see the handout).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "2_phong/phong.h"
#include "core/intersector.h"
#include "core/scene.h"

namespace rays {

/// No ray sees what is nearer than this to its start, in scene units (POV-Ray's MIN_ISECT_DEPTH).
inline constexpr Real kNearest = Real(1e-4);
/// Nor what is farther than this (POV-Ray's MAX_DISTANCE). A plane's horizon depends on it.
inline constexpr Real kFarthest = 1e7;

/// Nothing is traced below so many branches. max_trace_level ends trees long before, but branches that go straight on
/// are no levels: ten thousand clear sheets in a row would fill the stack.
inline constexpr int kMostAbove = 1000;

/// What fills an object: its interior's number in Scene::interiors. An object without an interior has a medium of its
/// own all the same, which nothing else shares: kOwnMedium + its number.
using Medium = std::uint32_t;
inline constexpr Medium kOwnMedium = 0x80000000;

inline Medium medium_of(const Scene& scene, std::uint32_t object) {
    const std::uint32_t interior = scene.objects[object].interior;
    return interior != kNone ? interior : kOwnMedium + object;
}
inline const Interior* interior_of(const Scene& scene, Medium medium) {
    return medium < kOwnMedium ? &scene.interiors[medium] : nullptr;
}
inline Real index_of_refraction(const Scene& scene, Medium medium) {
    return medium < kOwnMedium ? Real(scene.interiors[medium].ior) : Real(1);
}

/// The media that a ray is in, in the order in which it entered them.
class Inside {
public:
    bool empty() const { return count_ == 0; }
    std::size_t size() const { return count_; }
    /// The one entered last. Not to be asked when empty.
    Medium last() const { return media_[count_ - 1]; }
    bool contains(Medium medium) const;
    /// A ray in more than 32 media forgets the newest.
    void enter(Medium medium);
    /// False when the ray was not in it.
    bool leave(Medium medium);

    Inside() : count_(0) {}
    Inside(const Inside& other) : count_(other.count_) { copy(other); }
    Inside& operator=(const Inside& other) {
        count_ = other.count_;
        copy(other);
        return *this;
    }

private:
    // Rays are copied often and are in few media: only those are copied.
    void copy(const Inside& other) {
        for (std::uint32_t i = 0; i < count_; ++i) media_[i] = other.media_[i];
    }
    std::array<Medium, 32> media_;  // the first count_ count
    std::uint32_t count_;
};

/// One ray of the tree.
struct Branch {
    Ray ray;                      ///< direction of unit length
    const char* kind = "camera";  ///< for the query log; also "reflected", "refracted", "transmitted"
    int level = 0;                ///< rays above this one that count
    bool straight = false;        ///< passed through without bending: does not count as a level itself
    float weight = 1;             ///< the largest share of this ray's radiance that can reach the pixel
    Inside inside;
};

/// What rough surfaces do to their normals before they are lit (step 5).
class Roughness {
public:
    virtual ~Roughness() = default;
    /// `above`: how many surfaces this ray's tree met on the way here.
    virtual void tilt(Surface& surface, int above) = 0;
};

/// What rays ask, and what they leave behind. One for each thread.
struct World {
    const Scene& scene;
    const Intersector& intersector;
    std::span<const Light> lights;   ///< the scene's, or the points of them that this ray tree sees (step 5)
    Roughness* roughness = nullptr;  ///< null: all surfaces are smooth
    bool sees_through = false;       ///< something lets light through: it matters which media rays are in
    bool filtered_shadows = false;   ///< and casts shadows: they are tinted
    int above = 0;                   ///< branches above the one in hand, straight ones too
    double pruned = 0;               ///< sum of the weights of all branches that were not traced: what the pixel may
                                     ///< lack is at most this, times the brightest radiance of the scene
};

/// A world for this scene, with what it needs found out once.
World make_world(const Scene& scene, const Intersector& intersector);

// ---- Task 3.1: mirrors -----------------------------------------------------------------------------------------------

/// The mirror direction: unit length whatever rounding does, however many bounces.
Vec3 reflect(const Vec3& direction, const Vec3& normal);

// ---- Task 3.2: Snell's law -------------------------------------------------------------------------------------------

/// The direction behind the surface, or nothing under total internal reflection.
std::optional<Vec3> refract(const Vec3& direction, const Vec3& normal, Real relative_ior);

// ---- Task 3.3: Fresnel -----------------------------------------------------------------------------------------------

/// The share of unpolarised light that a smooth dielectric reflects: exact; 1 under total internal reflection.
Real fresnel(Real cos_incident, Real relative_ior);
/// Schlick's approximation of it (1994), with the refracted cosine when the far side is the thinner one. Nothing in
/// the renderer uses it: the charts show what it would cost and save.
Real schlick(Real cos_incident, Real relative_ior);

// ---- Task 3.4: how much a finish reflects ----------------------------------------------------------------------------

/// The share of each lane: between reflection.min at the normal and max at grazing, by fresnel or by
/// (1 - cos)^falloff; towards the surface's colour when metallic.
Radiance reflectivity(const Surface& surface, Real relative_ior);

// ---- Task 3.5: in and out of glass -----------------------------------------------------------------------------------

/// Takes a ray that is `inside` across the border of a medium; returns the relative index of refraction there.
/// POV-Ray's rule: the medium entered last counts. Entering: from the last medium (or vacuum) to the new one. Leaving
/// the last one: from it to the one before. Leaving another one (an overlap): nothing bends.
Real cross_border(const Scene& scene, Inside& inside, Medium medium);
/// The relative index that POV-Ray's Fresnel formula uses: as cross_border, but a ray that leaves a medium looks at
/// the last medium of its list, which is itself when others lie around it: then nothing is reflected.
Real fresnel_ior(const Scene& scene, const Inside& inside, Medium medium);

// ---- Task 3.6: absorption in glass -----------------------------------------------------------------------------------

/// What is left of light after a way through a medium (fade_distance, fade_power, fade_color): Beer's law
/// e^(-(1 - color) distance / fade_distance) for powers of 1000 and more, else
/// color + (1 - color) / (1 + (distance / fade_distance)^power).
Radiance absorption(const Interior& interior, Real distance);

// ---- Task 3.7: shadows of glass --------------------------------------------------------------------------------------

/// Opaque things block, clear ones tint: the light goes straight through all of them, multiplied by `clear` of every
/// surface it meets and by the absorption on the way. It starts in the media of the ray that hit the surface (so does
/// POV-Ray's), and enters or leaves one at each surface.
class FilteredShadows final : public Visibility {
public:
    FilteredShadows(const World& world, const Inside& inside) : world_(world), inside_(inside) {}
    Radiance of(const Surface& surface, const Illumination& light) const override;

private:
    const World& world_;
    const Inside& inside_;
};

// ---- Tasks 3.8 to 3.10: the tree -------------------------------------------------------------------------------------

/// Too deep (level reaches max_trace_level) or too small a share (weight below adc_bailout)?
bool is_pruned(const GlobalSettings& settings, const Branch& branch);

/// A hit, on the way to becoming radiance.
struct Interaction {
    const Branch& from;  ///< the ray that hit
    Real distance;       ///< its length
    Surface surface;
    Medium medium;  ///< of the object that was hit
};

/// What the mirror direction brings, times the reflectivity (of which `exponent` is applied to what it brings).
Radiance reflected_light(World& world, const Interaction& at, const Radiance& reflectivity);

/// What comes through the surface. `tint` is the share of each lane that the surface lets through.
struct Transmitted {
    Radiance radiance;
    bool total_reflection = false;  ///< then `radiance` came from the mirror direction, untinted, and is all there is
};
Transmitted transmitted_light(World& world, const Interaction& at, const Radiance& tint);

/// Everything that leaves a hit towards where its ray came from: direct light, what is transmitted, what is reflected.
Radiance outgoing(World& world, const Interaction& at);

/// The radiance that a branch brings home: black when pruned, the background when it meets nothing.
Radiance trace(World& world, const Branch& branch);

}  // namespace rays
