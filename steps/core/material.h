// What surfaces look like and what fills them. POV-Ray's words and meanings.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/radiance.h"
#include "core/transform.h"

namespace rays {

inline constexpr std::uint32_t kNone = 0xffffffff;  ///< an index that points nowhere

/// A colour with POV-Ray's two kinds of transparency. `filter` lets light through tinted, `transmit` untinted.
struct Color {
    Radiance rgb;
    float filter = 0;
    float transmit = 0;
    bool operator==(const Color&) const = default;
};

inline bool lets_light_through(const Color& c) { return c.filter != 0 || c.transmit != 0; }

/// One colour, or a 3D checkerboard of unit cubes of two colours. `transform` takes pattern space to world space.
struct Pigment {
    Color color{Radiance(0.0f)};
    std::optional<Color> checker_other;  ///< present: a checker; cubes with even floor(x)+floor(y)+floor(z) get `color`
    std::uint32_t transform = kNone;     ///< into Scene::transforms
    bool operator==(const Pigment&) const = default;
};

inline bool lets_light_through(const Pigment& p) {
    return lets_light_through(p.color) || (p.checker_other && lets_light_through(*p.checker_other));
}

struct Reflection {
    Radiance min{0.0f};
    Radiance max{0.0f};
    bool fresnel = false;
    float falloff = 1;   ///< exponent between min and max when not fresnel
    float exponent = 1;  ///< of the reflected brightness
    float metallic = 0;
    bool operator==(const Reflection&) const = default;
};

struct Finish {
    Radiance ambient{0.1f};
    Radiance emission{0.0f};
    float diffuse = 0.6f;
    float brilliance = 1;  ///< exponent of n . l in the diffuse part
    float phong = 0;
    float phong_size = 40;
    float specular = 0;
    float roughness = 0.05f;
    float metallic = 0;
    Reflection reflection;
    bool conserve_energy = false;
    float glossy = 0;  ///< > 0: the normal is tilted by chance, around the true one as cos^(1 / glossy) (step 5)
    bool operator==(const Finish&) const = default;
};

/// What light meets on its way through a medium. All coefficients per unit length.
struct Media {
    struct LinearDensity {  ///< clamp of a + b . p
        Real constant = 0;
        Vec3 gradient{0};
    };
    struct SphericalDensity {};  ///< max(0, 1 - |p|) in density space
    struct GridDensity {         ///< trilinear in the unit cube of density space, x fastest
        std::uint32_t size[3] = {0, 0, 0};
        std::vector<float> values;
        int interpolation = 0;
    };
    struct Density {
        std::variant<std::monostate, SphericalDensity, GridDensity, LinearDensity> form;
        Radiance color{1.0f};
        std::uint32_t transform = kNone;
    };
    struct Scattering {
        int type = 1;  ///< POV-Ray's 1 isotropic, 2 and 3 Mie, 4 Rayleigh, 5 Henyey-Greenstein
        Radiance color{0.0f};
        float eccentricity = 0;
        float extinction = 1;
    };
    Radiance absorption{0.0f};
    Radiance emission{0.0f};
    std::optional<Scattering> scattering;
    std::vector<Density> densities;  ///< multiplied
    int method = 3;
    int intervals = 1;
    int samples_min = 1, samples_max = 1;
};

struct Interior {
    float ior = 1;
    float dispersion = 1;
    int dispersion_samples = 7;
    float caustics = 0;
    float fade_distance = 0;
    float fade_power = 0;
    Radiance fade_color{0.0f};
    std::vector<Media> media;
};

struct Material {
    Pigment pigment;
    Finish finish;
};

}  // namespace rays
