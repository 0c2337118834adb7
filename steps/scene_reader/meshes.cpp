// mesh and mesh2. POV-Ray keeps corners and normals of meshes in single precision, and joins corners that are equal
// then; the reader does the same, so that both renderers see the same triangles.
#include <fmt/format.h>

#include <bit>
#include <unordered_map>

#include "scene_reader/statements.h"

namespace rays::sdl {

namespace {

/// Through memory: where double -> float -> double is done for three numbers side by side, GCC 12's vectoriser (-O2)
/// drops both steps and keeps all digits.
double rounded(double x) {
    volatile float single = static_cast<float>(x);
    return single;
}

V3 rounded(const V3& v) { return {rounded(v.x), rounded(v.y), rounded(v.z)}; }

/// Gives equal points one index.
class Joiner {
public:
    explicit Joiner(std::vector<V3>& points) : points_(points) {}

    std::uint32_t index(const V3& point) {
        const V3 key = rounded(point);
        const auto [found, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(points_.size()));
        if (is_new) points_.push_back(key);
        return found->second;
    }

private:
    struct Hash {
        std::size_t operator()(const V3& p) const {
            // Adding 0 makes -0 and 0, which are equal, hash alike. The lowest bits of rounded numbers are all 0.
            std::uint64_t hash = std::bit_cast<std::uint64_t>(p.x + 0.0) >> 29;
            hash = hash * 0x9e3779b97f4a7c15ull + (std::bit_cast<std::uint64_t>(p.y + 0.0) >> 29);
            hash = hash * 0x9e3779b97f4a7c15ull + (std::bit_cast<std::uint64_t>(p.z + 0.0) >> 29);
            return (hash ^ (hash >> 32)) * 0x9e3779b97f4a7c15ull >> 16;
        }
    };
    std::vector<V3>& points_;
    std::unordered_map<V3, std::uint32_t, Hash> known_;
};

bool is_degenerate(const V3& a, const V3& b, const V3& c) { return !(glm::length(glm::cross(a - b, c - b)) > 0); }

/// A normal of no length becomes the x axis, as in POV-Ray.
V3 unit_normal(Interpreter& in, const Place& place, V3 normal) {
    if (std::abs(normal.x) < 1e-10 && std::abs(normal.y) < 1e-10 && std::abs(normal.z) < 1e-10) {
        in.note(place, "a normal of no length in a mesh is taken for <1,0,0>, as POV-Ray does");
        normal = {1, 0, 0};
    }
    return rounded(glm::normalize(normal));
}

/// Three equal normals make a flat face.
bool differ(const V3& a, const V3& b, const V3& c) {
    return glm::dot(a - b, a - b) > 1e-10 || glm::dot(a - c, a - c) > 1e-10;
}

class MeshReader {
public:
    MeshReader(Context& context, const Place& place)
        : in_(context.in), place_(place), mesh_(std::make_shared<MeshDraft>()) {}

    Shared<MeshDraft> read() {
        for (;;) {
            if (in_.accept(Word::triangle_)) {
                read_face(false);
            } else if (in_.accept(Word::smooth_triangle_)) {
                read_face(true);
            } else if (in_.accept(Word::inside_vector_)) {
                in_.note(in_.peek().place, "inside_vector has no effect: a mesh is a surface");
                in_.vector();
            } else {
                break;
            }
        }
        if (mesh_->faces.empty()) in_.fail(place_, "this mesh has no triangles");
        return mesh_;
    }

private:
    void read_face(bool smooth) {
        const Place place = in_.peek().place;
        in_.expect('{', "a triangle");
        V3 corner[3], normal[3];
        for (int i = 0; i < 3; ++i) {
            if (i > 0) in_.comma();
            corner[i] = in_.vector();
            if (!smooth) continue;
            in_.comma();
            normal[i] = unit_normal(in_, place, in_.vector());
        }
        skip_uv();
        Mesh::Face face;
        if (in_.accept(Word::texture_)) face.material = read_texture_name();
        in_.expect('}', "a triangle");
        in_.face_made();
        if (mesh_->faces.size() >= kMostElements) in_.fail(place, "this mesh has too many triangles");
        if (is_degenerate(corner[0], corner[1], corner[2])) {
            return in_.note(place, "a degenerate triangle of a mesh is left out, as POV-Ray does");
        }
        for (std::size_t i = 0; i < 3; ++i) face.position[i] = positions_.index(corner[i]);
        face.smooth = smooth && differ(normal[0], normal[1], normal[2]);
        if (face.smooth) {
            for (std::size_t i = 0; i < 3; ++i) face.normal[i] = normals_.index(normal[i]);
        }
        mesh_->faces.push_back(face);
    }

