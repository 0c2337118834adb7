#include "renderer/needs.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace rays {
namespace {

template <class Predicate>
bool any_finish(const Scene& scene, Predicate predicate) {
    return std::any_of(scene.materials.begin(), scene.materials.end(),
                       [&](const Material& m) { return predicate(m.finish); });
}

template <class Change>
void each_finish(Scene& scene, Change change) {
    for (Material& material : scene.materials) change(material.finish);
}

template <class Predicate>
bool any_light(const Scene& scene, Predicate predicate) {
    return std::any_of(scene.lights.begin(), scene.lights.end(), predicate);
}

template <class Change>
void each_color(Scene& scene, Change change) {
    for (Material& material : scene.materials) {
        change(material.pigment.color);
        if (material.pigment.checker_other) change(*material.pigment.checker_other);
    }
}

bool varies_with(const Scene& scene, Varying::Variable variable) {
    return std::any_of(scene.varying.begin(), scene.varying.end(),
                       [&](const Varying& v) { return v.variable == variable; });
}

void hold_still(Scene& scene, Varying::Variable variable) {
    std::erase_if(scene.varying, [&](const Varying& v) { return v.variable == variable; });
}

bool reflects(const Finish& f) { return !f.reflection.max.is_black() || !f.reflection.min.is_black(); }
bool is_clear(const Material& m) { return lets_light_through(m.pigment); }
bool mirrors_by_index(const Material& m) { return reflects(m.finish) && m.finish.reflection.fresnel; }
bool is_white(const Radiance& c) { return c[0] == 1 && c[1] == 1 && c[2] == 1; }
bool absorbs(const Interior& i) { return i.fade_distance > 0 && !is_white(i.fade_color); }

template <class Predicate>
bool any_material(const Scene& scene, Predicate predicate) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), predicate);
}
template <class Predicate>
bool any_interior(const Scene& scene, Predicate predicate) {
    return std::any_of(scene.interiors.begin(), scene.interiors.end(), predicate);
}

bool filters_shadows(const Scene& s) {
    const bool casts = any_light(s, [](const Light& l) { return !l.shadowless; });
    return casts && s.settings.filtered_shadows &&
           std::any_of(s.objects.begin(), s.objects.end(),
                       [&](const Object& o) { return !o.no_shadow && lets_light_through(s, o); });
}

Vec3 flat_normal(const Triangle& t) { return glm::normalize(glm::cross(t.b - t.a, t.c - t.a)); }
bool interpolates(const SmoothTriangle& t) {
    const Vec3 n = flat_normal(t.triangle);
    return t.normal_a != n || t.normal_b != n || t.normal_c != n;
}
bool smooth(const Mesh& mesh) {
    return std::any_of(mesh.faces.begin(), mesh.faces.end(), [](const Mesh::Face& f) { return f.smooth; });
}

