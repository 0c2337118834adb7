#include "renderer/camera_media.h"

#include <algorithm>
#include <array>

#include "1_ray_casting/ray_casting.h"
#include "4_partitioning/partitioning.h"
#include "renderer/radiance.h"

namespace rays {
namespace {

/// The corners of the film of an orthographic camera, from which all its rays start.
std::array<Vec3, 4> film_corners(const Camera& camera) {
    const Vec3 right = Real(0.5) * camera.right, up = Real(0.5) * camera.up, middle = camera.location;
    return {middle - right - up, middle + right - up, middle - right + up, middle + right + up};
}

/// True only when the film certainly lies wholly inside or wholly outside of the object: apart from its box, or on one
/// side of its plane. Rays may start a little beside the film.
bool leaves_film_whole(const Scene& scene, std::uint32_t index, const std::array<Vec3, 4>& corners) {
    const Object& object = scene.objects[index];
    if (object.kind == ShapeKind::mesh) return true;  // has no inside
    if (object.kind == ShapeKind::plane && object.clip == kNone) {
        const bool first = inside(scene, object, corners[0]);
        return std::all_of(corners.begin(), corners.end(),
                           [&](const Vec3& corner) { return inside(scene, object, corner) == first; });
    }
    const Bounds box = bounds_of(scene, {index, 0});
    if (object.inverse || object.kind == ShapeKind::disc || !box.is_finite()) return false;
    Bounds film;
    for (const Vec3& corner : corners) film.add({corner, corner});
    const Vec3 slack = Real(1e-6) * (film.max - film.min + glm::abs(film.max)) + Real(1e-9);
    return !box.overlaps({film.min - slack, film.max + slack});
}

}  // namespace

CameraMedia::CameraMedia(const World& world)
    : scene_(world.scene),
      asked_(world.sees_through),
      one_place_(world.scene.camera.kind == Camera::Kind::perspective) {
    if (asked_ && one_place_) there_ = media_around(scene_, scene_.camera.location);
}

Inside CameraMedia::at(const Vec3& origin) const {
    return asked_ && !one_place_ ? media_around(scene_, origin) : there_;
}

std::optional<Inside> CameraMedia::everywhere() const {
    if (!asked_ || one_place_) return there_;
    const auto corners = film_corners(scene_.camera);
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i)
        if (!leaves_film_whole(scene_, i, corners)) return std::nullopt;
    return media_around(scene_, scene_.camera.location);
}

}  // namespace rays
