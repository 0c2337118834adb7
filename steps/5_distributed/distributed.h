// Step 5, distributed ray tracing: the contract. From one ray a pixel to a mean over many: over the pixel's square, the
// lens, the shutter's time, the areas of lights, the slopes of rough surfaces.
//
// What is random is explicit: every function gets its random numbers u in [0, 1) from whoever calls it. Which numbers
// those are is the patterns' business (tasks 5.1 to 5.4); what they mean is the effects' (tasks 5.5 to 5.10).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "2_phong/phong.h"
#include "4_partitioning/partitioning.h"
#include "core/camera.h"
#include "core/light.h"
#include "core/ray.h"
#include "core/sampler.h"
#include "core/scene.h"

namespace rays {

// ---- Tasks 5.1 to 5.4: patterns --------------------------------------------------------------------------------------

enum class Pattern { regular, random, jittered, multi_jittered, sobol };

/// "regular", "random", "jittered", "multi_jittered", "sobol".
std::optional<Pattern> pattern_named(std::string_view name);

/// Which point of a pattern is meant. The same Draw is the same point; whatever differs makes another pattern, as
/// unrelated as two throws of dice (but samples of one pattern belong together: that is its point).
struct Draw {
    std::uint64_t seed = 0;
    std::uint32_t pixel = 0;
    std::uint32_t dimension = 0;  ///< what the point is for: see dimension_of
    std::uint32_t sample = 0;     ///< 0 <= sample < samples
    std::uint32_t samples = 1;
};

/// One number for everything but the sample: the key of a pattern. Given.
constexpr std::uint64_t key_of(const Draw& d) {
    // Odd factors without pattern: no two small pixels and dimensions meet.
    return mixed(d.seed * 0x9e3779b97f4a7c15ull + d.pixel * 0xd1342543de82ef95ull +
                 d.dimension * 0xaf251af3b0f025b5ull + 1);
}

// All points lie in [0, 1)^2.

/// The centres of equal cells, columns x rows = samples, as square as that goes. The sample decides which, by a
/// permutation with the key of the pattern: else the n-th point of the lens would always meet the n-th of the pixel.
Vec2 regular_point(const Draw& draw);
/// Any point, whatever the others are.
Vec2 random_point(const Draw& draw);
/// One random point in each of about `samples` equal cells (Cook, 1986). With a number of samples that does not fill
/// a grid some cells stay empty, which ones is chance: the mean over many pixels is right.
Vec2 jittered_point(const Draw& draw);
/// One in each cell, and in projection one in each of `samples` columns and rows (Chiu, Shirley, Wang, 1994; Kensler,
/// 2013).
Vec2 multi_jittered_point(const Draw& draw);
/// Sobol's sequence, scrambled after Owen (1995), in an order shuffled the same way (Burley, "Practical Hash-based Owen
/// Scrambling", JCGT 9(4), 2020). Dimensions 2k and 2k + 1 are the four dimensions of one sequence: what is blurred by
/// two things at once converges faster. Progressive: it does not know `samples`, and every power of two of first points
/// is stratified: in an even dimension in every way, in an odd one along each axis.
Vec2 sobol_point(const Draw& draw);

/// The pattern's point.
Vec2 point_of(Pattern pattern, const Draw& draw);

/// For what takes one number, as time does: one in each of `samples` equal strips, in their centres or anywhere. Where
/// a pattern's points have such an x it is that; of regular and jittered points only the root of `samples` have
/// different columns: as times these would be as good as N^(-3/4), not 1/N. Given.
Real number_of(Pattern pattern, const Draw& draw);

// ---- Task 5.5: what points mean --------------------------------------------------------------------------------------

/// From the unit square to the unit disc, equal areas to equal areas (Shirley and Chiu, 1997).
Vec2 disc_point(Vec2 u);
/// To the regular polygon with this many corners on the unit circle, the first one at (0, 1); equal areas to equal
/// areas.
Vec2 polygon_point(Vec2 u, int corners);
/// To a ball of radius 1 with a density like 1 / sqrt(1 - r^2): from afar, from all sides, a uniform disc. Such are x,
/// y, z of a uniform unit quaternion (Shoemake, "Uniform Random Rotations", Graphics Gems III, 1992).
Vec3 ball_point(Vec2 u, Real u3);

// ---- Task 5.6: the pixel's filter ------------------------------------------------------------------------------------

enum class Filter { box, tent, mitchell };

/// "box", "tent", "mitchell".
std::optional<Filter> filter_named(std::string_view name);

struct FilterPoint {
    Vec2 offset{0};    ///< from the pixel's centre, in pixels
    float weight = 1;  ///< of the sample; 1 on the average
};

/// Draws offsets with the density |f|, weighted by its sign: the mean of weight * radiance over the samples is the
/// filtered picture. box: one pixel wide; tent: two; mitchell: four, with B = C = 1/3 (Mitchell and Netravali, 1988).
FilterPoint filter_point(Filter filter, Vec2 u);

// ---- Task 5.7: the lens ----------------------------------------------------------------------------------------------

/// The ray through the same point of the film from a point of the lens. The lens is a disc (or polygon) of radius
/// aperture / 4 around where the pinhole's ray starts, spanned by the directions of `right` and `up`. All rays of one
/// film point meet in the plane through focal_point that is parallel to the film.
Ray lens_ray(const Camera& camera, const Raster& raster, int column, int row, Vec2 offset, Vec2 u);

// ---- Task 5.8: lights with an area -----------------------------------------------------------------------------------

/// The point light that stands for an area light: all of it moved (point_at, too) to a point of location + a axis_u +
/// b axis_v with a, b in [-1/2, 1/2]; circular: of the ellipse in it; orient: of the ball of that width around
/// location. Its colour is the whole light's: the mean over many points is what arrives. Other lights are returned as
/// they are.
Light light_at(const Light& light, Vec2 u, Real u3);

// ---- Task 5.9: time --------------------------------------------------------------------------------------------------

/// When a sample sees the scene, if the shutter is open for all of [shutter_open, shutter_close] equally.
Real shutter_time(const Camera& camera, Real u);
/// A number of the scene at a value of its variable: linear between the samples, the first or last beyond them.
Real value_at(const Varying& varying, Real at);

// ---- Task 5.10: rough surfaces ---------------------------------------------------------------------------------------

/// A normal tilted by chance: by an angle a with cos a = (1 - u.x)^(1 / (m + 2)), m = 1 / glossy, to any side: the
/// slopes whose mirror makes Blinn's highlight of exponent m. It still faces the viewer (else it tilts to the other
/// side), and a mirror ray that would go below the true surface is mirrored up at it.
Vec3 tilted_normal(const Surface& surface, Vec2 u);

// ---- Task 5.11: enough? ----------------------------------------------------------------------------------------------

/// What a pixel's samples say so far: sums of four groups that share the samples evenly.
struct Estimate {
    static constexpr std::uint32_t kGroups = 4;
    Radiance sum[kGroups];
    std::uint32_t samples = 0;  ///< in all, a multiple of kGroups where somebody asks for the error

