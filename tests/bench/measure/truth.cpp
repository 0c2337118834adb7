#include "truth.h"

#include <array>
#include <cmath>

#include "bezier.h"

namespace rays::bench {
namespace {

using Control = std::array<ExactVec, 16>;

/// The ray's parameter nearest to the origin.
Exact nearest_to_origin(const ExactRay& ray) {
    return -glm::dot(ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
}

/// The smallest positive shift + u with a u^2 + 2 b u + c = 0.
std::optional<Exact> first_root(Exact a, Exact b, Exact c, Exact shift) {
    const Exact discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const Exact q = -(b + std::copysign(std::sqrt(discriminant), b));
    const Exact t0 = shift + q / a, t1 = shift + c / q;
    const Exact low = std::min(t0, t1), high = std::max(t0, t1);
    if (low > 0) return low;
    return high > 0 ? std::optional(high) : std::nullopt;
}

Exact torus_distance(const Torus& torus, const ExactVec& p) {
    return std::hypot(std::hypot(p.x, p.z) - torus.major, p.y) - torus.minor;
}

std::optional<Exact> torus_root(const Torus& torus, const ExactRay& ray) {
    constexpr int kSteps = 1000;
    const Exact middle = nearest_to_origin(ray), ball = Exact(torus.major) + torus.minor;
    const ExactVec nearest = ray.at(middle);
    const Exact half2 = ball * ball - glm::dot(nearest, nearest);
    if (!(half2 > 0)) return std::nullopt;
    const Exact length = std::sqrt(glm::dot(ray.direction, ray.direction));
    const Exact from = middle - std::sqrt(half2) / length, step = 2 * std::sqrt(half2) / length / kSteps;
    Exact before = torus_distance(torus, ray.at(from));
    for (int i = 1; i <= kSteps; ++i) {
        const Exact after = torus_distance(torus, ray.at(from + i * step));
        if ((before < 0) != (after < 0)) {
            Exact low = from + (i - 1) * step, high = from + i * step;
            for (int k = 0; k < 70; ++k) {  // 2^-70 of a step is below the rounding of long double
                const Exact half = (low + high) / 2;
                ((torus_distance(torus, ray.at(half)) < 0) == (before < 0) ? low : high) = half;
            }
            return low;
        }
        before = after;
    }
    return std::nullopt;
}

/// De Casteljau at 1/2 along u (step 4, curves at 0..3) or v (step 1, curves at 0, 4, 8, 12).
void split(const Control& k, bool along_u, Control& low, Control& high) {
    const std::size_t step = along_u ? 4 : 1, next = along_u ? 1 : 4;
    for (std::size_t curve = 0, i = 0; curve < 4; ++curve, i += next) {
        const ExactVec a = k[i], b = k[i + step], c = k[i + 2 * step], d = k[i + 3 * step];
        const ExactVec ab = (a + b) / Exact(2), bc = (b + c) / Exact(2), cd = (c + d) / Exact(2);
        const ExactVec abc = (ab + bc) / Exact(2), bcd = (bc + cd) / Exact(2), middle = (abc + bcd) / Exact(2);
        low[i] = a, low[i + step] = ab, low[i + 2 * step] = abc, low[i + 3 * step] = middle;
        high[i] = middle, high[i + step] = bcd, high[i + 2 * step] = cd, high[i + 3 * step] = d;
    }
}

class PatchTruth {
public:
    PatchTruth(const Control& control, const ExactRay& ray) : control_(control), ray_(ray) {
        const ExactVec w = glm::normalize(ray.direction);
        x_ = glm::normalize(glm::cross(w, std::abs(w.x) < 0.7L ? ExactVec(1, 0, 0) : ExactVec(0, 1, 0)));
        y_ = glm::cross(w, x_);
    }

    std::optional<Exact> nearest() {
        search(control_, 0, 0, 1, 0);
        return found_;
    }

private:
    bool box_meets_ray(const Control& k) const {
        Exact x0 = 1e30L, x1 = -1e30L, y0 = 1e30L, y1 = -1e30L;
        for (const ExactVec& p : k) {
            const Exact x = glm::dot(p - ray_.origin, x_), y = glm::dot(p - ray_.origin, y_);
            x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
        }
        return x0 <= kMargin && x1 >= -kMargin && y0 <= kMargin && y1 >= -kMargin;
    }

    void search(const Control& k, Exact u, Exact v, Exact width, int depth) {
        if (!box_meets_ray(k)) return;
        if (depth == kDepth) return refine(u + width / 2, v + width / 2);
        std::array<Control, 2> halves;
        std::array<Control, 4> quarters;
        split(k, true, halves[0], halves[1]);
        split(halves[0], false, quarters[0], quarters[1]);
        split(halves[1], false, quarters[2], quarters[3]);
        for (std::size_t i = 0; i < 4; ++i)
            search(quarters[i], u + (i / 2) * width / 2, v + (i % 2) * width / 2, width / 2, depth + 1);
    }

    void refine(Exact u, Exact v) {
        const auto root = newton_from<Exact>(control_, ray_.origin, ray_.direction, u, v, 30);
        const auto inside = [](Exact s) { return s >= -kMargin && s <= 1 + kMargin; };
        if (!inside(root.u) || !inside(root.v) || !(root.t > 0)) return;
        const ExactVec off = patch_point(control_, root.u, root.v).p - ray_.at(root.t);
        if (glm::dot(off, off) < kMargin * kMargin && (!found_ || root.t < *found_)) found_ = root.t;
    }

    static constexpr Exact kMargin = 1e-12L;
    static constexpr int kDepth = 12;  ///< pieces of 1/4096: Newton's method starts at the root's door

    const Control& control_;
    const ExactRay& ray_;
    ExactVec x_, y_;
    std::optional<Exact> found_;
};

}  // namespace

ExactRoot truth_of(const Sphere& sphere) {
    return [sphere](const ExactRay& ray) {
        ExactRay moved = ray;
        moved.origin -= ExactVec(sphere.center);
        const Exact shift = nearest_to_origin(moved), r = sphere.radius;
        const ExactVec p = moved.at(shift);
        return first_root(glm::dot(ray.direction, ray.direction), glm::dot(p, ray.direction), glm::dot(p, p) - r * r,
                          shift);
    };
}

ExactRoot truth_of(const Quadric& quadric) {
    return [q = glm::mat<4, 4, Exact>(quadric.q)](const ExactRay& ray) {
        using Vec = glm::vec<4, Exact>;
        const Exact shift = nearest_to_origin(ray);
        const Vec p(ray.at(shift), 1), d(ray.direction, 0);
        return first_root(glm::dot(d, q * d), glm::dot(d, q * p), glm::dot(p, q * p), shift);
    };
}

ExactRoot truth_of(const Torus& torus) {
    return [torus](const ExactRay& ray) { return torus_root(torus, ray); };
}

ExactRoot truth_of(const BicubicPatch& patch) {
    Control control;
    for (std::size_t i = 0; i < 16; ++i) control[i] = ExactVec(patch.control[i]);
    return [control](const ExactRay& ray) { return PatchTruth(control, ray).nearest(); };
}

}  // namespace rays::bench
