// What a scene asks to be modelled, and nothing else.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/scene.h"

namespace rays {

/// One effect of the course. Its name is what --without takes.
struct Effect {
    std::string_view name;
    int step;                  ///< the step that provides it
    std::string_view meaning;  ///< one line for people
    bool (*needed)(const Scene& scene);
    void (*remove)(Scene& scene);  ///< makes a scene that does not need it; else unchanged
};

/// The last step that is built. A scene that needs a later one is refused, not rendered wrongly.
inline constexpr int kLastBuiltStep = 5;

/// All effects, in the order of the steps.
const std::vector<Effect>& effects();

/// Removes the named effect. Throws InputError, listing the names, when there is none of that name.
void remove_effect(Scene& scene, std::string_view name);

/// Throws InputError naming the effect and its step when the scene needs more than is built.
void require_built(const Scene& scene);

/// Drops what cannot change a pixel: black lights, highlights of strength 0 and the like. Never changes the picture.
void drop_what_is_not_needed(Scene& scene);

/// A lens that blurs nothing by half a pixel becomes a pinhole; an area light without a penumbra of half a pixel, a
/// point. The picture changes by less than that. Scenes that move keep both.
void drop_small_blur(Scene& scene, Raster raster);

/// The weight below which no branch of a ray tree can bring 2^-24, the finest step of a half float, to any pixel, as
/// long as it meets no more surfaces than max_trace_level; 0 where none can be told. From the brightest that lights,
/// surfaces and background can be; mirrors and glass that give more than they get make it smaller.
double faintest_weight(const Scene& scene);

/// Branches below that weight are not traced: adc_bailout becomes at least that. Scenes that move keep theirs.
void drop_faint_branches(Scene& scene);

std::string needs_to_text(const Scene& scene);
std::string needs_to_json(const Scene& scene);

}  // namespace rays
