// A scene as text, ready to be asked; and an intersector that counts.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "2_phong/phong.h"
#include "renderer/brute_force.h"
#include "renderer/render.h"
#include "scene_reader/scene_reader.h"

namespace rays::tests {

inline Scene staged(const std::string& text) {
    Scene scene = read_scene_text(
        "#version 3.7; global_settings { assumed_gamma 1.0 }\n"
        "camera { location <0, 0, -10> look_at 0 }\n" +
            text,
        "test");
    prepare(scene);
    return scene;
}

/// A ball with a finish, as text.
inline std::string ball(const std::string& finish) {
    return "sphere { 0, 1 pigment { rgb <0.8, 0.4, 0.2> } finish { " + finish + " } }\n";
}

/// The point of an object's surface with this normal, coloured as its material says.
inline Surface surface_of(const Scene& scene, const Vec3& point, const Vec3& normal, const Vec3& to_viewer) {
    const Material& material = scene.materials[scene.objects[0].material];
    Surface surface;
    surface.point = point;
    surface.normal = surface.geometric_normal = normal;
    surface.to_viewer = to_viewer;
    surface.color = pigment_at(scene, material.pigment, point).rgb;
    surface.finish = &material.finish;
    return surface;
}

/// Nothing is ever in the way, and every question is counted and kept.
class OpenSky final : public Intersector {
public:
    mutable int asked = 0;
    mutable Ray last_ray;
    mutable Interval last_range;

private:
    std::optional<Hit> find_nearest(const Ray&, Interval) const override { return std::nullopt; }
    bool find_occluder(const Ray& ray, Interval range) const override {
        ++asked;
        last_ray = ray;
        last_range = range;
        return false;
    }
};

inline void expect_near(const Radiance& found, const Radiance& truth, double tolerance) {
    for (int i = 0; i < 3; ++i) {
        // NaN fails: the comparison is asked for as true.
        EXPECT_TRUE(std::abs(double(found[i]) - truth[i]) <= tolerance)
            << "lane " << i << ": " << found[i] << " is not " << truth[i];
    }
}

}  // namespace rays::tests