    Radiance mean() const {
        Radiance all;
        for (const Radiance& s : sum) all += s;
        return samples == 0 ? all : (1.0f / static_cast<float>(samples)) * all;
    }
};

/// The standard error of the mean, of the lane where it is largest, from how far the groups' means are apart.
float standard_error(const Estimate& estimate);
/// May a pixel stop at this error? `around` are the errors of the eight pixels around it (fewer at the border). One
/// pixel's own error may be small by chance: a feature that its first samples missed shows in its neighbours.
bool is_enough(float own, std::span<const float> around, float wanted);

// ---- Task 5.12: dimensions -------------------------------------------------------------------------------------------

enum class Purpose { pixel, lens, time, light, ball_light, rough_surface };

/// What a scene distributes over.
struct Purposes {
    bool lens = false;
    std::uint32_t lights = 0;  ///< in all, of whatever kind; 0 when none has an area
};
/// Which dimension of a pattern decides what: never the same one for two things. `number` counts lights (for light and
/// ball_light, which goes with it), or the surfaces above a rough one. The pixel's neighbour, with which it shares a
/// sequence, is the first thing that the scene has: the lens, else a light, else the time.
std::uint32_t dimension_of(Purpose purpose, std::uint32_t number, const Purposes& scene);

// ---- Task 5.13: no more than a scene needs ---------------------------------------------------------------------------

/// The diameter, in pixels, of the largest circle of confusion of anything whose depth (distance along the camera's
/// axis) lies between these two. 0 with a closed aperture; `farthest` may be infinite.
Real largest_blur_px(const Camera& camera, const Raster& raster, Real nearest, Real farthest);
/// The width of the widest penumbra that a light of this diameter throws past an edge at least `light_to_edge` away
/// onto something at most `edge_to_receiver` behind it. No edge at all (infinite light_to_edge): 0.
Real widest_penumbra(Real light_diameter, Real light_to_edge, Real edge_to_receiver);

}  // namespace rays
