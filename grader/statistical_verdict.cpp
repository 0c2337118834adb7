#include "grader/statistical_verdict.h"

#include <algorithm>
#include <cmath>

#include "grader/student_t.h"

namespace rays::grader {
namespace {

// How often the worst of all tests of a right picture is as bad as this. Both kinds of test have half of the rate, so
// the chance of one counts twice.
double chance_of(const Examination& e, const std::vector<Suspect>& wrong) {
    double least = 1;
    for (const Suspect& s : wrong) {
        const Difference& d = e.of(s);
        const int tests = s.tile < 0 ? e.whole_tests : e.tile_tests;
        least = std::min(least, sidak_of_all(2 * student_t_above(std::abs(d.z), d.freedom), 2 * tests));
    }
    return least;
}

// A picture too bright by less than this share would not be noticed.
double resolution_of(const Examination& e) {
    double worst = 0;
    for (const Difference& d : e.whole)
        if (d.margin > 0) worst = std::max(worst, d.limit * d.standard_error / std::abs(d.reference));
    return worst;
}

}  // namespace

BiasVerdict judge_bias(Pictures first, const AveragedReference& truth, const VerdictOptions& options,
                       const std::function<Pictures(int seeds)>& more) {
    BiasVerdict verdict;
    const int seeds = static_cast<int>(first.size());
    verdict.examination = examine(first, truth, options.batch(options.first_alarm_rate));
    verdict.pictures = std::move(first);
    verdict.passed = verdict.examination.passed();
    if (verdict.passed) return verdict;
    if (verdict.examination.not_finite > 0) return verdict.chance = 0, verdict;
    verdict.first_found = verdict.examination.suspects();
    verdict.chance = chance_of(verdict.examination, verdict.first_found);
    Pictures second = more(2 * seeds);
    if (second.empty()) return verdict.cut_short = true, verdict;
    verdict.batches = 2;
    verdict.examination = examine(second, truth, options.batch(options.second_alarm_rate), verdict.first_found);
    verdict.pictures = std::move(second);
    verdict.passed = verdict.examination.passed();
    verdict.chance *=
        verdict.examination.not_finite > 0 ? 0 : chance_of(verdict.examination, verdict.examination.suspects());
    return verdict;
}

NoiseVerdict judge_noise(const Examination& student, bool student_all_equal, const Examination& solution,
                         const VerdictOptions& options) {
    NoiseVerdict v;
    v.student = student.mean_variance;
    v.solution = solution.mean_variance;
    v.ratio = v.solution > 0 ? v.student / v.solution : v.student > 0 ? INFINITY : 1;
    v.equal = student_all_equal && v.solution > 0;
    v.shared = student.shared_noise > options.shared_noise * std::max(1.0, solution.shared_noise);
    v.unresolved = !(v.ratio < options.noise_none) && !(resolution_of(student) <= options.resolution);
    v.share = std::clamp((options.noise_none - v.ratio) / (options.noise_none - options.noise_full), 0.0, 1.0);
    if (!(v.ratio < options.noise_none) || v.equal || v.shared) v.share = 0;
    return v;
}

NoiseVerdict kinder(const NoiseVerdict& first, const NoiseVerdict& second) {
    NoiseVerdict v = second.share >= first.share ? second : first;
    v.batches = 2;
    v.unresolved = first.unresolved && second.unresolved;
    return v;
}

}  // namespace rays::grader
