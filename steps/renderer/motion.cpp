#include "renderer/motion.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "5_distributed/distributed.h"
#include "renderer/render.h"
#include "scene_reader/scene_numbers.h"

namespace rays {
namespace {

/// Looks up numbers by their paths. Only lists that have a wanted number are looked into: scenes may be large.
struct Finder {
    std::map<std::string, std::pair<Real*, float*>, std::less<>>& wanted;
    std::string path{};
    std::vector<std::size_t> lengths{};
    bool skipping = false;

    template <class T>
    void number(const char* name, T& x) {
        if constexpr (std::is_same_v<T, Real>)
            found(name, &x, nullptr);
        else
            found(name, nullptr, &x);
    }
    void fixed(std::int64_t) {}
    void enter(const char* name) { push(name); }
    void enter(const char* name, std::size_t i) { push(std::string(name) + '[' + std::to_string(i) + ']'); }
    void leave() {
        path.resize(lengths.back());
        lengths.pop_back();
        if (lengths.empty()) skipping = false;
    }

private:
    void push(std::string_view part) {
        lengths.push_back(path.size());
        path += part;
        path += '.';
        if (lengths.size() > 1) return;
        const auto first = wanted.lower_bound(path);
        skipping = first == wanted.end() || !first->first.starts_with(path);
    }
    void found(const char* name, Real* real, float* single) {
        if (skipping) return;
        const auto place = wanted.find(path + name);
        if (place != wanted.end()) place->second = {real, single};
    }
};

/// "spheres[12].center.x" -> "spheres", 12; "camera.up.x" -> "camera", none.
struct Part {
    std::string_view list;
    std::uint32_t index = kNone;
};
Part part_of(std::string_view path) {
    const auto bracket = path.find_first_of("[.");
    Part part{path.substr(0, bracket)};
    if (bracket != std::string_view::npos && path[bracket] == '[')
        part.index = static_cast<std::uint32_t>(std::stoul(std::string(path.substr(bracket + 1))));
    return part;
}

std::string_view list_of(ShapeKind kind) {
    switch (kind) {
        case ShapeKind::sphere: return "spheres";
        case ShapeKind::plane: return "planes";
        case ShapeKind::triangle: return "triangles";
        case ShapeKind::smooth_triangle: return "smooth_triangles";
        case ShapeKind::polygon: return "polygons";
        case ShapeKind::mesh: return "meshes";
        case ShapeKind::box: return "boxes";
        case ShapeKind::disc: return "discs";
        case ShapeKind::cone: return "cones";
        case ShapeKind::quadric: return "quadrics";
        case ShapeKind::torus: return "tori";
        case ShapeKind::bicubic_patch: return "patches";
    }
    return {};
}

class Lists {
public:
    void add(const Part& part) { items_[std::string(part.list)].push_back(part.index); }
    void finish() {
        for (auto& [list, indices] : items_) {
            std::sort(indices.begin(), indices.end());
            indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
        }
    }
    std::vector<std::uint32_t> of(std::string_view list) const {
        const auto found = items_.find(list);
        return found == items_.end() ? std::vector<std::uint32_t>() : found->second;
    }
    bool has(std::string_view list, std::uint32_t index) const {
        const auto found = items_.find(list);
        return found != items_.end() && std::binary_search(found->second.begin(), found->second.end(), index);
    }

private:
    std::map<std::string, std::vector<std::uint32_t>, std::less<>> items_;
};

}  // namespace

Motion::Motion(Scene& scene) : scene_(scene) {
    for (const Varying& varying : scene.varying)
        if (varying.variable == Varying::Variable::time) functions_.push_back(varying);
    bind();
    find_moving();
}

void Motion::bind() {
    numbers_.clear();
    std::map<std::string, std::pair<Real*, float*>, std::less<>> places;
    for (const Varying& function : functions_) places[function.what];
    Finder finder{places};
    sdl::visit_numbers(scene_, finder);
    for (const Varying& function : functions_) {
        const auto [real, single] = places[function.what];
        if (real || single) numbers_.push_back({real, single, &function});
    }
}

void Motion::find_moving() {
    Lists changed;
    for (const Varying& function : functions_) changed.add(part_of(function.what));
    changed.finish();
    const auto moves = [&](const Object& object) {
        return changed.has(list_of(object.kind), object.shape) || changed.has("transforms", object.transform);
    };
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
        const Object& object = scene_.objects[i];
        bool is_moving = moves(object) || changed.has("clips", object.clip);
        if (object.clip != kNone)
            for (const Object& clip : scene_.clips[object.clip]) is_moving = is_moving || moves(clip);
        if (is_moving) moving_.push_back(i);
    }
    transforms_ = changed.of("transforms");
    polygons_ = changed.of("polygons");
    meshes_ = changed.of("meshes");
    patches_ = changed.of("patches");
}

void Motion::set_time(Real time) {
    for (const Number& number : numbers_) {
        const Real value = value_at(*number.function, time);
        if (number.real)
            *number.real = value;
        else
            *number.single = static_cast<float>(value);
    }
    for (const std::uint32_t i : transforms_) {
        Transform& transform = scene_.transforms[i];
        transform.inverse_linear = glm::inverse(transform.linear);
        transform.inverse_offset = -(transform.inverse_linear * transform.offset);
    }
    for (const std::uint32_t i : polygons_) prepare(scene_.polygons[i]);
    for (const std::uint32_t i : meshes_) prepare(scene_.meshes[i]);
    for (const std::uint32_t i : patches_) prepare(scene_.patches[i]);
}

bool Motion::changes_mesh(std::uint32_t mesh) const { return std::binary_search(meshes_.begin(), meshes_.end(), mesh); }

std::vector<Real> Motion::knots(Real open, Real close) const {
    std::size_t steps = 1;
    // Tables have powers of two of steps: the finest one's knots are everybody's.
    for (const Varying& function : functions_) steps = std::max(steps, function.samples.size() - 1);
    std::vector<Real> times{open};
    for (std::size_t i = 0; i <= steps; ++i) {
        const Real time = Real(i) / Real(steps);
        if (time > open && time < close) times.push_back(time);
    }
    times.push_back(close);
    return times;
}

}  // namespace rays
