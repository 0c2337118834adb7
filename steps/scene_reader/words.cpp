#include "scene_reader/words.h"

#include <array>
#include <utility>

namespace rays::sdl {

namespace {

constexpr std::string_view kSpellings[] = {
#define RAYS_SDL_TEXT(name) #name,
    RAYS_SDL_WORDS(RAYS_SDL_TEXT)
#undef RAYS_SDL_TEXT
};

constexpr std::pair<std::string_view, Word> kOtherSpellings[] = {
    {"colour", Word::color_},
    {"colour_map", Word::color_map_},
    {"fade_colour", Word::fade_color_},
    {"quick_colour", Word::quick_color_},
};

// The rest of POV-Ray 3.7's reserved words: they cannot be names, and what they ask for is not in the subset.
constexpr std::string_view kOtherWords[] = {
    "agate",
    "agate_turb",
    "all",
    "all_intersections",
    "altitude",
    "always_sample",
    "anisotropy",
    "aoi",
    "append",
    "arc_angle",
    "ascii",
    "autostop",
    "average",
    "b_spline",
    "bezier_spline",
    "black_hole",
    "blob",
    "bmp",
    "bokeh",
    "bozo",
    "brick",
    "brick_size",
    "brightness",
    "bump_map",
    "bump_size",
    "bumps",
    "cells",
    "component",
    "composite",
    "conic_sweep",
    "contained_by",
    "control0",
    "control1",
    "coords",
    "crackle",
    "cube",
    "cubic",
    "cubic_spline",
    "cubic_wave",
    "cutaway_textures",
    "cylindrical",
    "datetime",
    "dents",
    "difference",
    "dist_exp",
    "distance",
    "distance_maximum",
    "dtag",
    "error_bound",
    "evaluate",
    "expand_thresholds",
    "exr",
    "exterior",
    "facets",
    "falloff_angle",
    "fclose",
    "fisheye",
    "flip",
    "fog",
    "fog_alt",
    "fog_offset",
    "fog_type",
    "fopen",
    "form",
    "frequency",
    "gamma",
    "gif",
    "global",
    "global_lights",
    "granite",
    "gray_threshold",
    "hdr",
    "height_field",
    "hexagon",
    "hf_gray_16",
    "hypercomplex",
    "iff",
    "image_map",
    "image_pattern",
    "importance",
    "inside",
    "interior_texture",
    "intersection",
    "irid",
    "isosurface",
    "jpeg",
    "julia",
    "julia_fractal",
    "lambda",
    "lathe",
    "leopard",
    "light_group",
    "linear_sweep",
    "load_file",
    "looks_like",
    "low_error_factor",
    "magnet",
    "major_radius",
    "mandel",
    "map_type",
    "marble",
    "material_map",
    "max_extent",
    "max_gradient",
    "max_iteration",
    "max_sample",
    "max_trace",
    "maximum_reuse",
    "merge",
    "mesh_camera",
    "metric",
    "min_extent",
    "minimum_reuse",
    "mortar",
    "natural_spline",
    "nearest_count",
    "no_bump_scale",
    "normal",
    "normal_map",
    "number_of_sides",
    "number_of_tiles",
    "octaves",
    "offset",
    "omega",
    "omnimax",
    "onion",
    "orientation",
    "ovus",
    "panoramic",
    "parametric",
    "pattern",
    "pavement",
    "pgm",
    "phase",
    "pigment_map",
    "pigment_pattern",
    "planar",
    "png",
    "poly",
    "poly_wave",
    "polynomial",
    "pot",
    "ppm",
    "precision",
    "precompute",
    "premultiplied",
    "pretrace_end",
    "pretrace_start",
    "prism",
    "projected_through",
    "pwr",
    "quadratic_spline",
    "quartic",
    "quaternion",
    "quilted",
    "radial",
    "radiosity",
    "rainbow",
    "ramp_wave",
    "read",
    "reciprocal",
    "recursion_limit",
    "repeat",
    "ripples",
    "save_file",
    "sblue",
    "scallop_wave",
    "sgreen",
    "sine_wave",
    "sint16be",
    "sint16le",
    "sint32be",
    "sint32le",
    "sint8",
    "size",
    "sky_sphere",
    "slice",
    "slope",
    "slope_map",
    "smooth",
    "solid",
    "sor",
    "sphere_sweep",
    "spiral1",
    "spiral2",
    "spline",
    "spotted",
    "sqr",
    "square",
    "sred",
    "steps",
    "strength",
    "subsurface",
    "superellipsoid",
    "sys",
    "text",
    "texture_map",
    "tga",
    "thickness",
    "threshold",
    "tiff",
    "tile2",
    "tiles",
    "tiling",
    "tolerance",
    "toroidal",
    "trace",
    "translucency",
    "triangle_wave",
    "triangular",
    "ttf",
    "turb_depth",
    "turbulence",
    "uint16be",
    "uint16le",
    "uint8",
    "ultra_wide_angle",
    "use_alpha",
    "use_color",
    "use_colour",
    "use_index",
    "utf8",
    "uv_mapping",
    "vturbulence",
    "warp",
    "water_level",
    "waves",
    "width",
    "wood",
    "wrinkles",
    "write",
    "xyz",
};

}  // namespace

std::string_view to_string(Word word) {
    return word == Word::other_ ? "a word of POV-Ray" : kSpellings[static_cast<std::size_t>(word)];
}

bool is_float_function(Word word) {
    switch (word) {
        // clang-format off
        case Word::abs_: case Word::acos_: case Word::acosh_: case Word::asc_: case Word::asin_: case Word::asinh_:
        case Word::atan_: case Word::atan2_: case Word::atanh_: case Word::bitwise_and_: case Word::bitwise_or_:
        case Word::bitwise_xor_: case Word::ceil_: case Word::clock_: case Word::clock_on_: case Word::cos_:
        case Word::cosh_: case Word::defined_: case Word::degrees_: case Word::dimension_size_:
        case Word::dimensions_: case Word::div_: case Word::exp_: case Word::false_: case Word::file_exists_:
        case Word::floor_: case Word::int_: case Word::ln_: case Word::log_: case Word::max_: case Word::min_:
        case Word::mod_: case Word::no_: case Word::now_: case Word::off_: case Word::on_: case Word::pi_:
        case Word::pow_: case Word::radians_: case Word::rand_: case Word::seed_: case Word::select_: case Word::sin_:
        case Word::sinh_: case Word::sqrt_: case Word::strcmp_: case Word::strlen_: case Word::tan_:
        case Word::tanh_: case Word::true_: case Word::val_: case Word::vdot_: case Word::version_:
        case Word::vlength_: case Word::yes_: return true;
        // clang-format on
        default: return false;
    }
}

bool is_vector_word(Word word) {
    switch (word) {
        // clang-format off
        case Word::vaxis_rotate_: case Word::vcross_: case Word::vnormalize_: case Word::vrotate_: case Word::x_:
        case Word::y_: case Word::z_: case Word::t_: case Word::u_: case Word::v_: return true;
        // clang-format on
        default: return false;
    }
}

Names::Names() : slots_(4096) {
    auto reserve = [this](std::string_view text, Word word) {
        intern(text);
        reserved_.push_back(word);
    };
    for (std::size_t i = 0; i < std::size(kSpellings); ++i) reserve(kSpellings[i], static_cast<Word>(i));
    for (const auto& [text, word] : kOtherSpellings) reserve(text, word);
    for (std::string_view text : kOtherWords) reserve(text, Word::other_);
}

std::uint32_t Names::hash_of(std::string_view text) {
    std::uint32_t hash = kHashStart;
    for (char c : text) hash = hash_step(hash, c);
    return hash;
}

NameId Names::intern(std::string_view text, std::uint32_t hash) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hash & mask;
    while (slots_[i].id != 0xffffffff) {
        if (slots_[i].hash == hash && texts_[slots_[i].id] == text) return slots_[i].id;
        i = (i + 1) & mask;
    }
    const NameId id = static_cast<NameId>(texts_.size());
    slots_[i] = {hash, id};
    texts_.emplace_back(text);
    if (2 * texts_.size() > slots_.size()) grow();
    return id;
}

void Names::grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
        if (slot.id == 0xffffffff) continue;
        std::size_t i = slot.hash & (slots_.size() - 1);
        while (slots_[i].id != 0xffffffff) i = (i + 1) & (slots_.size() - 1);
        slots_[i] = slot;
    }
}

}  // namespace rays::sdl
