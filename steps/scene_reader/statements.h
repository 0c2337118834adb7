// The statements of the scene: each function reads one, from after its word (or from its word on, where the word says
// which it is) to its closing brace.
#pragma once

#include <optional>

#include "scene_reader/drafts.h"
#include "scene_reader/interpreter.h"

namespace rays::sdl {

class Flattener;

/// What statements read from and write to.
struct Context {
    Context(Interpreter& from, Scene& settings, Flattener& to) : in(from), scene(settings), out(to) {}

    Interpreter& in;
    Scene& scene;
    Flattener& out;
    Shared<SurfaceDraft> default_surface = std::make_shared<SurfaceDraft>();
    CameraDraft default_camera;
    bool has_camera = false;
    bool has_gamma = false;
};

/// The whole scene, to the end of its text.
void read_frame(Context& context);
/// What only the scene's grammar knows behind `#declare X =`. False when the next token begins nothing of the kind.
bool read_thing(Context& context, Value& result);
void read_default(Context& context);

// transforms.cpp
/// translate, rotate, scale, matrix or transform, when one follows.
std::optional<Affine> read_placement(Interpreter& in);
/// After the word `transform`: a name or a block.
Affine read_transform(Interpreter& in);

CameraDraft read_camera(Context& context);
Camera final_camera(const CameraDraft& draft, Interpreter& in, const Place& place);

Shared<LightDraft> read_light(Interpreter& in);

// objects.cpp
std::optional<ObjectDraft> read_object(Context& context);
/// Textures, transforms, flags, up to and with the closing brace.
void read_object_modifiers(Context& context, ObjectDraft& object);

// shapes.cpp: from after the opening brace to before the modifiers.
void read_shape(Context& context, Word word, ObjectDraft& object);
bool is_shape(Word word);
// meshes.cpp
Shared<MeshDraft> read_mesh(Context& context, const Place& place);
Shared<MeshDraft> read_mesh2(Context& context, const Place& place);

// textures.cpp, finish.cpp
Shared<SurfaceDraft> read_texture(Context& context);
PigmentDraft read_pigment(Interpreter& in, PigmentDraft start);
FinishDraft read_finish(Interpreter& in, FinishDraft start);

// interiors.cpp
Shared<InteriorDraft> read_interior(Interpreter& in, Shared<InteriorDraft> start);
MediaDraft read_media(Interpreter& in);
DensityDraft read_density(Interpreter& in);
MaterialDraft read_material(Context& context, MaterialDraft start);

void read_global_settings(Context& context);
ObjectPhotons read_object_photons(Interpreter& in, ObjectPhotons start);

}  // namespace rays::sdl