std::vector<Effect> all_effects() {
    return {
        {"clipping", 1, "objects cut by clipped_by",
         [](const Scene& s) {
             return std::any_of(s.objects.begin(), s.objects.end(), [](auto& o) { return o.clip != kNone; });
         },
         [](Scene& s) {
             for (Object& o : s.objects) o.clip = kNone;
         }},
        {"smooth_normals", 1, "interpolated normals of smooth triangles",
         [](const Scene& s) {
             return std::any_of(s.smooth_triangles.begin(), s.smooth_triangles.end(), interpolates) ||
                    std::any_of(s.meshes.begin(), s.meshes.end(), smooth);
         },
         [](Scene& s) {
             for (Mesh& mesh : s.meshes)
                 for (Mesh::Face& face : mesh.faces) face.smooth = false;
             for (SmoothTriangle& t : s.smooth_triangles)
                 t.normal_a = t.normal_b = t.normal_c = flat_normal(t.triangle);
         }},
        {"light_sources", 2, "light that comes from somewhere", [](const Scene& s) { return !s.lights.empty(); },
         [](Scene& s) { s.lights.clear(); }},
        {"ambient", 2, "light from nowhere",
         [](const Scene& s) {
             return !s.settings.ambient_light.is_black() &&
                    any_finish(s, [](auto& f) { return !f.ambient.is_black(); });
         },
         [](Scene& s) { each_finish(s, [](Finish& f) { f.ambient = Radiance(); }); }},
        {"emission", 2, "surfaces that shine",
         [](const Scene& s) { return any_finish(s, [](auto& f) { return !f.emission.is_black(); }); },
         [](Scene& s) { each_finish(s, [](Finish& f) { f.emission = Radiance(); }); }},
        {"diffuse", 2, "Lambert's term",
         [](const Scene& s) { return !s.lights.empty() && any_finish(s, [](auto& f) { return f.diffuse != 0; }); },
         [](Scene& s) { each_finish(s, [](Finish& f) { f.diffuse = 0; }); }},
        {"phong", 2, "highlights around the mirror direction",
         [](const Scene& s) { return !s.lights.empty() && any_finish(s, [](auto& f) { return f.phong != 0; }); },
         [](Scene& s) { each_finish(s, [](Finish& f) { f.phong = 0; }); }},
        {"specular", 2, "highlights around the half vector",
         [](const Scene& s) { return !s.lights.empty() && any_finish(s, [](auto& f) { return f.specular != 0; }); },
         [](Scene& s) { each_finish(s, [](Finish& f) { f.specular = 0; }); }},
        {"metallic", 2, "highlights in the colour of the surface",
         [](const Scene& s) {
             return !s.lights.empty() &&
                    any_finish(s, [](auto& f) { return f.metallic != 0 && (f.phong != 0 || f.specular != 0); });
         },
         [](Scene& s) { each_finish(s, [](Finish& f) { f.metallic = 0; }); }},
        {"checker", 2, "checkered pigments",
         [](const Scene& s) {
             return std::any_of(s.materials.begin(), s.materials.end(),
                                [](auto& m) { return m.pigment.checker_other.has_value(); });
         },
         [](Scene& s) {
             for (Material& m : s.materials) m.pigment.checker_other.reset();
         }},
        {"spotlights", 2, "spotlights and cylinders of light",
         [](const Scene& s) { return any_light(s, [](auto& l) { return l.kind != Light::Kind::point; }); },
         [](Scene& s) {
             for (Light& l : s.lights) l.kind = Light::Kind::point;
         }},
        {"parallel_lights", 2, "light from infinitely far away",
         [](const Scene& s) { return any_light(s, [](auto& l) { return l.parallel; }); },
         [](Scene& s) {
             for (Light& l : s.lights) l.parallel = false;
         }},
        {"fading", 2, "light that grows weaker with distance",
         [](const Scene& s) { return any_light(s, [](auto& l) { return l.fade_power > 0 && l.fade_distance > 0; }); },
         [](Scene& s) {
             for (Light& l : s.lights) l.fade_power = l.fade_distance = 0;
         }},
        {"shadows", 2, "shadow rays",
         [](const Scene& s) {
             return any_light(s, [](auto& l) { return !l.shadowless; }) &&
                    std::any_of(s.objects.begin(), s.objects.end(), [](auto& o) { return !o.no_shadow; });
         },
         [](Scene& s) {
             for (Light& l : s.lights) l.shadowless = true;
         }},
        {"reflection", 3, "mirrors", [](const Scene& s) { return any_finish(s, reflects); },
         [](Scene& s) { each_finish(s, [](Finish& f) { f.reflection = Reflection(); }); }},
        {"transparency", 3, "surfaces that let light through, bent or not",
         [](const Scene& s) { return any_material(s, [](auto& m) { return is_clear(m); }); },
         [](Scene& s) { each_color(s, [](Color& c) { c.filter = c.transmit = 0; }); }},
        {"refraction", 3, "indices of refraction: glass bends light, and mirrors by its index",
         [](const Scene& s) {
             return any_interior(s, [](auto& i) { return i.ior != 1; }) &&
                    any_material(s, [](auto& m) { return is_clear(m) || mirrors_by_index(m); });
         },
         [](Scene& s) {
             for (Interior& i : s.interiors) i.ior = 1;
         }},
        {"absorption", 3, "glass that takes light away, the more the thicker it is",
         [](const Scene& s) {
             return any_interior(s, absorbs) && any_material(s, [](auto& m) { return is_clear(m); });
         },
         [](Scene& s) {
             for (Interior& i : s.interiors) i.fade_distance = i.fade_power = 0;
         }},
        {"fresnel", 3, "mirrors by the index of refraction",
         [](const Scene& s) { return any_material(s, mirrors_by_index); },
         [](Scene& s) { each_finish(s, [](Finish& f) { f.reflection.fresnel = false; }); }},
        {"conserve_energy", 3, "what is mirrored does not come through as well",
         [](const Scene& s) {
             return any_material(s,
                                 [](auto& m) { return m.finish.conserve_energy && reflects(m.finish) && is_clear(m); });
         },
         [](Scene& s) { each_finish(s, [](Finish& f) { f.conserve_energy = false; }); }},
        {"metallic_reflection", 3, "mirrors in the colour of the surface",
         [](const Scene& s) {
             return any_finish(s, [](auto& f) { return reflects(f) && f.reflection.metallic != 0; });
         },
         [](Scene& s) { each_finish(s, [](Finish& f) { f.reflection.metallic = 0; }); }},
        {"reflection_exponent", 3, "mirrors that change contrast",
         [](const Scene& s) {
             return any_finish(s, [](auto& f) { return reflects(f) && f.reflection.exponent != 1; });
         },
         [](Scene& s) { each_finish(s, [](Finish& f) { f.reflection.exponent = 1; }); }},
        {"filtered_shadows", 3, "light that gets through clear things, tinted", filters_shadows,
         [](Scene& s) { s.settings.filtered_shadows = false; }},
        {"area_lights", 5, "soft shadows", [](const Scene& s) { return any_light(s, [](auto& l) { return l.area; }); },
         [](Scene& s) {
             for (Light& l : s.lights) l.area = false;
         }},
        {"depth_of_field", 5, "a lens of some width", [](const Scene& s) { return s.camera.aperture > 0; },
         [](Scene& s) { s.camera.aperture = 0; }},
        {"motion", 5, "numbers that change with Time",
         [](const Scene& s) { return varies_with(s, Varying::Variable::time); },
         [](Scene& s) { hold_still(s, Varying::Variable::time); }},
        {"glossy", 5, "rough mirrors and rough glass",
         [](const Scene& s) { return any_finish(s, [](auto& f) { return f.glossy > 0; }); },
         [](Scene& s) { each_finish(s, [](Finish& f) { f.glossy = 0; }); }},
        {"spectrum", 6, "numbers that change with Wavelength",
         [](const Scene& s) { return varies_with(s, Varying::Variable::wavelength_nm); },
         [](Scene& s) { hold_still(s, Varying::Variable::wavelength_nm); }},
        {"dispersion", 6, "glass that splits light",
         [](const Scene& s) {
             return std::any_of(s.interiors.begin(), s.interiors.end(), [](auto& i) { return i.dispersion != 1; });
         },
         [](Scene& s) {
             for (Interior& i : s.interiors) i.dispersion = 1;
         }},
        {"photons", 6, "caustics", [](const Scene& s) { return s.settings.photons; },
         [](Scene& s) { s.settings.photons = false; }},
        {"media", 7, "smoke, fog, fire",
         [](const Scene& s) {
             return !s.atmosphere.empty() ||
                    std::any_of(s.interiors.begin(), s.interiors.end(), [](auto& i) { return !i.media.empty(); });
         },
         [](Scene& s) {
             s.atmosphere.clear();
             for (Interior& i : s.interiors) i.media.clear();
         }},
    };
}

}  // namespace

