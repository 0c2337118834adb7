// Student's t distribution: how far a mean of few numbers may stray from the truth.
#pragma once

namespace rays::grader {

/// The chance of a value above t with so many degrees of freedom (any number > 0; from 1e6 on it is the normal
/// distribution's to six digits). NaN for NaN.
double student_t_above(double t, double freedom);

/// The t that is exceeded on either side together with chance `alpha`, 0 < alpha < 1.
double student_t_limit(double alpha, double freedom);

/// What a single one of `tests` may risk, so that all together raise a false alarm with chance `alarm_rate` if they are
/// independent, and less if they lean on each other as a picture's tiles and channels do: 1 - (1 - rate)^(1 / tests).
double sidak(double alarm_rate, int tests);

/// The other way round: the chance that the least of `tests` chances is as small as `chance`.
double sidak_of_all(double chance, int tests);

}  // namespace rays::grader
