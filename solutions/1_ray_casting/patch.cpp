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

using Control = std::array<Vec3, 16>;

Vec3 lerp_cubic(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, Real t) {
    const Real s = 1 - t;
    return (s * s * s) * a + (3 * s * s * t) * b + (3 * s * t * t) * c + (t * t * t) * d;
}
Vec3 slope_cubic(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, Real t) {
    const Real s = 1 - t;
    return (3 * s * s) * (b - a) + (6 * s * t) * (c - b) + (3 * t * t) * (d - c);
}

struct PatchPoint {
    Vec3 p, du, dv;
};

PatchPoint evaluate(const Control& k, Vec2 uv) {
    std::array<Vec3, 4> along, slope;  // one curve in v for each row
    for (std::size_t i = 0; i < 4; ++i) {
        along[i] = lerp_cubic(k[4 * i], k[4 * i + 1], k[4 * i + 2], k[4 * i + 3], uv.y);
        slope[i] = slope_cubic(k[4 * i], k[4 * i + 1], k[4 * i + 2], k[4 * i + 3], uv.y);
    }
    return {lerp_cubic(along[0], along[1], along[2], along[3], uv.x),
            slope_cubic(along[0], along[1], along[2], along[3], uv.x),
            lerp_cubic(slope[0], slope[1], slope[2], slope[3], uv.x)};
}

/// The control points as the ray sees them: x and y across it, z along it. The ray is the line x = y = 0, the common
/// line of two planes (Kajiya, "Ray Tracing Parametric Patches", SIGGRAPH 1982).
Control seen_along(const Ray& ray, Real length, const Control& control) {
    const Vec3 w = ray.direction / length;
    // An orthonormal frame (Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017).
    const Real sign = std::copysign(Real(1), w.z), a = -1 / (sign + w.z), b = w.x * w.y * a;
    const Vec3 x(1 + sign * w.x * w.x * a, sign * b, -sign * w.x), y(b, sign + w.y * w.y * a, -w.y);
    Control seen;
    for (std::size_t i = 0; i < 16; ++i) {
        const Vec3 p = control[i] - ray.origin;
        seen[i] = {dot(p, x), dot(p, y), dot(p, w)};
    }
    return seen;
}

struct Range {
    Real low = kInfinity, high = -kInfinity;

    void include(Real x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
    bool has_zero() const { return low <= 0 && high >= 0; }
};

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
        Range x, y, along_u, along_v;
        const Vec3 du = k[12] + k[15] - k[0] - k[3], dv = k[3] + k[15] - k[0] - k[12];
        for (const Vec3& p : k) {
            x.include(p.x);
            y.include(p.y);
            along_u.include(du.x * p.y - du.y * p.x);
            along_v.include(dv.x * p.y - dv.y * p.x);
        }
        return x.has_zero() && y.has_zero() && along_u.has_zero() && along_v.has_zero();
    }
};

/// How a piece stretches: the differences of its control points are those of its derivatives.
struct Stretch {
    Real u = 0, v = 0;             ///< the longest, in space: which way to split, when to stop
    bool one_root_at_most = false;
    bool newton_finds_it = false;  ///< from any start in the piece; so if it finds none, there is none
};

Real largest(const Vec3& d) { return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}); }

/// Let M be the inverse of the mean Jacobian of (x, y), and e the largest |M J - I| on the piece. For e < 1, (x, y) is
/// one-to-one. For e <= 1/4 a Newton step ends nearer to the root by a factor 2 e / (1 - e) < 1, soon quadratically.
/// By the convex hull property it is enough to look at the control points of the derivatives. (In the spirit of Toth,
/// "On Ray Tracing Parametric Surfaces", SIGGRAPH 1985, who certifies Newton's method by intervals.)
Stretch stretch(const Control& k) {
    std::array<Vec3, 12> du, dv;
    Stretch result;
    Vec3 mean_u(0), mean_v(0);
    for (std::size_t i = 0, n = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 4; ++j, ++n) {
            du[n] = k[4 * (i + 1) + j] - k[4 * i + j];
            dv[n] = k[4 * j + i + 1] - k[4 * j + i];
            mean_u += du[n];
            mean_v += dv[n];
            result.u = std::max(result.u, largest(du[n]));
            result.v = std::max(result.v, largest(dv[n]));
        }
    }
    mean_u *= Real(1) / 12;
    mean_v *= Real(1) / 12;
    // M = [v.y -v.x; -u.y u.x] / det: the rows of M du - (1, 0) and M dv - (0, 1), times det.
    const Real det = mean_u.x * mean_v.y - mean_u.y * mean_v.x;
    Real u1 = 0, u2 = 0, v1 = 0, v2 = 0;
    for (std::size_t n = 0; n < 12; ++n) {
        u1 = std::max(u1, std::abs(mean_v.y * du[n].x - mean_v.x * du[n].y - det));
        u2 = std::max(u2, std::abs(mean_u.x * du[n].y - mean_u.y * du[n].x));
        v1 = std::max(v1, std::abs(mean_v.y * dv[n].x - mean_v.x * dv[n].y));
        v2 = std::max(v2, std::abs(mean_u.x * dv[n].y - mean_u.y * dv[n].x - det));
    }
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

