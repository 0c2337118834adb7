// Noisy pictures against an averaged reference: is the mean over many seeds right, tile by tile and as a whole? Pure
// functions of pictures in linear floats; a picture of one seed is one independent observation.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "references/averaged.h"

namespace rays::grader {

using Pictures = std::vector<RgbImage>;

struct BiasOptions {
    int tile = 8;  ///< pixels each way
    /// A difference of this share of the level is none: sampling is not all that may differ.
    double tile_margin = 0.01, whole_margin = 0.005;
    double alarm_rate = 0.05;  ///< of one batch: how often a right picture fails it
};

/// One hypothesis: pictures and truth agree here, give or take the margin.
struct Difference {
    double value = 0;           ///< mean over seeds and pixels of picture - reference
    double reference = 0;       ///< the reference's mean here
    double margin = 0;          ///< in units of the picture
    double standard_error = 0;  ///< of `value`
    double freedom = 0;         ///< degrees of freedom of that
    double limit = 0;           ///< largest |z| of a right picture
    double z = 0;  ///< by how many standard errors `value` goes beyond the margin; 0 within it, < 0: too dark
    bool wrong = false;
};

struct Tile {
    int x = 0, y = 0, width = 0, height = 0;  ///< at the right and lower edge they may be smaller
    std::array<Difference, 3> channels{};
};

/// Which hypothesis, and in which direction: what a second batch has to confirm.
struct Suspect {
    int tile = -1;  ///< -1: the whole picture
    std::size_t channel = 0;
    bool too_bright = false;
};

struct Examination {
    int seeds = 0;
    int not_finite = 0;  ///< pixels of all pictures with a NaN or an infinity; then nothing below is filled in
    std::vector<Tile> tiles;
    std::array<Difference, 3> whole{};
    int tiles_wrong = 0;
    int worst_tile = -1;                  ///< the one nearest to, or farthest beyond, its limit
    std::size_t worst_channel = 0;        ///< there
    int tile_tests = 0, whole_tests = 0;  ///< each kind shares half of the alarm rate
    double mean_variance = 0;             ///< over the seeds, mean over pixels and channels
    /// Variance of tiles' means times their pixels, over the pixels' variance: 1 when neighbouring pixels have random
    /// numbers of their own, the number of a tile's pixels when they share them.
    double shared_noise = 0;

    std::vector<Suspect> suspects() const;  ///< what is wrong
    bool passed() const { return not_finite == 0 && suspects().empty(); }
    const Difference& of(const Suspect& s) const;
};

/// Needs at least two pictures of the truth's size, or throws std::invalid_argument. With suspects only these may be
/// wrong, each only in its direction, and they alone share the alarm rate.
///
/// The standard error of a tile has two parts. The pictures': the seeds' tile means have a variance with K - 1 degrees
/// of freedom, whatever pixels of one picture share. The reference's: the mean of its pixels' errors, not divided by
/// the root of their number, because each of its frames uses the same random numbers for all pixels, so that
/// neighbours are wrong together; this is the largest error that they can have together. It comes from many frames and
/// counts as known exactly; degrees of freedom by Welch and Satterthwaite.
///
/// Where light is rare but bright, all seeds of a tile may have missed it: their spread then says nothing of it. So a
/// tile is also given the mean variance of the 3 x 3 tiles around it, and of the 5 x 5 where few of these have most of
/// the variance; whichever allows most counts.
Examination examine(const Pictures& pictures, const AveragedReference& truth, const BiasOptions& options,
                    const std::vector<Suspect>& suspects = {});

/// The mean over the pictures.
RgbImage mean_of(const Pictures& pictures);

/// Each pixel has the z of its tile, between -999 and 999.
RgbImage z_picture(const Examination& examination, Raster raster);

/// Are all pictures the same, byte for byte?
bool all_equal(const Pictures& pictures);

}  // namespace rays::grader
