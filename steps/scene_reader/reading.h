// One reading of a scene.
#pragma once

#include "scene_reader/flatten.h"
#include "scene_reader/source.h"

namespace rays::sdl {

struct Reading {
    Scene scene;
    bool used_time = false;
    bool used_wavelength = false;
};

/// `choices` and `budget` are shared by all readings of one scene.
Reading read_once(Sources& sources, const Source& text, const ReadOptions& options, FoldChoices& choices,
                  Budget& budget);

}  // namespace rays::sdl
