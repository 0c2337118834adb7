#include "renderer/moving_intersector.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"
#include "renderer/render.h"

namespace rays {
namespace {

/// A mesh that moves. As a whole: with a structure in its own space, where its corners stand still. Else, and when
/// something cuts it, every face is asked.
class MovingMesh {
public:
    MovingMesh(const Scene& scene, std::uint32_t object, bool is_rigid, Partition partition)
        : scene_(scene), object_(object) {
        const Object& whole = scene.objects[object];
        if (!is_rigid || whole.clip != kNone) return;
        own_.meshes.push_back(scene.meshes[whole.shape]);
        own_.objects.push_back(whole);
        own_.objects.front().shape = 0;
        own_.objects.front().transform = kNone;
        own_.materials.resize(scene.materials.size());
        structure_ = make_intersector(own_, partition);
    }

    std::optional<Hit> nearest(const Ray& ray, Interval range) const {
        if (!structure_) {
            const auto root = intersect(scene_, scene_.objects[object_], ray, range);
            return root ? std::optional(complete_hit(scene_, object_, ray, *root)) : std::nullopt;
        }
        auto hit = structure_->nearest(local(ray), range);
        if (!hit) return hit;
        hit->point = ray.at(hit->t);
        hit->object = object_;
        if (const Transform* place = placed()) {
            hit->normal = glm::normalize(normal_to_world(*place, hit->normal));
            hit->shading_normal = glm::normalize(normal_to_world(*place, hit->shading_normal));
        }
        return hit;
    }
    bool occluded(const Ray& ray, Interval range) const {
        if (structure_) return structure_->occluded(local(ray), range);
        const Object& object = scene_.objects[object_];
        return !object.no_shadow && intersect(scene_, object, ray, range);
    }

private:
    const Transform* placed() const {
        const std::uint32_t transform = scene_.objects[object_].transform;
        return transform == kNone ? nullptr : &scene_.transforms[transform];
    }
    Ray local(const Ray& ray) const {
        const Transform* place = placed();
        return place ? ray_to_local(*place, ray) : ray;
    }

    const Scene& scene_;
    std::uint32_t object_;
    Scene own_;
    std::unique_ptr<Intersector> structure_;
};

/// Asks everything but meshes that move.
class AskOthers final : public Intersector {
public:
    AskOthers(const Scene& scene, std::vector<std::uint32_t> others) : scene_(scene), others_(std::move(others)) {}

private:
    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        std::optional<Root> nearest;
        std::uint32_t object = 0;
        for (const std::uint32_t i : others_)
            if (const auto root = intersect(scene_, scene_.objects[i], ray, range)) {
                range.max = root->t;
                nearest = root;
                object = i;
            }
        return nearest ? std::optional(complete_hit(scene_, object, ray, *nearest)) : std::nullopt;
    }
    bool find_occluder(const Ray& ray, Interval range) const override {
        return range.min < range.max && std::any_of(others_.begin(), others_.end(), [&](std::uint32_t i) {
                   return !scene_.objects[i].no_shadow && intersect(scene_, scene_.objects[i], ray, range);
               });
    }

