// What the numbers of a scene are called, for messages and tables.
#pragma once

#include <map>
#include <string>

#include "core/scene.h"
#include "scene_reader/source.h"

namespace rays::sdl {

/// The paths ("spheres[3].center.x") of chosen numbers of visit_numbers' order. `paths`: in: the numbers asked for as
/// keys; out: their paths.
void find_paths(const Scene& scene, std::map<std::size_t, std::string>& paths);
std::string path_of(const Scene& scene, std::size_t number);

/// Overflows that no statement saw. Throws InputError with the number's path.
void require_finite(const Scene& scene, const Source& text);

}  // namespace rays::sdl