const std::vector<Effect>& effects() {
    static const std::vector<Effect> all = all_effects();
    return all;
}

void remove_effect(Scene& scene, std::string_view name) {
    std::string names;
    for (const Effect& effect : effects()) {
        if (effect.name == name) return effect.remove(scene);
        names += fmt::format("{}{}", names.empty() ? "" : ", ", effect.name);
    }
    throw InputError(fmt::format("--without {}: no such effect; there are {}", name, names));
}

void require_built(const Scene& scene) {
    for (const Effect& effect : effects()) {
        if (effect.step > kLastBuiltStep && effect.needed(scene))
            throw InputError(
                fmt::format("{}: needs {} ({}), which belongs to step {}, not built yet; render without it: "
                            "--without {}",
                            scene.name, effect.name, effect.meaning, effect.step, effect.name));
    }
}

void drop_what_is_not_needed(Scene& scene) {
    if (!scene.varying.empty()) return;  // what is nothing now may be something later
    std::erase_if(scene.lights, [](const Light& light) { return light.color.is_black(); });
    each_finish(scene, [](Finish& f) {
        if (f.phong == 0 && f.specular == 0) f.metallic = 0;
        if (!reflects(f)) f.reflection = Reflection();
    });
    for (Material& material : scene.materials)
        if (!reflects(material.finish) || !is_clear(material)) material.finish.conserve_energy = false;
    for (Interior& interior : scene.interiors)
        if (!absorbs(interior)) interior.fade_distance = interior.fade_power = 0;
    for (Light& light : scene.lights) {
        if (light.fade_power <= 0 || light.fade_distance <= 0) light.fade_power = light.fade_distance = 0;
        const bool nothing_casts =
            std::all_of(scene.objects.begin(), scene.objects.end(), [](const Object& o) { return o.no_shadow; });
        if (nothing_casts) light.shadowless = true;
    }
}

std::string needs_to_text(const Scene& scene) {
    std::string needed = fmt::format("{} needs\n", scene.name);
    std::string left_out = "and leaves out\n";
    for (const Effect& effect : effects())
        (effect.needed(scene) ? needed : left_out) +=
            fmt::format("  step {}  {:<16} {}\n", effect.step, effect.name, effect.meaning);
    if (const double faintest = faintest_weight(scene); faintest > scene.settings.adc_bailout)
        left_out += fmt::format("  step 3  {:<16} of a weight below {:.2g}: they bring less than 2^-24\n", "branches",
                                faintest);
    return needed + left_out;
}

std::string needs_to_json(const Scene& scene) {
    std::string json;
    for (const Effect& effect : effects())
        json += fmt::format(R"({}{{"name":"{}","step":{},"needed":{}}})", json.empty() ? "" : ",", effect.name,
                            effect.step, effect.needed(scene));
    return fmt::format(R"({{"effects":[{}],"faintest_weight":{:.9g}}})", json,
                       std::max(double(scene.settings.adc_bailout), faintest_weight(scene))) +
           "\n";
}

}  // namespace rays
