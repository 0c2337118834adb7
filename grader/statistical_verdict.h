// The verdict on a series of noisy pictures: is their mean right, and are they as clean as the solution's? Who takes
// the pictures is nobody's business here: the check renders them, the calibration invents them.
#pragma once

#include <functional>

#include "grader/statistics.h"

namespace rays::grader {

struct VerdictOptions {
    int tile = 8;
    double tile_margin = 0.01, whole_margin = 0.005;
    /// How often a right picture fails the first batch, which costs another batch, and how often one that did fails the
    /// second, which costs points. The batches are independent: together alarm_rate().
    double first_alarm_rate = 0.1, second_alarm_rate = 0.005;
    /// The student's variance over the solution's: full points up to the first, none from the second on. A correct
    /// sampler that is not the solution's (jittered, or another sequence) must stay below the first.
    double noise_full = 1.75, noise_none = 2.5;
    /// Pixels that share random numbers hide their noise from the pixels' variance, not from the tiles'.
    double shared_noise = 8;
    /// A picture with too much noise that would not be caught if it were too bright by this share shows nothing.
    double resolution = 0.04;

    BiasOptions batch(double rate) const { return {tile, tile_margin, whole_margin, rate}; }
    double alarm_rate() const { return first_alarm_rate * second_alarm_rate; }
};

struct BiasVerdict {
    bool passed = false;
    bool cut_short = false;  ///< the second batch did not come
    int batches = 1;
    Examination examination;           ///< of the last batch
    Pictures pictures;                 ///< of the last batch
    std::vector<Suspect> first_found;  ///< what looked wrong in the first batch
    double chance = 1;                 ///< that a right picture looks as wrong as this twice
};

/// `more` takes so many pictures with seeds never used before; nothing when that went wrong. It is only asked when
/// `first` fails, for twice as many, and only what failed there can fail again. Not a number is never chance.
BiasVerdict judge_bias(Pictures first, const AveragedReference& truth, const VerdictOptions& options,
                       const std::function<Pictures(int seeds)>& more);

struct NoiseVerdict {
    double share = 1;  ///< of the points
    double student = 0, solution = 0, ratio = 1;
    bool equal = false;       ///< all pictures are the same, though the solution's are not
    bool shared = false;      ///< neighbouring pixels share their random numbers
    bool unresolved = false;  ///< and there is so much noise that the mean shows nothing
    int batches = 1;
};

NoiseVerdict judge_noise(const Examination& student, bool student_all_equal, const Examination& solution,
                         const VerdictOptions& options);

/// Of two judgements the kinder one: too much noise has to be found twice.
NoiseVerdict kinder(const NoiseVerdict& first, const NoiseVerdict& second);

}  // namespace rays::grader
