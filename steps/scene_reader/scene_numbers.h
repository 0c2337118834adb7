// Every number of a scene, with its path. The one place that knows them all.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "core/scene.h"

namespace rays::sdl {

/// Calls, in one fixed order,
///   v.number(name, x)  for every number that an expression of the scene can set (x: Real& or float&),
///   v.fixed(n)         for everything that must not change while numbers do: counts, kinds, indices, switches,
///   v.enter(name) / v.enter(name, i) ... v.leave()  around the parts of a thing, for paths.
/// `S` is Scene or const Scene.
template <class S, class V>
class NumberVisit {
public:
    NumberVisit(S& scene, V& v) : v_(v) {
        part("camera", scene.camera);
        part("background", scene.background);
        part("settings", scene.settings);
        list("lights", scene.lights);
        list("objects", scene.objects);
        list("spheres", scene.spheres);
        list("planes", scene.planes);
        list("triangles", scene.triangles);
        list("smooth_triangles", scene.smooth_triangles);
        list("polygons", scene.polygons);
        list("meshes", scene.meshes);
        list("boxes", scene.boxes);
        list("discs", scene.discs);
        list("cones", scene.cones);
        list("quadrics", scene.quadrics);
        list("tori", scene.tori);
        list("patches", scene.patches);
        list("transforms", scene.transforms);
        list("materials", scene.materials);
        list("interiors", scene.interiors);
        list("clips", scene.clips);
        list("photons", scene.photons);
        list("atmosphere", scene.atmosphere);
    }

private:
    template <class T>
    using Maybe = std::conditional_t<std::is_const_v<S>, const T, T>;

    template <class T>
    void part(const char* name, T& x) {
        v_.enter(name);
        parts(x);
        v_.leave();
    }
    template <class T>
    void list(const char* name, T& items) {
        v_.fixed(static_cast<std::int64_t>(items.size()));
        for (std::size_t i = 0; i < items.size(); ++i) {
            v_.enter(name, i);
            parts(items[i]);
            v_.leave();
        }
    }
    template <class... T>
    void fixed(T... values) {
        (v_.fixed(static_cast<std::int64_t>(values)), ...);
    }
    template <class T>
    void number(const char* name, T& x) {
        v_.number(name, x);
    }

