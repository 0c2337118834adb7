#include "scene_reader/flatten.h"

#include <fmt/format.h>

#include <algorithm>

namespace rays::sdl {

namespace {

/// First `own`, then what was done to everything around it.
Placement chain(Placement own, const Placement& outer) {
    place_further(own, outer);
    return own;
}

}  // namespace

/// Memory that is reserved and never touched costs nothing; growing by doubling would hold three copies of the last
/// third. From a million elements on, all that can still be allowed is reserved at once.
template <class T>
std::uint32_t Flattener::append(std::vector<T>& list, T item) {
    in_.hold(sizeof(T));
    if (list.size() == 1'000'000) list.reserve(std::min(kMostObjects, list.size() + in_.memory_left() / sizeof(T)));
    list.push_back(std::move(item));
    return static_cast<std::uint32_t>(list.size() - 1);
}

void Flattener::add(const ObjectDraft& object, const Shared<SurfaceDraft>& default_surface) {
    Worn worn{default_surface, {}, kNone, true};
    Inherited top;
    top.worn = &worn;
    add(object, top);
}

void Flattener::add(const ObjectDraft& draft, const Inherited& inherited) {
    if (!draft.is_union()) return add_leaf(draft, inherited);
    in_.spend(1);
    const Interpreter::Nesting nesting(in_);
    Worn worn;
    Filled filled;
    Inherited mine = inherited;
    mine.placement = chain(draft.placement, inherited.placement);
    if (draft.surface) {
        worn = {draft.surface, chain(draft.surface_placement, inherited.placement), kNone, false};
        mine.worn = &worn;
    }
    if (draft.interior) {
        filled = {draft.interior, chain(draft.interior_placement, inherited.placement), kNone};
        mine.filled = &filled;
    }
    if (draft.photons) mine.photons = &*draft.photons;
    mine.no_shadow = inherited.no_shadow || draft.no_shadow;
    if (draft.hollow_said) mine.hollow = draft.hollow;
    for (const ObjectDraft& clip : draft.clips) {
        mine.clips.push_back(&clip);
        mine.clip_placements.push_back(inherited.placement);
    }
    for (const ObjectDraft& child : *std::get<UnionDraft>(draft.shape).children) add(child, mine);
}

void Flattener::add_leaf(const ObjectDraft& draft, const Inherited& inherited) {
    in_.spend(1);
    if (std::holds_alternative<NothingDraft>(draft.shape)) return;
    if (const auto* light = std::get_if<Shared<LightDraft>>(&draft.shape)) {
        return add_light(**light, chain(draft.placement, inherited.placement));
    }
    if (scene_.objects.size() >= kMostObjects) {
        in_.fail(draft.place, fmt::format("the scene has more than {} objects; use a mesh", kMostObjects));
    }
    Object object;
    object.inverse = draft.inverse;
    object.no_shadow = draft.no_shadow || inherited.no_shadow;
    object.hollow = draft.hollow_said ? draft.hollow : inherited.hollow;
    const Placement placement = chain(draft.placement, inherited.placement);
    if (placement && !is_finite(*placement))
        in_.fail(draft.place, "this object's transforms multiply beyond all numbers");
    add_shape(draft, placement, object);
    if (draft.surface) {
        Worn own{draft.surface, chain(draft.surface_placement, inherited.placement), kNone, false};
        object.material = material(own);
    } else {
        object.material = material(*inherited.worn);
    }
    if (draft.interior) {
        Filled own{draft.interior, chain(draft.interior_placement, inherited.placement), kNone};
        object.interior = interior(own);
    } else if (inherited.filled) {
        object.interior = interior(*inherited.filled);
    }
    const ObjectPhotons* photons = draft.photons ? &*draft.photons : inherited.photons;
    if (photons) {
        object.photons = append(scene_.photons, *photons);
    }
    if (!draft.clips.empty() || !inherited.clips.empty()) {
        Inherited mine = inherited;
        for (const ObjectDraft& clip : draft.clips) {
            mine.clips.push_back(&clip);
            mine.clip_placements.push_back(inherited.placement);
        }
        object.clip = clip_list(mine);
    }
    append(scene_.objects, object);
}

std::uint32_t Flattener::clip_list(const Inherited& inherited) {
    ClipList list;
    for (std::size_t i = 0; i < inherited.clips.size(); ++i) {
        const ObjectDraft& draft = *inherited.clips[i];
        Object clip;
        clip.inverse = draft.inverse;
        add_shape(draft, chain(draft.placement, inherited.clip_placements[i]), clip);
        list.push_back(clip);
    }
    in_.spend(static_cast<std::int64_t>(list.size()) * kWorkOfClip);
    in_.hold(list.size() * sizeof(Object));
    return append(scene_.clips, std::move(list));
}

std::uint32_t Flattener::transform(const Affine& map) { return append(scene_.transforms, to_transform(map)); }

namespace {

Vec3 point(const V3& p, const Placement& placement) { return Vec3(placement ? placement->point(p) : p); }

Vec3 unit_normal(const V3& n, const Placement& placement) {
    return Vec3(placement ? glm::normalize(placement->normal(n)) : n);
}

Plane placed(const PlaneDraft& draft, const Placement& placement) {
    if (!placement) return {Vec3(draft.normal), static_cast<Real>(draft.offset)};
    const V3 normal = glm::normalize(placement->normal(draft.normal));
    return {Vec3(normal), static_cast<Real>(glm::dot(normal, placement->point(draft.normal * draft.offset)))};
}

Triangle placed(const TriangleDraft& draft, const Placement& placement) {
    return {point(draft.corner[0], placement), point(draft.corner[1], placement), point(draft.corner[2], placement)};
}

SmoothTriangle placed_smooth(const TriangleDraft& draft, const Placement& placement) {
    return {placed(draft, placement), unit_normal(draft.normal[0], placement), unit_normal(draft.normal[1], placement),
            unit_normal(draft.normal[2], placement)};
}

Polygon placed(const PolygonDraft& draft, const Placement& placement) {
    Polygon polygon;
    polygon.contour_ends = draft.contour_ends;
    polygon.points.reserve(draft.points.size());
    for (const V3& p : draft.points) polygon.points.push_back(point(p, placement));
    return polygon;
}

/// Q' = M^-T Q M^-1.
Quadric placed(const QuadricDraft& draft, const Placement& placement) {
    if (!placement) return {Mat4(draft.q)};
    glm::dmat4 inverse(placement->inverse_linear);
    inverse[3] = glm::dvec4(placement->inverse_offset, 1);
    const glm::dmat4 q = glm::transpose(inverse) * draft.q * inverse;
    return {Mat4((q + glm::transpose(q)) * 0.5)};  // symmetric to the last bit
}

BicubicPatch placed(const PatchDraft& draft, const Placement& placement) {
    BicubicPatch patch;
    for (std::size_t i = 0; i < 16; ++i) patch.control[i] = point(draft.control[i], placement);
    return patch;
}

Sphere plain(const SphereDraft& d) { return {Vec3(d.center), static_cast<Real>(d.radius)}; }
Box plain(const BoxDraft& d) { return {Vec3(d.min), Vec3(d.max)}; }
Disc plain(const DiscDraft& d) {
    return {Vec3(d.center), Vec3(d.normal), static_cast<Real>(d.radius), static_cast<Real>(d.hole_radius)};
}
Cone plain(const ConeDraft& d) {
    return {Vec3(d.base), static_cast<Real>(d.base_radius), Vec3(d.cap), static_cast<Real>(d.cap_radius), d.open};
}

}  // namespace

void Flattener::add_shape(const ObjectDraft& draft, const Placement& placement, Object& object) {
    const auto put = [this, &object](ShapeKind kind, auto& list, auto item) {
        object.kind = kind;
        object.shape = append(list, std::move(item));
    };
    // A shape that may or may not take its placement into its numbers.
    const auto put_folded = [&](ShapeKind kind, auto& list, auto item) {
        if (!fold(item, placement)) object.transform = transform(*placement);
        put(kind, list, plain(item));
    };
    if (const auto* sphere = std::get_if<SphereDraft>(&draft.shape)) {
        put_folded(ShapeKind::sphere, scene_.spheres, *sphere);
    } else if (const auto* triangle = std::get_if<TriangleDraft>(&draft.shape)) {
        if (triangle->smooth) {
            put(ShapeKind::smooth_triangle, scene_.smooth_triangles, placed_smooth(*triangle, placement));
        } else {
            put(ShapeKind::triangle, scene_.triangles, placed(*triangle, placement));
        }
    } else if (const auto* plane = std::get_if<PlaneDraft>(&draft.shape)) {
        put(ShapeKind::plane, scene_.planes, placed(*plane, placement));
    } else if (const auto* polygon = std::get_if<Shared<PolygonDraft>>(&draft.shape)) {
        in_.hold((*polygon)->points.size() * sizeof(Vec3) + 64);  // 64: what the allocator adds
        in_.spend(static_cast<std::int64_t>((*polygon)->points.size() / 8));
        put(ShapeKind::polygon, scene_.polygons, placed(**polygon, placement));
    } else if (const auto* mesh = std::get_if<Shared<MeshDraft>>(&draft.shape)) {
        add_mesh(*mesh, placement, object);
    } else if (const auto* box = std::get_if<BoxDraft>(&draft.shape)) {
        put_folded(ShapeKind::box, scene_.boxes, *box);
    } else if (const auto* disc = std::get_if<DiscDraft>(&draft.shape)) {
        put_folded(ShapeKind::disc, scene_.discs, *disc);
    } else if (const auto* cone = std::get_if<ConeDraft>(&draft.shape)) {
        put_folded(ShapeKind::cone, scene_.cones, *cone);
    } else if (const auto* quadric = std::get_if<QuadricDraft>(&draft.shape)) {
        put(ShapeKind::quadric, scene_.quadrics, placed(*quadric, placement));
    } else if (const auto* torus = std::get_if<TorusDraft>(&draft.shape)) {
        if (placement) object.transform = transform(*placement);
        put(ShapeKind::torus, scene_.tori, Torus{static_cast<Real>(torus->major), static_cast<Real>(torus->minor)});
    } else if (const auto* patch = std::get_if<Shared<PatchDraft>>(&draft.shape)) {
        put(ShapeKind::bicubic_patch, scene_.patches, placed(**patch, placement));
    }
}

void Flattener::add_light(const LightDraft& draft, const Placement& placement) {
    Light light = draft.light;
    light.location = point(draft.location, placement);
    light.point_at = point(draft.point_at, placement);
    light.axis_u = Vec3(placement ? placement->vector(draft.axis_u) : draft.axis_u);
    light.axis_v = Vec3(placement ? placement->vector(draft.axis_v) : draft.axis_v);
    append(scene_.lights, light);
}

std::uint32_t Flattener::material(Worn& worn) {
    if (worn.material != kNone) return worn.material;
    const bool has_pattern = worn.surface->pigment.checker_other.has_value();
    if (has_pattern) return worn.material = material(*worn.surface, worn.placement);
    // A draft that nobody else holds will not come again: it need not be remembered.
    if (!worn.is_default && worn.surface.use_count() <= 2) return worn.material = material(*worn.surface, {});
    const auto [known, is_new] = plain_.try_emplace(worn.surface, kNone);
    if (is_new) known->second = material(*worn.surface, {});
    return worn.material = known->second;
}

std::uint32_t Flattener::material(const SurfaceDraft& surface, const Placement& placement) {
    in_.spend(kWorkOfMaterial);
    Material material;
    material.pigment.color = surface.pigment.color;
    material.pigment.checker_other = surface.pigment.checker_other;
    if (surface.pigment.checker_other) {
        const Placement whole = chain(surface.pigment.placement, placement);
        if (whole) material.pigment.transform = transform(*whole);
    }
    material.finish = surface.finish.finish;
    return append(scene_.materials, material);
}

std::uint32_t Flattener::interior(Filled& filled) {
    if (filled.index != kNone) return filled.index;
    Interior interior = filled.interior->interior;
    for (const MediaDraft& draft : filled.interior->media) interior.media.push_back(media(draft, filled.placement));
    return filled.index = append(scene_.interiors, std::move(interior));
}

Media Flattener::media(const MediaDraft& draft, const Placement& placement) {
    Media media = draft.media;
    for (const DensityDraft& from : draft.densities) {
        Media::Density density;
        density.color = from.color;
        if (const auto* grid = std::get_if<Shared<Media::GridDensity>>(&from.form)) {
            in_.hold((*grid)->values.size() * sizeof(float));
            density.form = **grid;
        } else if (std::holds_alternative<Media::SphericalDensity>(from.form)) {
            density.form = Media::SphericalDensity{};
        } else if (const auto* linear = std::get_if<Media::LinearDensity>(&from.form)) {
            density.form = *linear;
        }
        const Placement whole = chain(from.placement, placement);
        if (whole) density.transform = transform(*whole);
        media.densities.push_back(std::move(density));
    }
    return media;
}

void Flattener::add_atmosphere(const MediaDraft& draft) { scene_.atmosphere.push_back(media(draft, {})); }

void Flattener::add_mesh(const Shared<MeshDraft>& draft, const Placement& placement, Object& object) {
    object.kind = ShapeKind::mesh;
    if (placement) object.transform = transform(*placement);
    // A pattern on a face moves with the object, so two objects cannot share such faces.
    bool patterned = false;
    for (const auto& surface : draft->surfaces) patterned = patterned || surface->pigment.checker_other.has_value();
    if (!patterned) {
        const auto [known, is_new] = meshes_.try_emplace(draft, static_cast<std::uint32_t>(scene_.meshes.size()));
        object.shape = known->second;
        if (!is_new) return;
    }
    object.shape = static_cast<std::uint32_t>(scene_.meshes.size());
    spend_on_faces(draft->positions.size() + draft->normals.size(), draft->faces.size());
    Mesh mesh;
    mesh.positions.reserve(draft->positions.size());
    for (const V3& p : draft->positions) mesh.positions.emplace_back(p);
    mesh.normals.reserve(draft->normals.size());
    for (const V3& n : draft->normals) mesh.normals.emplace_back(n);
    mesh.faces = draft->faces;
    std::vector<std::uint32_t> materials;
    for (const auto& surface : draft->surfaces) materials.push_back(material(*surface, placement));
    for (Mesh::Face& face : mesh.faces) {
        if (face.material != Mesh::kObjectMaterial) face.material = materials[face.material];
    }
    scene_.meshes.push_back(std::move(mesh));
}

void Flattener::finish() {
    if (!choices_.varying) fold_meshes();
}

}  // namespace rays::sdl
