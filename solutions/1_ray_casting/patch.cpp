// The bicubic Bezier patch: a system of two equations in (u, v), with no root missed.
#include <algorithm>
#include <array>
#include <cmath>

#include "1_ray_casting/ray_casting.h"
#include "core/unfinished.h"

namespace rays {

using glm::dot;

//> hidden
namespace {

constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();
/// Roots this far outside of a piece of the patch still count (u and v run from 0 to 1): rounding must not open a gap
/// between pieces, nor between two patches with a common edge. 1e-9 in double.
const Real kSeam = std::sqrt(kEpsilon) / 16;
/// A piece of this size, relative to its distance, is a point. 2e-10 in double.
const Real kPoint = std::sqrt(kEpsilon) / 64;
/// No ray looks at more pieces than this; ordinary ones look at 10 to 40. It stops rays that lie in a patch.
constexpr int kMostPieces = 10000;

/// Four numbers in one register. Sums and products go lane by lane, comparisons give a mask.
using Four = Real __attribute__((vector_size(4 * sizeof(Real))));

Four smaller(const Four& a, const Four& b) { return a < b ? a : b; }
Four larger(const Four& a, const Four& b) { return a > b ? a : b; }
Real largest(const Four& a) { return std::max({a[0], a[1], a[2], a[3]}); }
Real smallest(const Four& a) { return std::min({a[0], a[1], a[2], a[3]}); }
Real sum(const Four& a) { return (a[0] + a[1]) + (a[2] + a[3]); }
template <class Mask>
bool any(const Mask& m) {
    return (m[0] | m[1] | m[2] | m[3]) != 0;
}

/// One coordinate of the sixteen control points: rows run along v, and follow each other along u.
struct Rows {
    Four of[4];

    Four lowest() const { return smaller(smaller(of[0], of[1]), smaller(of[2], of[3])); }
    Four highest() const { return larger(larger(of[0], of[1]), larger(of[2], of[3])); }
    bool reaches_zero() const { return any(lowest() <= 0) && any(highest() >= 0); }
    Real largest_size() const { return std::max(largest(highest()), largest(-lowest())); }
};
struct Control {
    Rows x, y, z;
};

Control control_of(const std::array<Vec3, 16>& points) {
    Control k;
    for (std::size_t r = 0; r < 4; ++r) {
        const Vec3 &a = points[4 * r], &b = points[4 * r + 1], &c = points[4 * r + 2], &d = points[4 * r + 3];
        k.x.of[r] = Four{a.x, b.x, c.x, d.x};
        k.y.of[r] = Four{a.y, b.y, c.y, d.y};
        k.z.of[r] = Four{a.z, b.z, c.z, d.z};
    }
    return k;
}

template <class T>
T lerp_cubic(const T& a, const T& b, const T& c, const T& d, Real t) {
    const Real s = 1 - t;
    return (s * s * s) * a + (3 * s * s * t) * b + (3 * s * t * t) * c + (t * t * t) * d;
}
template <class T>
T slope_cubic(const T& a, const T& b, const T& c, const T& d, Real t) {
    const Real s = 1 - t;
    return (3 * s * s) * (b - a) + (6 * s * t) * (c - b) + (3 * t * t) * (d - c);
}

struct PatchPoint {
    Vec3 p, du, dv;
};

PatchPoint evaluate(const Control& control, Vec2 uv) {
    PatchPoint at;
    const Rows* const coordinates[3] = {&control.x, &control.y, &control.z};
    for (int axis = 0; axis < 3; ++axis) {
        const auto& k = coordinates[axis]->of;
        const Four along = lerp_cubic(k[0], k[1], k[2], k[3], uv.x);  // a curve in v
        const Four slope = slope_cubic(k[0], k[1], k[2], k[3], uv.x);
        at.p[axis] = lerp_cubic(along[0], along[1], along[2], along[3], uv.y);
        at.du[axis] = lerp_cubic(slope[0], slope[1], slope[2], slope[3], uv.y);
        at.dv[axis] = slope_cubic(along[0], along[1], along[2], along[3], uv.y);
    }
    return at;
}

/// The control points as the ray sees them: x and y across it, z along it. The ray is the line x = y = 0, the common
/// line of two planes (Kajiya, "Ray Tracing Parametric Patches", SIGGRAPH 1982).
Control seen_along(const Ray& ray, Real length, const std::array<Vec3, 16>& control) {
    const Vec3 w = ray.direction / length;
    // An orthonormal frame (Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017).
    const Real sign = std::copysign(Real(1), w.z), a = -1 / (sign + w.z), b = w.x * w.y * a;
    const Vec3 x(1 + sign * w.x * w.x * a, sign * b, -sign * w.x), y(b, sign + w.y * w.y * a, -w.y);
    Control seen = control_of(control);
    for (std::size_t r = 0; r < 4; ++r) {
        const Four px = seen.x.of[r] - ray.origin.x, py = seen.y.of[r] - ray.origin.y, pz = seen.z.of[r] - ray.origin.z;
        seen.x.of[r] = px * x.x + py * x.y + pz * x.z;
        seen.y.of[r] = px * y.x + py * y.y + pz * y.z;
        seen.z.of[r] = px * w.x + py * w.y + pz * w.z;
    }
    return seen;
}

/// A piece of the patch, [low, high] in (u, v), with the control points of its own. Without default values: a stack of
/// them is made for every ray.
struct Piece {
    Control k;
    Vec2 low, high;
    Real nearest;  ///< smallest z of the control points

