// The words of the language, and the numbers that names get.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace rays::sdl {

// Every word that this reader acts on. `Word::sphere_` is "sphere".
#define RAYS_SDL_WORDS(X)                                                                                             \
    X(aa_level) X(aa_threshold) X(abs) X(absorption) X(accuracy) X(acos) X(acosh) X(adaptive) X(adc_bailout)          \
    X(albedo) X(alpha) X(ambient) X(ambient_light) X(angle) X(aperture) X(area_illumination) X(area_light) X(array)   \
    X(asc) X(asin) X(asinh) X(assumed_gamma) X(atan) X(atan2) X(atanh) X(background) X(bicubic_patch)                 \
    X(bitwise_and) X(bitwise_or) X(bitwise_xor) X(blue) X(blur_samples) X(boxed) X(bounded_by) X(box) X(break)        \
    X(brilliance) X(camera) X(case) X(caustics) X(ceil) X(charset) X(checker) X(chr) X(circular) X(clipped_by)        \
    X(clock) X(clock_on) X(collect) X(color) X(color_map) X(concat) X(cone) X(confidence) X(conserve_energy) X(cos)   \
    X(cosh) X(count) X(crand) X(cylinder) X(debug) X(declare) X(default) X(defined) X(degrees) X(density)             \
    X(density_file) X(density_map) X(deprecated) X(df3) X(diffuse) X(dimension_size) X(dimensions) X(direction)       \
    X(disc) X(dispersion) X(dispersion_samples) X(div) X(double_illuminate) X(eccentricity) X(else) X(elseif)         \
    X(emission) X(end) X(error) X(exp) X(exponent) X(extinction) X(face_indices) X(fade_color) X(fade_distance)       \
    X(fade_power) X(falloff) X(false) X(file_exists) X(filter) X(finish) X(flatness) X(floor) X(focal_point) X(for)   \
    X(fresnel) X(function) X(gather) X(global_settings) X(gradient) X(gray) X(green) X(hierarchy) X(hollow) X(if)     \
    X(ifdef) X(ifndef) X(include) X(inside_vector) X(int) X(interior) X(internal) X(interpolate) X(intervals)         \
    X(inverse) X(ior) X(irid_wavelength) X(jitter) X(light_source) X(linear_spline) X(ln) X(local) X(location) X(log) \
    X(look_at) X(macro) X(material) X(matrix) X(max) X(max_intersections) X(max_trace_level) X(media)                 \
    X(media_attenuation) X(media_interaction) X(mesh) X(mesh2) X(metallic) X(method) X(min) X(mm_per_unit) X(mod)     \
    X(no) X(no_image) X(no_radiosity) X(no_reflection) X(no_shadow) X(noise_generator) X(normal_indices)              \
    X(normal_vectors) X(now) X(number_of_waves) X(object) X(off) X(on) X(once) X(open) X(orient) X(orthographic)      \
    X(parallel) X(pass_through) X(perspective) X(phong) X(phong_size) X(photons) X(pi) X(pigment) X(plane)            \
    X(point_at) X(polygon) X(pow) X(prod) X(quadric) X(quick_color) X(radians) X(radius) X(rand) X(range)  \
    X(ratio) X(red) X(reflection) X(reflection_exponent) X(refraction) X(render) X(rgb) X(rgbf) X(rgbft) X(rgbt)      \
    X(right) X(rotate) X(roughness) X(samples) X(scale) X(scattering) X(seed) X(select) X(shadowless) X(sin) X(sinh)  \
    X(sky) X(smooth_triangle) X(spacing) X(specular) X(sphere) X(spherical) X(split_union) X(spotlight)        \
    X(sqrt) X(srgb) X(srgbf) X(srgbft) X(srgbt) X(statistics) X(str) X(strcmp) X(strlen) X(strlwr) X(strupr)          \
    X(sturm) X(substr) X(sum) X(switch) X(t) X(tan) X(tanh) X(target) X(texture) X(texture_list) X(tightness)         \
    X(torus) X(transform) X(translate) X(transmit) X(triangle) X(true) X(type) X(u) X(u_steps) X(undef) X(union)      \
    X(up) X(uv_indices) X(uv_vectors) X(v) X(v_steps) X(val) X(variance) X(vaxis_rotate) X(vcross)      \
    X(vdot) X(version) X(vertex_vectors) X(vlength) X(vnormalize) X(vrotate) X(vstr) X(warning) X(while) X(x) X(y)    \
    X(yes) X(z)

enum class Word : std::uint16_t {
#define RAYS_SDL_ENUM(name) name##_,
    RAYS_SDL_WORDS(RAYS_SDL_ENUM)
#undef RAYS_SDL_ENUM
        other_,  ///< a reserved word of POV-Ray outside of the subset
};

std::string_view to_string(Word word);

/// The word begins an expression of a float, or of a vector.
bool is_float_function(Word word);
bool is_vector_word(Word word);

using NameId = std::uint32_t;

/// Gives every distinct name a small number. Reserved words are told apart by `word_of`.
class Names {
public:
    Names();
    NameId intern(std::string_view text, std::uint32_t hash);
    NameId intern(std::string_view text) { return intern(text, hash_of(text)); }
    std::string_view text(NameId id) const { return texts_[id]; }
    std::size_t size() const { return texts_.size(); }

    bool is_reserved(NameId id) const { return id < reserved_.size(); }
    Word word_of(NameId id) const { return reserved_[id]; }

    // Fowler, Noll, Vo: one multiplication a character, taken while the lexer walks over the name.
    static constexpr std::uint32_t kHashStart = 2166136261u;
    static constexpr std::uint32_t hash_step(std::uint32_t hash, char c) {
        return (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    }

private:
    static std::uint32_t hash_of(std::string_view text);
    void grow();

    struct Slot {
        std::uint32_t hash = 0;
        NameId id = 0xffffffff;
    };
    std::vector<Slot> slots_;  ///< open addressing, a power of two
    std::deque<std::string> texts_;
    std::vector<Word> reserved_;
};

}  // namespace rays::sdl
