// The answers of step 3: single functions of its contract, and whole rays with the media they start in.
#include <algorithm>

#include "3_recursion/recursion.h"
#include "core/query_log.h"
#include "renderer/question.h"
#include "renderer/radiance.h"

namespace rays::questions {
namespace {

constexpr int kMostBounces = 10'000'000;

int count_up_to(Words& words, int most, const char* what) {
    const Real number = words.number();
    if (!(number >= 0 && number <= most))
        throw InputError(fmt::format("{}: need 0 to {} {}", words.verb(), most, what));
    return static_cast<int>(number);
}

Radiance color(Words& words) {
    const Vec3 rgb = words.vector();
    return {static_cast<float>(rgb.x), static_cast<float>(rgb.y), static_cast<float>(rgb.z)};
}

/// "N O1 .. ON": the objects that a ray has entered, in this order.
Inside entered(const Stage& stage, Words& words) {
    Inside inside;
    for (int left = count_up_to(words, 32, "objects"); left > 0; --left) {
        const Object& object = stage.object(words);
        inside.enter(medium_of(stage.scene, static_cast<std::uint32_t>(&object - stage.scene.objects.data())));
    }
    return inside;
}

Medium medium(const Stage& stage, Words& words) {
    const Object& object = stage.object(words);
    return medium_of(stage.scene, static_cast<std::uint32_t>(&object - stage.scene.objects.data()));
}

/// A medium is told by the first object that it fills.
std::uint32_t first_object_of(const Scene& scene, Medium medium) {
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
        if (medium_of(scene, i) == medium) return i;
    return kNone;
}

std::string bounce(const Stage&, Words& words) {
    Vec3 direction = words.vector();
    const int times = count_up_to(words, kMostBounces, "bounces");
    std::vector<Vec3> mirrors(static_cast<std::size_t>(count_up_to(words, 8, "mirrors")));
    for (Vec3& normal : mirrors) normal = words.vector();
    if (mirrors.empty()) throw InputError("bounce: need a mirror");
    for (int i = 0; i < times; ++i) {
        const Vec3& normal = mirrors[static_cast<std::size_t>(i) % mirrors.size()];
        direction = reflect(direction, glm::dot(direction, normal) > 0 ? -normal : normal);
    }
    return text(direction);
}

std::string refracted(const Stage&, Words& words) {
    const Vec3 direction = words.vector(), normal = words.vector();
    const auto bent = refract(direction, normal, words.number());
    return bent ? text(*bent) : "miss";
}

std::string how_reflective(const Stage& stage, Words& words) {
    const Material& material = stage.material(words);
    Surface surface;
    surface.normal = surface.geometric_normal = words.vector();
    surface.to_viewer = words.vector();
    surface.color = pigment_at(stage.scene, material.pigment, Vec3(0)).rgb;
    surface.finish = &material.finish;
    return text(reflectivity(surface, words.number()));
}

std::string crossed(const Stage& stage, Words& words) {
    const Medium border = medium(stage, words);
    Inside inside = entered(stage, words);
    std::string answer = text(cross_border(stage.scene, inside, border));
    std::vector<std::uint32_t> newest_first;
    while (!inside.empty()) {
        newest_first.push_back(first_object_of(stage.scene, inside.last()));
        inside.leave(inside.last());
    }
    for (auto at = newest_first.rbegin(); at != newest_first.rend(); ++at) answer += fmt::format(" {}", *at);
    return answer;
}

std::string absorbed(const Stage& stage, Words& words) {
    const Object& object = stage.object(words);
    if (object.interior == kNone) throw InputError("absorption: the object has no interior");
    return text(absorption(stage.scene.interiors[object.interior], words.number()));
}

std::string light_through(const Stage& stage, Words& words) {
    Surface surface;
    surface.point = words.vector();
    const Light& light = stage.light(words);
    const Inside inside = entered(stage, words);
    const World world = make_world(stage.scene, stage.intersector);
    return text(FilteredShadows(world, inside).of(surface, illuminate(light, surface.point)));
}

std::string too_little(const Stage& stage, Words& words) {
    Branch branch;
    branch.level = count_up_to(words, 1'000'000, "levels");
    branch.weight = static_cast<float>(words.number());
    return text(is_pruned(stage.scene.settings, branch));
}

std::string with_residual(const Radiance& radiance, const World& world) {
    return fmt::format("{} {:.9g}", text(radiance), world.pruned);
}

/// A ray that is `LEVEL WEIGHT N O1 .. ON` already, followed to its hit.
struct Encounter {
    Encounter(const Stage& stage, Words& words) : world(make_world(stage.scene, stage.intersector)) {
        const Ray ray = words.ray();
        branch.ray = {ray.origin, glm::normalize(ray.direction)};
        branch.level = count_up_to(words, 1'000'000, "levels");
        branch.weight = static_cast<float>(words.number());
        branch.inside = entered(stage, words);
        hit = stage.intersector.nearest(branch.ray, {kNearest, kFarthest});
    }
    Interaction interaction() const {
        return {branch, hit->t, surface_at(world.scene, *hit, -branch.ray.direction),
                medium_of(world.scene, hit->object)};
    }