    /// False when the ray certainly passes by: the piece lies in the convex hull of its control points, so in every
    /// strip around them. Two strips along the axes, and two along the piece's own edges ("fat lines": Nishita,
    /// Sederberg, Kakimoto, "Ray Tracing Trimmed Rational Surface Patches", SIGGRAPH 1990). The latter are narrow where
    /// the patch is seen from the side, and keep the number of pieces small at silhouettes.
    bool may_meet_ray() const {
        const Rows &x = k.x, &y = k.y;
        if (!x.reaches_zero() || !y.reaches_zero()) return false;
        const auto across_edges = [&](const auto& difference) {
            const Real dx = difference(x), dy = difference(y);
            Rows across;
            for (int r = 0; r < 4; ++r) across.of[r] = dx * y.of[r] - dy * x.of[r];
            return across;
        };
        return across_edges([](const Rows& c) {
                   return c.of[3][0] + c.of[3][3] - c.of[0][0] - c.of[0][3];
               }).reaches_zero() &&
               across_edges([](const Rows& c) {
                   return c.of[0][3] + c.of[3][3] - c.of[0][0] - c.of[3][0];
               }).reaches_zero();
    }
};

/// How a piece stretches: the differences of its control points are those of its derivatives.
struct Stretch {
    Real u = 0, v = 0;  ///< the longest, in space: which way to split, when to stop
    bool one_root_at_most = false;
    bool newton_finds_it = false;  ///< from any start in the piece; so if it finds none, there is none
};

/// Let M be the inverse of the mean Jacobian of (x, y), and e the largest |M J - I| on the piece. For e < 1, (x, y) is
/// one-to-one. For e <= 1/4 a Newton step ends nearer to the root by a factor 2 e / (1 - e) < 1, soon quadratically.
/// By the convex hull property it is enough to look at the control points of the derivatives. (In the spirit of Toth,
/// "On Ray Tracing Parametric Surfaces", SIGGRAPH 1985, who certifies Newton's method by intervals.)
Stretch stretch(const Control& k) {
    // Twelve differences each way. The last of a row, or the last row, stands twice.
    const auto along_v = [](const Rows& c) {
        Rows d;
        for (int r = 0; r < 4; ++r)
            d.of[r] = __builtin_shufflevector(c.of[r], c.of[r], 1, 2, 3, 3) -
                      __builtin_shufflevector(c.of[r], c.of[r], 0, 1, 2, 2);
        return d;
    };
    const auto along_u = [](const Rows& c) {
        return Rows{{c.of[1] - c.of[0], c.of[2] - c.of[1], c.of[3] - c.of[2], c.of[3] - c.of[2]}};
    };
    const Control du{along_u(k.x), along_u(k.y), along_u(k.z)}, dv{along_v(k.x), along_v(k.y), along_v(k.z)};
    const auto longest = [](const Control& d) {
        return std::max({d.x.largest_size(), d.y.largest_size(), d.z.largest_size()});
    };
    Stretch result;
    result.u = longest(du);
    result.v = longest(dv);
    // A mean of differences is the difference of the ends.
    const auto mean_along_u = [](const Rows& c) { return sum(c.of[3] - c.of[0]) / 12; };
    const auto mean_along_v = [](const Rows& c) {
        const Four ends = c.of[0] + c.of[1] + c.of[2] + c.of[3];
        return (ends[3] - ends[0]) / 12;
    };
    const Vec2 mean_u(mean_along_u(k.x), mean_along_u(k.y)), mean_v(mean_along_v(k.x), mean_along_v(k.y));
    // M = [v.y -v.x; -u.y u.x] / det: the rows of M du - (1, 0) and M dv - (0, 1), times det.
    const Real det = mean_u.x * mean_v.y - mean_u.y * mean_v.x;
    const auto largest_off = [](const Control& d, const Vec2& mean, Real expected) {
        Four most{};
        for (int r = 0; r < 4; ++r) {
            const Four off = mean.y * d.x.of[r] - mean.x * d.y.of[r] - expected;
            most = larger(most, larger(off, -off));
        }
        return largest(most);
    };
    const Real u1 = largest_off(du, mean_v, det), u2 = largest_off(du, mean_u, 0);
    const Real v1 = largest_off(dv, mean_v, 0), v2 = largest_off(dv, mean_u, -det);
    const Real e_det = std::max(u1 + v1, u2 + v2);
    result.one_root_at_most = e_det < std::abs(det);
    result.newton_finds_it = 4 * e_det <= std::abs(det) && result.one_root_at_most;
    return result;
}

/// Newton's method for x = y = 0, kept within the piece. Nothing when the root lies outside of it.
std::optional<Vec2> newton(const Control& whole, const Piece& piece) {
    Vec2 uv = Real(0.5) * (piece.low + piece.high), off(0);
    for (int i = 0; i < 12; ++i) {
        const auto [p, du, dv] = evaluate(whole, uv);
        const Real det = du.x * dv.y - du.y * dv.x;
        const Vec2 target = uv - Vec2(dv.y * p.x - dv.x * p.y, du.x * p.y - du.y * p.x) / det;
        off = glm::abs(target - uv);
        uv = glm::clamp(target, piece.low, piece.high);
        if (off.x + off.y <= 8 * kEpsilon) break;
    }
    // The last step must have been short: it was cut off when the root lies outside. Rounding may keep it above the
    // bound of the loop where the patch is seen nearly edge-on. A NaN is not short.
    return off.x <= kSeam && off.y <= kSeam ? std::optional(uv) : std::nullopt;
}

/// De Casteljau's algorithm at 1/2.
template <class T>
void split_curve(const T (&k)[4], T (&left)[4], T (&right)[4]) {
    const Real half = 0.5;
    const T ab = half * (k[0] + k[1]), bc = half * (k[1] + k[2]), cd = half * (k[2] + k[3]);
    const T abc = half * (ab + bc), bcd = half * (bc + cd), middle = half * (abc + bcd);
    left[0] = k[0], left[1] = ab, left[2] = abc, left[3] = middle;
    right[0] = middle, right[1] = bcd, right[2] = cd, right[3] = k[3];
}

/// Rows become columns.
void transpose(Four (&k)[4]) {
    const Four a = __builtin_shufflevector(k[0], k[1], 0, 4, 2, 6), b = __builtin_shufflevector(k[0], k[1], 1, 5, 3, 7);
    const Four c = __builtin_shufflevector(k[2], k[3], 0, 4, 2, 6), d = __builtin_shufflevector(k[2], k[3], 1, 5, 3, 7);
    k[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    k[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    k[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    k[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

void split(const Rows& k, bool along_u, Rows& left, Rows& right) {
    if (along_u) return split_curve(k.of, left.of, right.of);
    Rows turned = k;
    transpose(turned.of);
    split_curve(turned.of, left.of, right.of);
    transpose(left.of);
    transpose(right.of);
}

void split(const Piece& piece, bool along_u, Piece& left, Piece& right) {
    split(piece.k.x, along_u, left.k.x, right.k.x);
    split(piece.k.y, along_u, left.k.y, right.k.y);
    split(piece.k.z, along_u, left.k.z, right.k.z);
    left.low = right.low = piece.low;
    left.high = right.high = piece.high;
    const int axis = along_u ? 0 : 1;
    left.nearest = smallest(left.k.z.lowest());
    right.nearest = smallest(right.k.z.lowest());
    left.high[axis] = right.low[axis] = Real(0.5) * (piece.low[axis] + piece.high[axis]);
}

/// Depth-first search for the nearest root, near pieces first. A binary split across the longer side also copes with
/// edges that are collapsed to a point, where splitting in four would double the pieces at every level.
class PatchSearch {
public:
    PatchSearch(const Control& seen, Interval depth)
        : whole_(seen),
          depth_(depth),
          size_(std::max({seen.x.largest_size(), seen.y.largest_size(), seen.z.largest_size()})) {}

    struct Found {
        Vec2 uv;
        Real z;
    };
    std::optional<Found> nearest() {
        push(Piece{whole_, Vec2(0), Vec2(1), -kInfinity});
        for (int looked_at = 0; count_ > 0 && looked_at < kMostPieces; ++looked_at) {
            const Piece& piece = stack_[static_cast<std::size_t>(--count_)];  // stays there until halves are pushed
            if (!(piece.nearest < depth_.max)) continue;
            const Stretch size = stretch(piece.k);
            const auto root = size.one_root_at_most ? newton(whole_, piece) : std::nullopt;
            if (root) {
                accept(*root);
            } else if (size.newton_finds_it) {
                continue;
            } else if (std::max(size.u, size.v) <= kPoint * size_) {
                accept(Real(0.5) * (piece.low + piece.high));  // a silhouette, seen edge-on
            } else {
                push_halves(piece, size.u > size.v);
            }
        }
        return found_;
    }

private:
    void accept(Vec2 uv) {
        const Real z = evaluate(whole_, uv).p.z;
        if (!depth_.contains(z)) return;
        depth_.max = z;
        found_ = Found{uv, z};
    }

    void push(const Piece& piece) {
        if (count_ == static_cast<int>(stack_.size()) || !piece.may_meet_ray()) return;
        if (!(largest(piece.k.z.highest()) > depth_.min && piece.nearest < depth_.max)) return;
        stack_[static_cast<std::size_t>(count_++)] = piece;
    }

    void push_halves(const Piece& piece, bool along_u) {
        Piece left, right;
        split(piece, along_u, left, right);
        const bool left_first = left.nearest < right.nearest;  // the nearer one on top
        push(left_first ? right : left);
        push(left_first ? left : right);
    }

    const Control& whole_;
    Interval depth_;  ///< what still counts; `max` comes down with every root
    Real size_;
    std::optional<Found> found_;
    std::array<Piece, 128> stack_;  // one waits a level, and 2 * 60 levels halve u and v down to a rounding error
    int count_ = 0;
};

}  // namespace
//< hidden

void prepare(BicubicPatch& patch) {
    //> 1.11 void The bounding sphere of the control points, once you have written task 1.13.
    patch.bound = bounding_sphere(patch.control);
    //< 1.11
}

std::optional<Root> intersect(const BicubicPatch& patch, const Ray& ray, Interval range) {
    //> 1.11 P(u, v) = o + t d, 0 <= u, v <= 1. Two planes through the ray give two equations in u and v for
    //>   Newton's method; subdivide until it cannot miss: there may be up to 18 roots, two meet at silhouettes.
    if (misses(patch.bound, ray, range)) return std::nullopt;
    const Real length = glm::length(ray.direction);
    if (!(length > 0 && length < kInfinity)) return std::nullopt;
    const Control seen = seen_along(ray, length, patch.control);
    PatchSearch search(seen, {range.min * length, range.max * length});
    const auto found = search.nearest();
    if (!found || !range.contains(found->z / length)) return std::nullopt;
    return Root{found->z / length, found->uv};
    //< 1.11
}

Vec3 normal(const BicubicPatch& patch, const Vec3&, const Root& root) {
    //> 1.11 dP/du x dP/dv; where an edge is collapsed to a point, that of a point close by.
    for (const Real towards_middle : {Real(0), std::sqrt(std::sqrt(kEpsilon))}) {
        const auto at = evaluate(control_of(patch.control), glm::mix(root.uv, Vec2(0.5), towards_middle));
        const Vec3 n = glm::cross(at.du, at.dv);
        if (dot(n, n) > kEpsilon * kEpsilon * dot(at.du, at.du) * dot(at.dv, at.dv)) return n;
    }
    return {1, 0, 0};  // the patch is a point or a line: POV-Ray's choice
    //< 1.11
}

}  // namespace rays