    const Scene& scene_;
    std::vector<std::uint32_t> others_;
};

/// One structure over everything but meshes that move; those are asked one by one.
class MovingIntersector final : public Intersector {
public:
    std::unique_ptr<Intersector> structure;
    std::vector<std::unique_ptr<MovingMesh>> meshes;

private:
    /// A log has this intersector's answers, not those that it is made of.
    template <class Question>
    static auto ask_quietly(Question question) {
        QueryLog* const log = std::exchange(query_log, nullptr);
        auto answer = question();
        query_log = log;
        return answer;
    }
    std::optional<Hit> find_nearest(const Ray& ray, Interval range) const override {
        auto best = ask_quietly([&] { return structure->nearest(ray, range); });
        for (const auto& mesh : meshes) {
            const auto hit = ask_quietly([&] {
                return mesh->nearest(ray, Interval{range.min, best ? best->t : range.max});
            });
            if (hit) best = hit;
        }
        return best;
    }
    bool find_occluder(const Ray& ray, Interval range) const override {
        return ask_quietly([&] {
            return structure->occluded(ray, range) || std::any_of(meshes.begin(), meshes.end(), [&](const auto& mesh) {
                       return mesh->occluded(ray, range);
                   });
        });
    }
};

/// The knots and, where they are few, times between them: the product of two numbers that are linear in Time is not.
std::vector<Real> times_to_look_at(const Motion& motion, Real open, Real close) {
    constexpr std::size_t kFewest = 16;
    const std::vector<Real> knots = motion.knots(open, close);
    const std::size_t parts = (kFewest + knots.size() - 2) / (knots.size() - 1);
    std::vector<Real> times;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
        for (std::size_t part = 0; part < parts; ++part)
            times.push_back(glm::mix(knots[i], knots[i + 1], Real(part) / Real(parts)));
    times.push_back(knots.back());
    return times;
}

/// Around all places of these objects: at those times, and as much further as a quarter of the largest step between two
/// of them, for what is not linear there (an axis that is normalised, the product of a shape's and a transform's
/// number). Of a product p of two linear functions that is enough: over a time h it bends away from its chord by |p''|
/// h^2 / 8, and of two neighbouring steps, which differ by |p''| h^2, one is at least half of that.
std::vector<Bounds> swept_bounds(const Scene& scene, Motion& motion) {
    const std::size_t count = motion.moving().size();
    std::vector<Bounds> swept(count), before(count);
    std::vector<Real> largest_step(count, 0);
    bool first = true;
    for (const Real time : times_to_look_at(motion, scene.camera.shutter_open, scene.camera.shutter_close)) {
        motion.set_time(time);
        for (std::size_t i = 0; i < count; ++i) {
            const Bounds now = bounds_of(scene, {motion.moving()[i], 0});
            swept[i].add(now);
            if (!first && now.is_finite()) {
                const Vec3 step = glm::max(glm::abs(now.min - before[i].min), glm::abs(now.max - before[i].max));
                largest_step[i] = std::max(largest_step[i], std::max(step.x, std::max(step.y, step.z)));
            }
            before[i] = now;
        }
        first = false;
    }
    for (std::size_t i = 0; i < count; ++i) {
        swept[i].min -= Real(0.25) * largest_step[i];
        swept[i].max += Real(0.25) * largest_step[i];
    }
    return swept;
}

}  // namespace

std::unique_ptr<Intersector> make_moving_intersector(Scene& scene, Motion& motion, Partition partition) {
    auto intersector = std::make_unique<MovingIntersector>();
    const std::vector<Bounds> swept = swept_bounds(scene, motion);
    // While the structure is built, boxes stand for what moves: it asks whom they hit by way of the object, which
    // afterwards is again what it was. A triangle without area, which stays, stands for a mesh. What has no bounds is
    // asked by every ray anyway.
    const std::vector<std::uint32_t>& moving = motion.moving();
    std::vector<Object> originals;
    const std::size_t boxes = scene.boxes.size();
    for (std::size_t i = 0; i < moving.size(); ++i) {
        Object& object = scene.objects[moving[i]];
        originals.push_back(object);
        if (object.kind == ShapeKind::mesh) {
            intersector->meshes.push_back(
                std::make_unique<MovingMesh>(scene, moving[i], !motion.changes_mesh(object.shape), partition));
            object.kind = ShapeKind::triangle;
            object.shape = static_cast<std::uint32_t>(scene.triangles.size());
            scene.triangles.emplace_back();
        } else if (swept[i].is_finite()) {
            object.kind = ShapeKind::box;
            object.shape = static_cast<std::uint32_t>(scene.boxes.size());
            scene.boxes.push_back({swept[i].min, swept[i].max});
        } else {
            continue;
        }
        object.transform = object.clip = kNone;
    }
    // Few things are asked one by one: not their placeholders, but not the faces of moving meshes again either.
    const bool asks_all = (partition == Partition::automatic ? choose_partition(scene) : partition) == Partition::none;
    take_unfinished_task();
    if (!asks_all) intersector->structure = make_intersector(scene, partition);
    for (std::size_t i = 0; i < moving.size(); ++i) scene.objects[moving[i]] = originals[i];
    if (asks_all) {
        std::vector<std::uint32_t> others;
        for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
            const auto at = std::lower_bound(moving.begin(), moving.end(), i);
            const bool is_moving = at != moving.end() && *at == i;
            if (!is_moving || scene.objects[i].kind != ShapeKind::mesh) others.push_back(i);
        }
        intersector->structure = std::make_unique<AskOthers>(scene, std::move(others));
    }
    scene.boxes.resize(boxes);
    motion.bind();
    return intersector;
}

}  // namespace rays
