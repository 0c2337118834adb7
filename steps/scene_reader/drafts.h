// Things of the scene as the language handles them: named, copied, moved about. The scene's flat arrays are made of
// them at the end (flatten.h). A placement is what was done to a thing so far; none: nothing was.
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "core/camera.h"
#include "core/light.h"
#include "core/material.h"
#include "core/scene.h"
#include "core/shapes.h"
#include "scene_reader/affine.h"
#include "scene_reader/value.h"

namespace rays::sdl {

/// Most things have none, or share the one of what they were copied from.
class Placement {
public:
    Placement() = default;
    Placement(const Affine& map) : map_(std::make_shared<const Affine>(map)) {}  // NOLINT: it is one

    explicit operator bool() const { return map_ != nullptr; }
    const Affine& operator*() const { return *map_; }
    const Affine* operator->() const { return map_.get(); }
    void reset() { map_.reset(); }

private:
    Shared<Affine> map_;
};

/// `placement`, and after it `more`.
inline void place_further(Placement& placement, const Affine& more) {
    placement = placement ? then(*placement, more) : more;
}
inline void place_further(Placement& placement, const Placement& more) {
    if (more) place_further(placement, *more);
}

struct PigmentDraft {
    Color color{Radiance(0, 0, 0)};
    std::optional<Color> checker_other;
    Placement placement;
};

struct FinishDraft {
    Finish finish;
    std::optional<float> ior, caustics;  ///< before version 3.1 these stood here, and not in an interior
};

struct SurfaceDraft {
    PigmentDraft pigment;
    FinishDraft finish;
};

/// Does light pass the surface nowhere?
inline bool is_opaque(const SurfaceDraft& surface) {
    const auto solid = [](const Color& color) { return color.filter == 0 && color.transmit == 0; };
    return solid(surface.pigment.color) && (!surface.pigment.checker_other || solid(*surface.pigment.checker_other));
}

struct DensityDraft {
    std::variant<std::monostate, Media::SphericalDensity, Shared<Media::GridDensity>, Media::LinearDensity> form;
    Radiance color{1.0f, 1.0f, 1.0f};
    Placement placement;
};

struct MediaDraft {
    Media media;  ///< without its densities
    std::vector<DensityDraft> densities;
};

struct InteriorDraft {
    Interior interior;  ///< without its media
    std::vector<MediaDraft> media;
};

struct MaterialDraft {
    Shared<SurfaceDraft> surface;
    Shared<InteriorDraft> interior;
};

struct CameraDraft {
    Camera::Kind kind = Camera::Kind::perspective;
    V3 location{0}, direction{0, 0, 1}, right{1.33, 0, 0}, up{0, 1, 0}, sky{0, 1, 0}, look_at{0, 0, 1};
    double angle = 90;
    double aperture = 0;
    double focal_distance = -1;  ///< negative: never said
    V3 focal_point{0, 0, 1};
    int blur_samples = 0;
    int aperture_blades = 0;
    double shutter_open = 0, shutter_close = 1;
};

/// A light keeps POV-Ray's numbers in double until it stands where it belongs.
struct LightDraft {
    Light light;
    V3 location{0}, point_at{0, 0, 1}, axis_u{0, 0, 1}, axis_v{0, 1, 0};
};

struct ObjectDraft;

struct UnionDraft {
    std::shared_ptr<const std::vector<ObjectDraft>> children;
};

/// Numbers are double here whatever Real is, where a transform may still change them.
struct SphereDraft {
    V3 center;
    double radius;
};
struct PlaneDraft {
    V3 normal;  ///< unit
    double offset;
};
struct TriangleDraft {
    V3 corner[3];
    V3 normal[3];  ///< unit, when smooth
    bool smooth = false;
};
struct PolygonDraft {
    std::vector<V3> points;
    std::vector<std::uint32_t> contour_ends;
};
struct MeshDraft {
    std::vector<V3> positions, normals;
    LargeVector<Mesh::Face> faces;  ///< material: into `surfaces`
    std::vector<Shared<SurfaceDraft>> surfaces;
};
struct BoxDraft {
    V3 min, max;
};
struct DiscDraft {
    V3 center, normal;
    double radius, hole_radius;
};
struct ConeDraft {
    V3 base, cap;
    double base_radius, cap_radius;
    bool open = false;
};
struct QuadricDraft {
    glm::dmat4 q;
};
struct TorusDraft {
    double major, minor;
};
struct PatchDraft {
    V3 control[16];
};
/// A degenerate triangle or polygon: POV-Ray warns and shows nothing.
struct NothingDraft {};

struct ObjectDraft {
    std::variant<NothingDraft, SphereDraft, PlaneDraft, TriangleDraft, Shared<PolygonDraft>, Shared<MeshDraft>,
                 BoxDraft, DiscDraft, ConeDraft, QuadricDraft, TorusDraft, Shared<PatchDraft>, UnionDraft,
                 Shared<LightDraft>>
        shape;
    Placement placement;
    Shared<SurfaceDraft> surface;
    Placement surface_placement;  ///< what was done since the surface was put on
    Shared<InteriorDraft> interior;
    Placement interior_placement;
    std::optional<ObjectPhotons> photons;
    bool inverse = false;
    bool no_shadow = false;
    bool hollow = false;
    bool hollow_said = false;
    std::vector<ObjectDraft> clips, bounds;
    Place place;

    bool is_union() const { return std::holds_alternative<UnionDraft>(shape); }
    bool is_light() const { return std::holds_alternative<Shared<LightDraft>>(shape); }
    /// Things without an inside.
    bool is_patch() const {
        return std::holds_alternative<TriangleDraft>(shape) || std::holds_alternative<Shared<PolygonDraft>>(shape) ||
               std::holds_alternative<Shared<MeshDraft>>(shape) || std::holds_alternative<Shared<PatchDraft>>(shape) ||
               std::holds_alternative<NothingDraft>(shape);
    }
    void move(const Affine& map);
};

}  // namespace rays::sdl