    void skip_uv() {
        if (!in_.accept(Word::uv_vectors_)) return;
        for (int i = 0; i < 3; ++i) {
            if (i > 0) in_.comma();
            in_.vector2();
        }
    }

    std::uint32_t read_texture_name() {
        in_.expect('{', "a triangle's texture");
        const auto surface = in_.accept_named<SurfaceDraft>();
        if (!surface) in_.unexpected("the name of a declared texture");
        in_.expect('}', "a triangle's texture");
        for (std::size_t i = 0; i < mesh_->surfaces.size(); ++i) {
            if (mesh_->surfaces[i] == surface) return static_cast<std::uint32_t>(i);
        }
        mesh_->surfaces.push_back(surface);
        return static_cast<std::uint32_t>(mesh_->surfaces.size() - 1);
    }

    Interpreter& in_;
    Place place_;
    std::shared_ptr<MeshDraft> mesh_;
    Joiner positions_{mesh_->positions};
    Joiner normals_{mesh_->normals};
};

class Mesh2Reader {
public:
    Mesh2Reader(Context& context, const Place& place)
        : context_(context), in_(context.in), place_(place), mesh_(std::make_shared<MeshDraft>()) {}

    Shared<MeshDraft> read() {
        read_lists();
        if (mesh_->positions.empty()) in_.fail(place_, "this mesh2 has no vertex_vectors");
        if (!in_.accept(Word::face_indices_))
            in_.unexpected("face_indices (or another list in front of it) in a mesh2");
        read_faces();
        bool has_normals = false;
        for (;;) {
            if (in_.accept(Word::normal_indices_)) {
                read_normal_indices();
                has_normals = true;
            } else if (in_.accept(Word::uv_indices_)) {
                skip_list(3);
            } else if (in_.accept(Word::inside_vector_)) {
                in_.note(in_.peek().place, "inside_vector has no effect: a mesh is a surface");
                in_.vector();
            } else {
                break;
            }
        }
        if (!has_normals && !mesh_->normals.empty()) share_indices();
        for (Mesh::Face& face : mesh_->faces) {
            const auto& n = mesh_->normals;
            face.smooth = face.smooth && differ(n[face.normal[0]], n[face.normal[1]], n[face.normal[2]]);
        }
        drop_degenerate();
        if (mesh_->faces.empty()) in_.fail(place_, "this mesh2 has no triangles");
        return mesh_;
    }

private:
    void read_lists() {
        for (;;) {
            const Place place = in_.peek().place;
            if (in_.accept(Word::vertex_vectors_)) {
                read_vectors(mesh_->positions, [](const V3& v) { return rounded(v); });
            } else if (in_.accept(Word::normal_vectors_)) {
                read_vectors(mesh_->normals, [this, place](const V3& v) { return unit_normal(in_, place, v); });
            } else if (in_.accept(Word::uv_vectors_)) {
                skip_list(2);
            } else if (in_.accept(Word::texture_list_)) {
                read_textures();
            } else {
                return;
            }
        }
    }

    template <class Make>
    void read_vectors(std::vector<V3>& list, Make make) {
        in_.expect('{', "a list of vectors");
        const std::size_t size = in_.count("the number of vectors", kMostElements);
        list.clear();
        for (std::size_t i = 0; i < size; ++i) {
            in_.comma();
            list.push_back(make(in_.vector()));
            in_.hold(2 * sizeof(V3));
        }
        in_.comma();
        in_.expect('}', fmt::format("a list of {} vectors", size));
    }

