// Step 1, ray casting: the contract. From a pixel to a ray, from a ray to the nearest surface.
//
// Every `intersect` returns the smallest t inside the range at which the ray meets the shape, or nothing. A ray that
// only grazes may go either way, but a NaN is never returned and no number of the input makes it hang. Directions are
// not normalised and must not be: t counts in lengths of ray.direction.
#pragma once

#include <optional>
#include <span>

#include "core/hit.h"
#include "core/ray.h"
#include "core/scene.h"

namespace rays {

// ---- Task 1.1, 1.2: camera rays --------------------------------------------------------------------------------------

/// The ray through pixel (column, row), counted from the top left corner of the picture, at `offset` in pixels from the
/// pixel's centre. The direction is not normalised: its length is free.
Ray camera_ray(const Camera& camera, const Raster& raster, int column, int row, Vec2 offset = Vec2(0));

// ---- Tasks 1.3 to 1.11: roots and normals ----------------------------------------------------------------------------

std::optional<Root> intersect(const Sphere& sphere, const Ray& ray, Interval range);
std::optional<Root> intersect(const Plane& plane, const Ray& ray, Interval range);
/// Root::uv are the weights of corners b and c.
std::optional<Root> intersect(const Triangle& triangle, const Ray& ray, Interval range);
std::optional<Root> intersect(const SmoothTriangle& triangle, const Ray& ray, Interval range);
std::optional<Root> intersect(const Polygon& polygon, const Ray& ray, Interval range);
/// Root::part is the face.
std::optional<Root> intersect(const Mesh& mesh, const Ray& ray, Interval range);
/// One face of a mesh: what the mesh's nearest face is chosen from. For structures that partition meshes (step 4).
std::optional<Root> intersect(const Mesh& mesh, std::uint32_t face, const Ray& ray, Interval range);
/// Root::part is the side: x-, x+, y-, y+, z-, z+ are 0..5.
std::optional<Root> intersect(const Box& box, const Ray& ray, Interval range);
std::optional<Root> intersect(const Disc& disc, const Ray& ray, Interval range);
/// Root::part is 0 on the mantle, 1 on the base, 2 on the cap.
std::optional<Root> intersect(const Cone& cone, const Ray& ray, Interval range);
std::optional<Root> intersect(const Quadric& quadric, const Ray& ray, Interval range);
std::optional<Root> intersect(const Torus& torus, const Ray& ray, Interval range);
/// Root::uv is (u, v) of the patch.
std::optional<Root> intersect(const BicubicPatch& patch, const Ray& ray, Interval range);

/// The normal of the surface at a point of it, in the shape's own space, of any length but 0. Closed shapes point
/// outwards; flat ones as their data says (triangles: (b - a) x (c - a)).
Vec3 normal(const Sphere& sphere, const Vec3& point, const Root& root);
Vec3 normal(const Plane& plane, const Vec3& point, const Root& root);
Vec3 normal(const Triangle& triangle, const Vec3& point, const Root& root);
Vec3 normal(const SmoothTriangle& triangle, const Vec3& point, const Root& root);
Vec3 normal(const Polygon& polygon, const Vec3& point, const Root& root);
Vec3 normal(const Mesh& mesh, const Vec3& point, const Root& root);
Vec3 normal(const Box& box, const Vec3& point, const Root& root);
Vec3 normal(const Disc& disc, const Vec3& point, const Root& root);
Vec3 normal(const Cone& cone, const Vec3& point, const Root& root);
Vec3 normal(const Quadric& quadric, const Vec3& point, const Root& root);
Vec3 normal(const Torus& torus, const Vec3& point, const Root& root);
Vec3 normal(const BicubicPatch& patch, const Vec3& point, const Root& root);

/// The interpolated normal of a smooth triangle or a smooth mesh face, of any length but 0.
Vec3 shading_normal(const SmoothTriangle& triangle, const Root& root);
Vec3 shading_normal(const Mesh& mesh, const Root& root);

// ---- Task 1.12: transformed objects ----------------------------------------------------------------------------------

/// The ray in the object's own space. t is unchanged: the direction is transformed, never normalised.
Ray ray_to_local(const Transform& transform, const Ray& ray);
/// A normal of the object's own space in world space, of any length but 0.
Vec3 normal_to_world(const Transform& transform, const Vec3& normal);

// ---- Tasks 1.13, 1.14: reject early ----------------------------------------------------------------------------------

/// A ball that contains all points; the radius is negative when there are none.
BoundingSphere bounding_sphere(std::span<const Vec3> points);

/// True when the ray certainly meets nothing of the ball in the range. Never true for a ball of negative radius.
bool misses(const BoundingSphere& bound, const Ray& ray, Interval range);

/// True when a face with this outward normal is turned away from a ray of this direction.
bool back_facing(const Vec3& outward_normal, const Vec3& direction);

/// Fills in what a shape computes once and uses for every ray (the fields marked so in core/shapes.h).
void prepare(Polygon& polygon);
void prepare(Mesh& mesh);
void prepare(BicubicPatch& patch);

// ---- Task 1.15: the nearest ------------------------------------------------------------------------------------------

/// Is the point inside the object (as POV-Ray says: flat things have no inside)? Used by clipped_by.
bool inside(const Scene& scene, const Object& object, const Vec3& point);

/// The smallest root of one object of the scene in the range: transform and clips obeyed. Roots that a clip cuts away
/// are passed over.
std::optional<Root> intersect(const Scene& scene, const Object& object, const Ray& ray, Interval range);

/// The same for one part of it: a face of a mesh; other shapes have one part, 0.
std::optional<Root> intersect_part(const Scene& scene, const Object& object, std::uint32_t part, const Ray& ray,
                                   Interval range);

/// The nearest hit among all objects, complete with point, normals and material.
std::optional<Hit> nearest_hit(const Scene& scene, const Ray& ray, Interval range);

/// The hit that a root of an object is: point, normals, material. For intersectors that found the root themselves.
Hit complete_hit(const Scene& scene, std::uint32_t object, const Ray& ray, const Root& root);

}  // namespace rays
