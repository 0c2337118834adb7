// The shapes: plain numbers, no behaviour. Step 1 gives them roots and normals.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/large_pages.h"
#include "core/vec.h"

namespace rays {

/// A ball that contains something. A negative radius means "not computed": it bounds nothing and culls nothing.
struct BoundingSphere {
    Vec3 center{0};
    Real radius = -1;
};

/// |p - center| = radius, radius > 0.
struct Sphere {
    Vec3 center{0};
    Real radius = 1;
};

/// normal . p = offset, normal of unit length. The inside is where normal . p < offset.
struct Plane {
    Vec3 normal{0, 1, 0};
    Real offset = 0;
};

/// Counter-clockwise or clockwise: both sides are visible.
struct Triangle {
    Vec3 a{0}, b{0}, c{0};
};

/// A triangle with a unit normal at each corner. The normal in between is their linear interpolation, renormalised.
struct SmoothTriangle {
    Triangle triangle;
    Vec3 normal_a{0}, normal_b{0}, normal_c{0};
};

/// A plane polygon: closed contours, one after the other, each without the repetition of its first point. A point is
/// inside when it is inside an odd number of contours (even-odd rule), so holes and islands need no orientation.
struct Polygon {
    std::vector<Vec3> points;                 ///< all contours, concatenated
    std::vector<std::uint32_t> contour_ends;  ///< for each contour, one past its last point
    // Computed by step 1, prepare():
    Plane plane;
    std::array<int, 2> kept_axes{0, 1};  ///< the two axes left after dropping the dominant one of the normal
    BoundingSphere bound;
};

/// Many triangles that share corners.
struct Mesh {
    struct Face {
        std::array<std::uint32_t, 3> position{0, 0, 0};
        std::array<std::uint32_t, 3> normal{0, 0, 0};  ///< into `normals`, when `smooth`
        std::uint32_t material = kObjectMaterial;      ///< into Scene::materials
        bool smooth = false;
    };
    static constexpr std::uint32_t kObjectMaterial = 0xffffffff;  ///< the face wears its object's material

    LargeVector<Vec3> positions;
    LargeVector<Vec3> normals;  ///< unit length
    LargeVector<Face> faces;
    // Computed by step 1, prepare():
    BoundingSphere bound;
    /// +1: closed, faces counter-clockwise seen from outside in a right-handed view of the coordinates; -1: closed,
    /// clockwise; 0: open, or the faces do not agree. Only a closed mesh can have back faces.
    int outward_winding = 0;
};

/// min < max in every component. Faces: x-, x+, y-, y+, z-, z+ are 0..5.
struct Box {
    Vec3 min{0}, max{1};
};

/// A disc with a hole: hole_radius <= distance from center <= radius. normal of unit length.
struct Disc {
    Vec3 center{0};
    Vec3 normal{0, 1, 0};
    Real radius = 1;
    Real hole_radius = 0;
};

/// A cylinder (equal radii) or a frustum of a cone (radii >= 0, not both 0), with end caps unless open.
struct Cone {
    Vec3 base{0};
    Real base_radius = 1;
    Vec3 cap{0, 1, 0};
    Real cap_radius = 1;
    bool open = false;
};

/// p^T Q p = 0 with p = (x, y, z, 1) and Q symmetric. The inside is where the form is negative.
struct Quadric {
    Mat4 q{0};
};

/// Around the y axis of its own space: major radius to the middle of the tube, minor radius of the tube.
struct Torus {
    Real major = 1;
    Real minor = 0.25;
};

/// 4 x 4 Bezier control points, row by row: control[4 * i + j] belongs to u_i, v_j.
struct BicubicPatch {
    std::array<Vec3, 16> control{};
    // Computed by step 1, prepare():
    BoundingSphere bound;
};

}  // namespace rays
