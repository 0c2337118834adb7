// Camera rays: from a pixel to a ray.
#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"

namespace rays {

namespace {

/// A point of the film: x and y in [-1/2, 1/2] across the picture, x to the right, y upwards, (0, 0) in its middle.
/// `offset` counts in pixels, to the right and downwards, from the pixel's centre.
Vec2 film_point(const Raster& raster, int column, int row, Vec2 offset) {
    //> 1.1 The centre of a pixel lies half a pixel from its left and upper edge. Rows count downwards, y upwards.
    const Real from_left = (column + Real(0.5) + offset.x) / raster.width;
    const Real from_top = (row + Real(0.5) + offset.y) / raster.height;
    return {from_left - Real(0.5), Real(0.5) - from_top};
    //< 1.1
}

/// All rays start at the camera and go through their point of the film.
Ray perspective_ray(const Camera& camera, Vec2 film) {
    //> 1.1 direction leads to the film's middle; right and up span the whole film, at any angle and length.
    return {camera.location, camera.direction + film.x * camera.right + film.y * camera.up};
    //< 1.1
}

/// All rays are parallel to the camera's direction and start at their point of the film, which stands at the camera.
Ray orthographic_ray(const Camera& camera, Vec2 film) {
    //> 1.2 Here the film point moves the origin.
    return {camera.location + film.x * camera.right + film.y * camera.up, camera.direction};
    //< 1.2
}

}  // namespace

Ray camera_ray(const Camera& camera, const Raster& raster, int column, int row, Vec2 offset) {
    const Vec2 film = film_point(raster, column, row, offset);
    return camera.kind == Camera::Kind::orthographic ? orthographic_ray(camera, film) : perspective_ray(camera, film);
}

}  // namespace rays
