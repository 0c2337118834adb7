#include "renderer/answer.h"

#include <fmt/format.h>

#include <istream>
#include <memory>
#include <ostream>

#include "core/unfinished.h"
#include "renderer/question.h"
#include "renderer/radiance.h"

namespace rays {
namespace {

using questions::Answerers;
using questions::Stage;
using questions::text;
using questions::Words;

Surface lit_surface(const Stage& stage, const Material& material, const Vec3& normal, const Vec3& to_viewer) {
    Surface surface;
    surface.normal = surface.geometric_normal = normal;
    surface.to_viewer = to_viewer;
    surface.color = pigment_at(stage.scene, material.pigment, Vec3(0)).rgb;
    surface.finish = &material.finish;
    return surface;
}

std::string camera(const Stage& stage, Words& words) {
    const Raster raster{words.integer(), words.integer()};
    const int column = words.integer(), row = words.integer();
    const Real dx = words.number();
    const Ray ray = camera_ray(stage.scene.camera, raster, column, row, {dx, words.number()});
    return text(ray.origin) + " " + text(glm::normalize(ray.direction));
}

std::string nearest(const Stage& stage, Words& words) {
    const Ray ray = words.ray();
    const auto hit = stage.intersector.nearest(ray, words.interval());
    if (!hit) return "miss";
    return fmt::format("hit {} {} {} {}", text(hit->t), text(hit->normal), text(hit->shading_normal), hit->object);
}

std::string root(const Stage& stage, Words& words) {
    const Object& object = stage.object(words);
    const Ray ray = words.ray();
    const auto found = intersect(stage.scene, object, ray, words.interval());
    return found ? "hit " + text(found->t) : "miss";
}

template <class Term>
std::string shade(const Stage& stage, Words& words, Term term) {
    const Material& material = stage.material(words);
    const Vec3 normal = words.vector(), to_light = words.vector();
    const Surface surface = lit_surface(stage, material, normal, words.vector());
    return text(term(surface, Illumination{to_light, 1, Radiance(1.0f)}));
}

std::string whole_ray(const Stage& stage, Words& words) {
    World world = make_world(stage.scene, stage.intersector);
    const Ray ray = words.ray();
    return text(radiance(world, ray, media_around(stage.scene, ray.origin)));
}

const Answerers& answerers() {
    static const Answerers table = [] {
        Answerers all{
            {"camera", camera},
            {"nearest", nearest},
            {"root", root},
            {"inside",
             [](const Stage& s, Words& w) {
                 const Object& o = s.object(w);
                 return text(inside(s.scene, o, w.vector()));
             }},
            {"misses",
             [](const Stage&, Words& w) {
                 const Vec3 center = w.vector();
                 const BoundingSphere bound{center, w.number()};
                 const Ray ray = w.ray();
                 return text(misses(bound, ray, w.interval()));
             }},
            {"back_facing",
             [](const Stage&, Words& w) {
                 const Vec3 n = w.vector();
                 return text(back_facing(n, w.vector()));
             }},
            {"pigment",
             [](const Stage& s, Words& w) {
                 const Material& m = s.material(w);
                 return text(pigment_at(s.scene, m.pigment, w.vector()).rgb);
             }},
            {"facing",
             [](const Stage&, Words& w) {
                 const Vec3 n = w.vector();
                 return text(facing(n, w.vector()));
             }},
            {"illuminate",
             [](const Stage& s, Words& w) {
                 const Light& light = s.light(w);
                 const Illumination i = illuminate(light, w.vector());
                 return fmt::format("{} {} {}", text(i.to_light), text(i.distance), text(i.radiance));
             }},
            {"fading",
             [](const Stage& s, Words& w) {
                 const Light& l = s.light(w);
                 return text(fading(l, w.number()));
             }},
            {"cone_of_light",
             [](const Stage& s, Words& w) {
                 const Light& l = s.light(w);
                 return text(cone_of_light(l, w.vector()));
             }},
            {"ambient",
             [](const Stage& s, Words& w) {
                 return text(
                     ambient(lit_surface(s, s.material(w), {0, 0, -1}, {0, 0, -1}), s.scene.settings.ambient_light));
             }},
            {"diffuse", [](const Stage& s, Words& w) { return shade(s, w, diffuse); }},
            {"phong", [](const Stage& s, Words& w) { return shade(s, w, phong); }},
            {"blinn", [](const Stage& s, Words& w) { return shade(s, w, blinn); }},
            {"highlight_color", [](const Stage& s, Words& w) { return shade(s, w, highlight_color); }},
            {"in_shadow",
             [](const Stage& s, Words& w) {
                 Surface surface;
                 surface.point = w.vector();
                 surface.normal = surface.geometric_normal = surface.to_viewer = w.vector();
                 return text(in_shadow(s.intersector, surface, illuminate(s.light(w), surface.point)));
             }},
            {"occluded",
             [](const Stage& s, Words& w) {
                 const Ray ray = w.ray();
                 return text(s.intersector.occluded(ray, w.interval()));
             }},
            {"radiance", [](const Stage& s, Words& w) { return whole_ray(s, w); }},
        };
        questions::add_recursion(all);
        questions::add_partitioning(all);
        questions::add_distributed(all);
        return all;
    }();
    return table;
}

std::string answer(const Stage* stage, const std::string& line) {
    Words words(line);
    if (!stage) return "error no scene";
    const auto found = answerers().find(words.verb());
    if (found == answerers().end()) return "error unknown query " + words.verb();
    take_unfinished_task();
    const std::string result = found->second(*stage, words);
    const char* unfinished_task = take_unfinished_task();
    return unfinished_task ? fmt::format("unfinished {}", unfinished_task) : result;
}

std::string one_line(std::string message) {
    for (char& c : message)
        if (c == '\n') c = ' ';
    return message;
}

}  // namespace

void answer_questions(std::istream& in, std::ostream& out) {
    std::unique_ptr<Stage> stage;
    std::string problem;
    for (std::string line; std::getline(in, line);) {
        try {
            if (line.starts_with("scene ")) {
                std::string sdl(std::stoul(line.substr(6)), '\0');
                in.read(sdl.data(), static_cast<std::streamsize>(sdl.size()));
                stage.reset();
                problem.clear();
                stage = std::make_unique<Stage>(sdl);
                continue;
            }
            if (line.empty()) continue;
            // Each answer leaves at once: a crash costs only those that come after.
            out << (problem.empty() ? answer(stage.get(), line) : "error " + problem) << '\n' << std::flush;
        } catch (const std::exception& e) {
            if (line.starts_with("scene "))
                problem = one_line(e.what());
            else
                out << "error " << one_line(e.what()) << '\n' << std::flush;
        }
    }
}

}  // namespace rays
