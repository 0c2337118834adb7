// Scenes that are functions of Time or Wavelength.
#pragma once

#include "scene_reader/reading.h"

namespace rays::sdl {

/// Reads the scene; when it looks at Time or Wavelength, reads it again at other values of the variable, and tabulates
/// every number that changes. `budget`: what the reading may cost.
Scene read_and_tabulate(Sources& sources, const Source& text, const ReadOptions& options, const Budget& budget = {});

}  // namespace rays::sdl