    void parts(Maybe<Vec3>& x) {
        number("x", x.x);
        number("y", x.y);
        number("z", x.z);
    }
    void parts(Maybe<Radiance>& x) {
        number("red", x.lane[0]);
        number("green", x.lane[1]);
        number("blue", x.lane[2]);
    }
    void parts(Maybe<Color>& x) {
        parts(x.rgb);
        number("filter", x.filter);
        number("transmit", x.transmit);
    }
    void parts(Maybe<Mat3>& x) {
        for (int i = 0; i < 3; ++i) part(kColumns[i], x[i]);
    }
    void parts(Maybe<Camera>& x) {
        fixed(x.kind, x.blur_samples, x.aperture_blades);
        part("location", x.location);
        part("direction", x.direction);
        part("right", x.right);
        part("up", x.up);
        number("aperture", x.aperture);
        part("focal_point", x.focal_point);
        number("shutter_open", x.shutter_open);
        number("shutter_close", x.shutter_close);
    }
    void parts(Maybe<GlobalSettings>& x) {
        fixed(x.max_trace_level, x.photons, x.photon_count, x.gamma.srgb, x.gamma.power, x.filter_by_color);
        part("ambient_light", x.ambient_light);
        number("adc_bailout", x.adc_bailout);
        number("photon_spacing", x.photon_spacing);
    }
    void parts(Maybe<Light>& x) {
        fixed(x.kind, x.parallel, x.shadowless, x.area, x.size_u, x.size_v, x.adaptive, x.jitter, x.circular, x.orient);
        part("location", x.location);
        part("color", x.color);
        part("point_at", x.point_at);
        number("radius_rad", x.radius_rad);
        number("falloff_rad", x.falloff_rad);
        number("tightness", x.tightness);
        number("fade_distance", x.fade_distance);
        number("fade_power", x.fade_power);
        part("axis_u", x.axis_u);
        part("axis_v", x.axis_v);
    }
    void parts(Maybe<Object>& x) {
        fixed(x.kind, x.inverse, x.no_shadow, x.hollow, x.shape, x.transform, x.material, x.interior, x.clip,
              x.photons);
    }
    void parts(Maybe<ClipList>& x) { list("clip", x); }
    void parts(Maybe<ObjectPhotons>& x) {
        fixed(x.target, x.reflection, x.refraction, x.collect, x.pass_through);
        number("spacing", x.spacing);
    }
    void parts(Maybe<Sphere>& x) {
        part("center", x.center);
        number("radius", x.radius);
    }
    void parts(Maybe<Plane>& x) {
        part("normal", x.normal);
        number("offset", x.offset);
    }
    void parts(Maybe<Triangle>& x) {
        part("a", x.a);
        part("b", x.b);
        part("c", x.c);
    }
    void parts(Maybe<SmoothTriangle>& x) {
        part("triangle", x.triangle);
        part("normal_a", x.normal_a);
        part("normal_b", x.normal_b);
        part("normal_c", x.normal_c);
    }
    void parts(Maybe<Polygon>& x) {
        list("points", x.points);
        for (auto end : x.contour_ends) fixed(end);
    }
    void parts(Maybe<Mesh>& x) {
        list("positions", x.positions);
        list("normals", x.normals);
        for (const Mesh::Face& f : x.faces) {
            fixed(f.position[0], f.position[1], f.position[2], f.normal[0], f.normal[1], f.normal[2], f.material,
                  f.smooth);
        }
    }
    void parts(Maybe<Box>& x) {
        part("min", x.min);
        part("max", x.max);
    }
    void parts(Maybe<Disc>& x) {
        part("center", x.center);
        part("normal", x.normal);
        number("radius", x.radius);
        number("hole_radius", x.hole_radius);
    }
    void parts(Maybe<Cone>& x) {
        fixed(x.open);
        part("base", x.base);
        number("base_radius", x.base_radius);
        part("cap", x.cap);
        number("cap_radius", x.cap_radius);
    }
    void parts(Maybe<Quadric>& x) {
        for (int i = 0; i < 4; ++i) {
            v_.enter("q", static_cast<std::size_t>(i));
            number("x", x.q[i].x);
            number("y", x.q[i].y);
            number("z", x.q[i].z);
            number("w", x.q[i].w);
            v_.leave();
        }
    }
    void parts(Maybe<Torus>& x) {
        number("major", x.major);
        number("minor", x.minor);
    }
    void parts(Maybe<BicubicPatch>& x) { list("control", x.control); }
    void parts(Maybe<Transform>& x) {
        part("linear", x.linear);
        part("offset", x.offset);
        part("inverse_linear", x.inverse_linear);
        part("inverse_offset", x.inverse_offset);
    }
    void parts(Maybe<Material>& x) {
        fixed(x.pigment.checker_other.has_value(), x.pigment.transform, x.finish.conserve_energy);
        part("pigment.color", x.pigment.color);
        if (x.pigment.checker_other) part("pigment.checker_other", *x.pigment.checker_other);
        part("finish", x.finish);
    }
    void parts(Maybe<Finish>& x) {
        part("ambient", x.ambient);
        part("emission", x.emission);
        number("diffuse", x.diffuse);
        number("phong", x.phong);
        number("phong_size", x.phong_size);
        number("specular", x.specular);
        number("roughness", x.roughness);
        number("metallic", x.metallic);
        number("brilliance", x.brilliance);
        number("glossy", x.glossy);
        fixed(x.reflection.fresnel);
        part("reflection.min", x.reflection.min);
        part("reflection.max", x.reflection.max);
        number("reflection.falloff", x.reflection.falloff);
        number("reflection.exponent", x.reflection.exponent);
        number("reflection.metallic", x.reflection.metallic);
    }
    void parts(Maybe<Interior>& x) {
        fixed(x.dispersion_samples);
        number("ior", x.ior);
        number("dispersion", x.dispersion);
        number("caustics", x.caustics);
        number("fade_distance", x.fade_distance);
        number("fade_power", x.fade_power);
        part("fade_color", x.fade_color);
        list("media", x.media);
    }
    void parts(Maybe<Media>& x) {
        fixed(x.method, x.intervals, x.samples_min, x.samples_max, x.scattering.has_value());
        part("absorption", x.absorption);
        part("emission", x.emission);
        if (x.scattering) {
            fixed(x.scattering->type);
            part("scattering.color", x.scattering->color);
            number("scattering.eccentricity", x.scattering->eccentricity);
            number("scattering.extinction", x.scattering->extinction);
        }
        list("densities", x.densities);
    }
    void parts(Maybe<Media::Density>& x) {
        fixed(x.form.index(), x.transform);
        part("color", x.color);
        if (auto* linear = std::get_if<Media::LinearDensity>(&x.form)) {
            number("constant", linear->constant);
            part("gradient", linear->gradient);
        }
    }

    static constexpr const char* kColumns[] = {"column0", "column1", "column2"};
    V& v_;
};

template <class S, class V>
void visit_numbers(S& scene, V& visitor) {
    NumberVisit<S, V>(scene, visitor);
}

}  // namespace rays::sdl
