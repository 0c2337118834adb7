// A reference: POV-Ray's picture of a scene, and between which values each pixel may lie where an edge runs through it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <utility>
#include <vector>

#include "core/camera.h"

namespace rays {

using Rgb = std::array<float, 3>;

/// A picture in linear red, green, blue, rows from top to bottom.
struct RgbImage {
    Raster raster{0, 0};
    std::vector<Rgb> pixels;

    const Rgb& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width) +
                      static_cast<std::size_t>(x)];
    }
    Rgb& at(int x, int y) { return const_cast<Rgb&>(std::as_const(*this).at(x, y)); }
};

/// POV-Ray writes half floats: 11 significant bits, so a number is off by at most this share of itself ...
inline constexpr float kHalfRounding = 1.0f / 2048;
/// ... or by this much, half of the smallest half float.
inline constexpr float kHalfSmallest = 1.0f / (1 << 25);

/// How far a half float may be from the number it stands for.
inline float half_rounding(float value) { return std::abs(value) * kHalfRounding + kHalfSmallest; }

struct Reference {
    RgbImage frame;     ///< one sample in each pixel's centre
    RgbImage min, max;  ///< of the frame with 4 x 4 as many pixels, over the pixel and half a pixel around it

    const Raster& raster() const { return frame.raster; }

    /// Do the values around the pixel differ by more than the rounding of half floats? Never so where the picture is
    /// flat; always so at an edge, but also in shading as steep as that.
    bool silhouette(int x, int y) const;

    /// Does the colour lie between minimum and maximum, give or take rounding? False for NaN.
    bool within_envelope(int x, int y, const Rgb& color) const;
};

/// The minimum and maximum over each pixel and half a pixel around it. `fine` has 4 x 4 as many pixels as `frame`; the
/// pixel of `frame` itself counts, too. Throws std::invalid_argument when the sizes do not fit.
Reference make_reference(RgbImage frame, const RgbImage& fine);

/// One OpenEXR file of half floats with the channels R G B min.R min.G min.B max.R max.G max.B.
void save_reference(const Reference& reference, const std::filesystem::path& file);

/// Throws InputError when the file is missing, is no reference, or is larger than 4096 pixels in one direction.
Reference load_reference(const std::filesystem::path& file);

/// The channels R, G, B of an OpenEXR file, with the same limits.
RgbImage load_rgb_exr(const std::filesystem::path& file);

}  // namespace rays
