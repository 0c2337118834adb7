// From drafts to the scene's flat arrays.
#pragma once

#include <unordered_map>
#include <vector>

#include "scene_reader/drafts.h"
#include "scene_reader/interpreter.h"

namespace rays::sdl {

/// Which placements may be worked into a shape's numbers. A scene that is read at several values of Time must make the
/// same choice each time: a scale that is uniform at one time may not be at another. So the choices are remembered, in
/// the order in which they come up, and a no is final.
struct FoldChoices {
    std::vector<bool> may_fold;
    std::size_t next = 0;
    bool changed = false;
    bool varying = false;  ///< meshes keep their placements: twelve numbers to tabulate, not thousands

    /// `possible`: the numbers of this reading would allow it.
    bool choose(bool possible);
};

class Flattener {
public:
    Flattener(Scene& scene, Interpreter& in, FoldChoices& choices) : scene_(scene), in_(in), choices_(choices) {}

    void add(const ObjectDraft& object, const Shared<SurfaceDraft>& default_surface);
    void add_atmosphere(const MediaDraft& media);
    /// Meshes that only one object uses take their placement into their corners.
    void finish();

private:
    /// What a union hands down to its children: the nearest said wins.
    struct Worn {
        Shared<SurfaceDraft> surface;
        Placement placement;
        std::uint32_t material = kNone;  ///< once it is in the scene
        bool is_default = false;
    };
    struct Filled {
        Shared<InteriorDraft> interior;
        Placement placement;
        std::uint32_t index = kNone;
    };
    struct Inherited {
        Placement placement;
        Worn* worn = nullptr;
        Filled* filled = nullptr;
        const ObjectPhotons* photons = nullptr;
        bool no_shadow = false;
        bool hollow = false;
        std::vector<const ObjectDraft*> clips;
        std::vector<Placement> clip_placements;
    };

    void add(const ObjectDraft& draft, const Inherited& inherited);
    void add_leaf(const ObjectDraft& draft, const Inherited& inherited);
    template <class T>
    std::uint32_t append(std::vector<T>& list, T item);
    void add_light(const LightDraft& draft, const Placement& placement);
    /// Kind, shape and transform of an object.
    void add_shape(const ObjectDraft& draft, const Placement& placement, Object& object);
    std::uint32_t material(Worn& worn);
    std::uint32_t material(const SurfaceDraft& surface, const Placement& placement);
    std::uint32_t interior(Filled& filled);
    Media media(const MediaDraft& draft, const Placement& placement);
    std::uint32_t clip_list(const Inherited& inherited);
    std::uint32_t transform(const Affine& map);

    // fold.cpp: true when the placement is worked in.
    bool fold(SphereDraft& sphere, const Placement& placement);
    bool fold(BoxDraft& box, const Placement& placement);
    bool fold(DiscDraft& disc, const Placement& placement);
    bool fold(ConeDraft& cone, const Placement& placement);

    void add_mesh(const Shared<MeshDraft>& mesh, const Placement& placement, Object& object);
    void spend_on_faces(std::size_t vectors, std::size_t faces);  // fold.cpp, like what follows
    void fold_meshes();

    Scene& scene_;
    Interpreter& in_;
    FoldChoices& choices_;
    /// Surfaces without a pattern look the same wherever they are: one material for all who share the draft.
    std::unordered_map<Shared<SurfaceDraft>, std::uint32_t> plain_;
    std::unordered_map<Shared<MeshDraft>, std::uint32_t> meshes_;  ///< those that objects may share
};

}  // namespace rays::sdl