    void skip_list(int components) {
        in_.expect('{', "a list of vectors");
        const std::size_t size = in_.count("the number of vectors", kMostElements);
        for (std::size_t i = 0; i < size; ++i) {
            in_.comma();
            components == 2 ? static_cast<void>(in_.vector2()) : static_cast<void>(in_.vector());
        }
        in_.comma();
        in_.expect('}', fmt::format("a list of {} vectors", size));
    }

    void read_textures() {
        in_.expect('{', "texture_list");
        const std::size_t size = in_.count("the number of textures", kMostElements);
        for (std::size_t i = 0; i < size; ++i) {
            in_.comma();
            if (!in_.accept(Word::texture_)) in_.unexpected("a texture in texture_list");
            in_.expect('{', "a texture");
            mesh_->surfaces.push_back(read_texture(context_));
            in_.expect('}', "a texture");
        }
        in_.comma();
        in_.expect('}', "texture_list");
    }

    std::array<std::uint32_t, 3> read_indices(std::size_t size, std::string_view what) {
        const Place place = in_.peek().place;
        const V3 v = in_.vector();
        std::array<std::uint32_t, 3> indices{};
        for (int i = 0; i < 3; ++i) {
            const double index = std::trunc(v[i]);
            if (!(index >= 0 && index < static_cast<double>(size))) {
                in_.fail(place, fmt::format("index {} of {} {}; count from 0", v[i], size, what));
            }
            indices[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(index);
        }
        return indices;
    }

    void read_faces() {
        in_.expect('{', "face_indices");
        const std::size_t size = in_.count("the number of faces", kMostElements);
        if (size == 0) in_.fail(place_, "this mesh2 has no triangles");
        for (std::size_t i = 0; i < size; ++i) {
            in_.comma();
            Mesh::Face face;
            face.position = read_indices(mesh_->positions.size(), "vertices");
            in_.comma();
            if (in_.number_follows()) face.material = read_texture_index();
            in_.face_made();
            mesh_->faces.push_back(face);
        }
        in_.comma();
        in_.expect('}', fmt::format("a list of {} faces", size));
    }

    std::uint32_t read_texture_index() {
        const Place place = in_.peek().place;
        const std::size_t index = in_.count("a face's texture", kMostElements);
        if (index >= mesh_->surfaces.size())
            in_.fail(place, fmt::format("texture {} of {}", index, mesh_->surfaces.size()));
        in_.comma();
        if (in_.number_follows()) in_.fail(in_.peek(), "a face with a texture for each corner is not in the subset");
        return static_cast<std::uint32_t>(index);
    }

    void read_normal_indices() {
        const Place place = in_.peek().place;
        in_.expect('{', "normal_indices");
        const std::size_t size = in_.count("the number of normal indices", kMostElements);
        if (size > mesh_->faces.size()) in_.fail(place, "more normal indices than faces");
        for (std::size_t i = 0; i < size; ++i) {
            in_.comma();
            mesh_->faces[i].normal = read_indices(mesh_->normals.size(), "normals");
            mesh_->faces[i].smooth = true;
        }
        in_.comma();
        in_.expect('}', fmt::format("a list of {} normal indices", size));
    }

    void share_indices() {
        if (mesh_->normals.size() != mesh_->positions.size()) {
            in_.fail(place_, "normal_indices are missing: there are not as many normals as vertices");
        }
        for (Mesh::Face& face : mesh_->faces) {
            face.normal = face.position;
            face.smooth = true;
        }
    }

    void drop_degenerate() {
        const auto& p = mesh_->positions;
        const std::size_t dropped = std::erase_if(mesh_->faces, [&p](const Mesh::Face& face) {
            return is_degenerate(p[face.position[0]], p[face.position[1]], p[face.position[2]]);
        });
        if (dropped) in_.note(place_, fmt::format("{} degenerate triangles of a mesh2 are left out", dropped));
    }

    Context& context_;
    Interpreter& in_;
    Place place_;
    std::shared_ptr<MeshDraft> mesh_;
};

}  // namespace

Shared<MeshDraft> read_mesh(Context& context, const Place& place) { return MeshReader(context, place).read(); }

Shared<MeshDraft> read_mesh2(Context& context, const Place& place) { return Mesh2Reader(context, place).read(); }

}  // namespace rays::sdl
