#include "grader/student_t.h"

#include <algorithm>
#include <cmath>

namespace rays::grader {
namespace {

// The continued fraction of the incomplete beta function, by Lentz's method (Abramowitz and Stegun 26.5.8).
double beta_fraction(double a, double b, double x) {
    constexpr double kTiny = 1e-300;
    const auto no_zero = [](double v) { return std::abs(v) < kTiny ? kTiny : v; };
    double c = 1, d = 1 / no_zero(1 - (a + b) * x / (a + 1)), h = d;
    for (int m = 1; m < 500; ++m) {
        for (const double numerator : {m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)),
                                       -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))}) {
            d = 1 / no_zero(1 + numerator * d);
            c = no_zero(1 + numerator / c);
            h *= c * d;
        }
        if (std::abs(c * d - 1) < 1e-15) break;
    }
    return h;
}

// The regularised incomplete beta function I_x(a, b).
double incomplete_beta(double a, double b, double x) {
    if (x <= 0) return 0;
    if (x >= 1) return 1;
    const double front =
        std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
    if (x < (a + 1) / (a + b + 2)) return front * beta_fraction(a, b, x) / a;
    return 1 - front * beta_fraction(b, a, 1 - x) / b;
}

}  // namespace

double student_t_above(double t, double freedom) {
    if (std::isnan(t) || std::isnan(freedom)) return NAN;
    if (freedom >= 1e6) return 0.5 * std::erfc(t / std::sqrt(2.0));
    const double tail = 0.5 * incomplete_beta(freedom / 2, 0.5, freedom / (freedom + t * t));
    return t >= 0 ? tail : 1 - tail;
}

double student_t_limit(double alpha, double freedom) {
    double low = 0, high = 1;
    while (2 * student_t_above(high, freedom) > alpha && high < 1e12) high *= 2;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (2 * student_t_above(middle, freedom) > alpha ? low : high) = middle;
    }
    return high;
}

double sidak(double alarm_rate, int tests) { return -std::expm1(std::log1p(-alarm_rate) / std::max(tests, 1)); }

double sidak_of_all(double chance, int tests) { return -std::expm1(std::max(tests, 1) * std::log1p(-chance)); }

}  // namespace rays::grader