/// De Casteljau's algorithm at 1/2 for the four points at first, first + step, ...
void split_curve(const Control& k, Control& left, Control& right, std::size_t first, std::size_t step) {
    const Vec3 a = k[first], b = k[first + step], c = k[first + 2 * step], d = k[first + 3 * step];
    const Real half = 0.5;
    const Vec3 ab = half * (a + b), bc = half * (b + c), cd = half * (c + d);
    const Vec3 abc = half * (ab + bc), bcd = half * (bc + cd), middle = half * (abc + bcd);
    left[first] = a, left[first + step] = ab, left[first + 2 * step] = abc, left[first + 3 * step] = middle;
    right[first] = middle, right[first + step] = bcd, right[first + 2 * step] = cd, right[first + 3 * step] = d;
}

void split(const Piece& piece, bool along_u, Piece& left, Piece& right) {
    for (std::size_t i = 0; i < 4; ++i) split_curve(piece.k, left.k, right.k, along_u ? i : 4 * i, along_u ? 4 : 1);
    left.low = right.low = piece.low;
    left.high = right.high = piece.high;
    const int axis = along_u ? 0 : 1;
    left.high[axis] = right.low[axis] = Real(0.5) * (piece.low[axis] + piece.high[axis]);
}

/// Depth-first search for the nearest root, near pieces first. A binary split across the longer side also copes with
/// edges that are collapsed to a point, where splitting in four would double the pieces at every level.
class PatchSearch {
public:
    PatchSearch(const Control& seen, Range depth) : whole_(seen), depth_(depth) {
        for (const Vec3& p : seen) size_ = std::max(size_, largest(p));
    }

    struct Found {
        Vec2 uv;
        Real z;
    };
    std::optional<Found> nearest() {
        push(Piece{whole_, Vec2(0), Vec2(1), 0});
        for (int looked_at = 0; count_ > 0 && looked_at < kMostPieces; ++looked_at) {
            const Piece piece = stack_[static_cast<std::size_t>(--count_)];
            if (!(piece.nearest < depth_.high)) continue;
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
        if (!(z > depth_.low && z < depth_.high)) return;
        depth_.high = z;
        found_ = Found{uv, z};
    }

    void push(const Piece& piece) {
        if (count_ == static_cast<int>(stack_.size()) || !piece.may_meet_ray()) return;
        Range z;
        for (const Vec3& p : piece.k) z.include(p.z);
        if (!(z.high > depth_.low && z.low < depth_.high)) return;
        Piece& top = stack_[static_cast<std::size_t>(count_++)];
        top = piece;
        top.nearest = z.low;
    }

    void push_halves(const Piece& piece, bool along_u) {
        Piece left, right;
        split(piece, along_u, left, right);
        const int before = count_;
        push(left);
        push(right);
        if (count_ == before + 2) {  // the nearer one on top
            auto& top = stack_[static_cast<std::size_t>(before + 1)];
            auto& below = stack_[static_cast<std::size_t>(before)];
            if (below.nearest < top.nearest) std::swap(top, below);
        }
    }

    const Control& whole_;
    Range depth_;  ///< what still counts; `high` comes down with every root
    Real size_ = 0;
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
        const auto at = evaluate(patch.control, glm::mix(root.uv, Vec2(0.5), towards_middle));
        const Vec3 n = glm::cross(at.du, at.dv);
        if (dot(n, n) > kEpsilon * kEpsilon * dot(at.du, at.du) * dot(at.dv, at.dv)) return n;
    }
    return {1, 0, 0};  // the patch is a point or a line: POV-Ray's choice
    //< 1.11
}

}  // namespace rays
