// Placements worked into shapes' numbers, where the shape stays what it is.
#include "scene_reader/flatten.h"

namespace rays::sdl {

bool FoldChoices::choose(bool possible) {
    if (next == may_fold.size()) may_fold.push_back(possible);
    if (may_fold[next] && !possible) {
        may_fold[next] = false;
        changed = true;
    }
    return may_fold[next++];
}

namespace {

/// The factor of a similarity (rotations, mirrors and a uniform scale), or 0.
double similarity(const M3& linear) {
    const M3 squares = glm::transpose(linear) * linear;
    const double square = (squares[0][0] + squares[1][1] + squares[2][2]) / 3;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            // Rotations by cos and sin are orthogonal to a few units in the last place; 1e-13 allows for chains of
            // them.
            if (!(std::abs(squares[i][j] - (i == j ? square : 0)) <= 1e-13 * square)) return 0;
        }
    }
    return std::sqrt(square);
}

bool is_positive_diagonal(const M3& linear) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            if (i == j ? !(linear[i][j] > 0) : linear[i][j] != 0) return false;
        }
    }
    return true;
}

}  // namespace

bool Flattener::fold(SphereDraft& sphere, const Placement& placement) {
    if (!placement) return true;
    const double factor = similarity(placement->linear);
    if (!choices_.choose(factor > 0)) return false;
    sphere = {placement->point(sphere.center), sphere.radius * factor};
    return true;
}

bool Flattener::fold(BoxDraft& box, const Placement& placement) {
    if (!placement) return true;
    if (!choices_.choose(is_positive_diagonal(placement->linear))) return false;
    box = {placement->point(box.min), placement->point(box.max)};
    return true;
}

bool Flattener::fold(DiscDraft& disc, const Placement& placement) {
    if (!placement) return true;
    const double factor = similarity(placement->linear);
    if (!choices_.choose(factor > 0)) return false;
    disc = {placement->point(disc.center), glm::normalize(placement->normal(disc.normal)), disc.radius * factor,
            disc.hole_radius * factor};
    return true;
}

bool Flattener::fold(ConeDraft& cone, const Placement& placement) {
    if (!placement) return true;
    const double factor = similarity(placement->linear);
    if (!choices_.choose(factor > 0)) return false;
    cone = {placement->point(cone.base), placement->point(cone.cap), cone.base_radius * factor,
            cone.cap_radius * factor, cone.open};
    return true;
}

void Flattener::spend_on_faces(std::size_t vectors, std::size_t faces) {
    in_.hold(vectors * sizeof(Vec3) + faces * sizeof(Mesh::Face));
    in_.spend(static_cast<std::int64_t>(faces / 8));
}

namespace {

/// Works the object's transform into the corners of its mesh, which nobody else may use.
void fold_in(Scene& scene, Object& object) {
    if (object.transform == kNone) return;
    const Transform& map = scene.transforms[object.transform];
    Mesh& mesh = scene.meshes[object.shape];
    for (Vec3& p : mesh.positions) p = map.point_to_world(p);
    for (Vec3& n : mesh.normals) n = glm::normalize(glm::transpose(map.inverse_linear) * n);
    object.transform = kNone;
}

}  // namespace

/// Rays are not moved for a mesh that stands where it is. So who uses a mesh alone has its transform worked into the
/// corners, and so has everybody who shares a small one: each gets a copy.
void Flattener::fold_meshes() {
    std::vector<std::vector<std::uint32_t>> users(scene_.meshes.size());
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i)
        if (scene_.objects[i].kind == ShapeKind::mesh) users[scene_.objects[i].shape].push_back(i);
    std::size_t copied = 0;
    for (std::uint32_t m = 0; m < users.size(); ++m) {
        const std::size_t faces = scene_.meshes[m].faces.size();
        if (users[m].empty() || copied + faces * (users[m].size() - 1) > kMostCopiedFaces) continue;
        for (std::size_t i = 1; i < users[m].size(); ++i) {
            Mesh copy = scene_.meshes[m];
            spend_on_faces(copy.positions.size() + copy.normals.size(), faces);
            scene_.objects[users[m][i]].shape = static_cast<std::uint32_t>(scene_.meshes.size());
            scene_.meshes.push_back(std::move(copy));
            copied += faces;
        }
        for (const std::uint32_t user : users[m]) fold_in(scene_, scene_.objects[user]);
    }
}

}  // namespace rays::sdl
