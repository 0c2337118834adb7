// The scene: everything the file says, as plain values in flat arrays.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/camera.h"
#include "core/gamma.h"
#include "core/light.h"
#include "core/material.h"
#include "core/shapes.h"
#include "core/transform.h"

namespace rays {

enum class ShapeKind : std::uint8_t {
    sphere,
    plane,
    triangle,
    smooth_triangle,
    polygon,
    mesh,
    box,
    disc,
    cone,
    quadric,
    torus,
    bicubic_patch
};

/// What an object's `photons { }` says; step 6 shoots photons at targets.
struct ObjectPhotons {
    bool target = false;
    Real spacing = 1;  ///< multiplies the spacing of GlobalSettings; smaller is denser
    bool reflection = false;
    bool refraction = false;
    bool collect = true;  ///< stores and shows photons
    bool pass_through = false;
};

/// One visible thing: a shape, by kind and index into the scene's array of that kind, and what it wears. Unions are
/// already taken apart, and simple transforms are already worked into the shape's numbers.
struct Object {
    ShapeKind kind = ShapeKind::sphere;
    bool inverse = false;    ///< inside and outside swapped
    bool no_shadow = false;  ///< casts none
    bool hollow = false;     ///< media pass through it
    std::uint32_t shape = 0;
    std::uint32_t transform = kNone;  ///< into Scene::transforms, or the shape stands in world space already
    std::uint32_t material = 0;       ///< into Scene::materials
    std::uint32_t interior = kNone;   ///< into Scene::interiors
    std::uint32_t photons = kNone;    ///< into Scene::photons
    std::uint32_t clip = kNone;       ///< into Scene::clips: only the part inside all of the list is there
};

/// A clip is an object that cuts others: visible is what lies inside of it.
using ClipList = std::vector<Object>;

/// A number of the scene that is a function of an integration variable, tabulated at equal steps over [first, last].
/// Values in between: linear interpolation, off by less than `error` (absolute).
struct Varying {
    enum class Variable { time, wavelength_nm };
    Variable variable = Variable::time;
    std::string what;  ///< the number's path in the scene, e.g. "spheres[3].center.x"
    Real first = 0, last = 1;
    std::vector<Real> samples;
    Real error = 0;
};

struct GlobalSettings {
    Radiance ambient_light{1.0f};
    int max_trace_level = 5;
    float adc_bailout = 1.0f / 255;
    bool filtered_shadows = true;  ///< clear things tint light; false: whatever casts a shadow blocks all light
    Gamma gamma;                   ///< what the picture's numbers have to pass to be light
    bool filter_by_color =
        false;  ///< before version 3.7 a surface's opacity is 1 - filter * brightest channel - transmit
    bool photons = false;
    Real photon_spacing = 0;  ///< distance between photons on a target at distance 1; 0: photon_count says how many
    int photon_count = 0;
};

struct Scene {
    std::string name;  ///< the file's name, for messages
    Camera camera;
    Radiance background{0.0f};
    GlobalSettings settings;
    std::vector<Light> lights;

    std::vector<Object> objects;
    std::vector<Sphere> spheres;
    std::vector<Plane> planes;
    std::vector<Triangle> triangles;
    std::vector<SmoothTriangle> smooth_triangles;
    std::vector<Polygon> polygons;
    std::vector<Mesh> meshes;
    std::vector<Box> boxes;
    std::vector<Disc> discs;
    std::vector<Cone> cones;
    std::vector<Quadric> quadrics;
    std::vector<Torus> tori;
    std::vector<BicubicPatch> patches;

    std::vector<Transform> transforms;
    std::vector<Material> materials;
    std::vector<Interior> interiors;
    std::vector<ClipList> clips;
    std::vector<ObjectPhotons> photons;
    std::vector<Media> atmosphere;  ///< media outside of every object
    std::vector<Varying> varying;
    std::vector<std::string> notes;  ///< what the reader accepted without effect, with file:line:column
};

/// Does something of the object let light through: what it wears, or what one of its faces wears?
inline bool lets_light_through(const Scene& scene, const Object& object) {
    const auto clear = [&](std::uint32_t material) { return lets_light_through(scene.materials[material].pigment); };
    if (clear(object.material)) return true;
    if (object.kind != ShapeKind::mesh) return false;
    const auto& faces = scene.meshes[object.shape].faces;
    return std::any_of(faces.begin(), faces.end(), [&](const Mesh::Face& face) {
        return face.material != Mesh::kObjectMaterial && clear(face.material);
    });
}

}  // namespace rays