    World world;
    Branch branch;
    std::optional<Hit> hit;
};

std::string reflected(const Stage& stage, Words& words) {
    Encounter e(stage, words);
    const Radiance share = color(words);
    return e.hit ? with_residual(reflected_light(e.world, e.interaction(), share), e.world) : "miss";
}

std::string transmitted(const Stage& stage, Words& words) {
    Encounter e(stage, words);
    const Radiance tint = color(words);
    if (!e.hit) return "miss";
    const Transmitted through = transmitted_light(e.world, e.interaction(), tint);
    return with_residual(through.radiance, e.world) + " " + text(through.total_reflection);
}

std::string leaving(const Stage& stage, Words& words) {
    Encounter e(stage, words);
    return e.hit ? with_residual(outgoing(e.world, e.interaction()), e.world) : "miss";
}

std::string residual(const Stage& stage, Words& words) {
    World world = make_world(stage.scene, stage.intersector);
    const Ray ray = words.ray();
    const Radiance brought = radiance(world, ray, media_around(stage.scene, ray.origin));
    return with_residual(brought, world);
}

/// Logs what this thread asks, until it goes out of scope.
struct Listening {
    Listening() { query_log = &log; }
    ~Listening() { query_log = nullptr; }
    Listening(const Listening&) = delete;
    Listening& operator=(const Listening&) = delete;
    QueryLog log;
};

bool is_branch(const QueryLog::Query& query) { return query.kind != "shadow" && !query.pruned; }

std::string last_ray(const Stage& stage, Words& words) {
    World world = make_world(stage.scene, stage.intersector);
    const Ray ray = words.ray();
    const Listening listening;
    radiance(world, ray, media_around(stage.scene, ray.origin));
    const auto& queries = listening.log.queries;
    const auto last = std::find_if(queries.rbegin(), queries.rend(), is_branch);
    if (last == queries.rend()) return "miss";
    const auto rays = std::count_if(queries.begin(), queries.end(), is_branch);
    return fmt::format("{} {} {}", text(last->ray.origin), text(last->ray.direction), rays);
}

}  // namespace

void add_recursion(Answerers& answerers) {
    answerers.insert({
        {"reflect",
         [](const Stage&, Words& w) {
             const Vec3 d = w.vector();
             return text(reflect(d, w.vector()));
         }},
        {"bounce", bounce},
        {"refract", refracted},
        {"fresnel",
         [](const Stage&, Words& w) {
             const Real c = w.number();
             return text(fresnel(c, w.number()));
         }},
        {"schlick",
         [](const Stage&, Words& w) {
             const Real c = w.number();
             return text(schlick(c, w.number()));
         }},
        {"reflectivity", how_reflective},
        {"cross_border", crossed},
        {"fresnel_ior",
         [](const Stage& s, Words& w) {
             const Medium m = medium(s, w);
             return text(fresnel_ior(s.scene, entered(s, w), m));
         }},
        {"absorption", absorbed},
        {"visibility", light_through},
        {"pruned", too_little},
        {"reflected", reflected},
        {"transmitted", transmitted},
        {"outgoing", leaving},
        {"residual", residual},
        {"last_ray", last_ray},
    });
}

}  // namespace rays::questions
