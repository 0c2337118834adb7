#include "scene_reader/tabulate.h"

namespace rays::sdl {

Scene read_and_tabulate(Sources& sources, const Source& text, const ReadOptions& options) {
    FoldChoices choices;
    Budget budget;
    return read_once(sources, text, options, choices, budget).scene;
}

}  // namespace rays::sdl
