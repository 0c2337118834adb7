// Cones and cylinders, eight rays at once. Step 1 (quadrics.cpp) tells the story; here every branch is a mask.
#include "packets/shapes.h"

namespace rays::packets {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// The part of each ray that is inside, and which surface its ends lie on.
struct Chords {
    Reals enter{-kInfinity}, leave{kInfinity}, enter_part{0.0}, leave_part{0.0};
    Mask are = Mask::of(kAllLanes);

    void start_at(Mask where, Reals u) {
        const Mask later = where & (u > enter);
        enter = select(later, u, enter);
        enter_part = select(later, Reals(0.0), enter_part);
    }
    void stop_at(Mask where, Reals u) {
        const Mask sooner = where & (u < leave);
        leave = select(sooner, u, leave);
        leave_part = select(sooner, Reals(0.0), leave_part);
    }
};

/// Between the planes of base and cap: heights s0 + u ds from 0 to 1.
Chords between_the_ends(Reals s0, Reals ds) {
    const Reals zero(0), inverse = Reals(1) / ds, base = -s0 * inverse, cap = (Reals(1) - s0) * inverse;
    const Mask upwards = ds > zero, level = abs(inverse) == Reals(kInfinity);
    Chords chords;
    chords.are = Mask::of(kAllLanes) - (level - ((s0 >= zero) & (s0 <= Reals(1))));
    chords.enter = select(level, Reals(-kInfinity), select(upwards, base, cap));
    chords.leave = select(level, Reals(kInfinity), select(upwards, cap, base));
    chords.enter_part = select(level, zero, select(upwards, Reals(1), Reals(2)));
    chords.leave_part = select(level, zero, select(upwards, Reals(2), Reals(1)));
    return chords;
}

/// Where the ray is flatter than the mantle, as most are: between the two roots.
void cut_to_round_mantle(Chords& chords, Reals a, Reals b, Reals c) {
    const RootPairs roots = quadratic_roots(a, b, c);
    chords.are = chords.are & roots.are;
    chords.start_at(roots.are, roots.first);
    chords.stop_at(roots.are, roots.second);
}

void cut_to_the_mantle(Chords& chords, const Vec3s& from_axis, const Vec3s& across, Reals radius, Reals widening) {
    const Reals zero(0), across2 = dot(across, across), widening2 = widening * widening;
    const Reals b = dot(from_axis, across) - radius * widening;
    const Reals c = dot(from_axis, from_axis) - radius * radius;
    Reals a = across2 - widening2;
    a = select(abs(a) <= Reals(4 * kEpsilon) * (across2 + widening2), zero, a);
    const Mask round = a > zero;
    if (round.bits() == kAllLanes) return cut_to_round_mantle(chords, a, b, c);
    const Mask flat = a == zero, constant = flat & (b == zero), steep = a < zero;
    RootPairs roots = quadratic_roots(a, b, c);
    const Mask at_apex = steep - roots.are;
    const Reals apex = -b / a;
    roots.first = select(at_apex, apex, roots.first);
    roots.second = select(at_apex, apex, roots.second);
    chords.are = chords.are & (roots.are | at_apex | constant) & ((Mask::of(kAllLanes) - constant) | (c <= zero));

    const Reals only = -c / (Reals(2) * b);
    const Mask linear = flat - constant, starts = linear & (b < zero), widens = widening > zero;
    chords.start_at(round | (steep & widens) | starts, select(starts, only, select(round, roots.first, roots.second)));
    chords.stop_at(round | (steep - widens) | (linear - starts),
                   select(linear, only, select(round, roots.second, roots.first)));
}

}  // namespace

Roots intersect(const Cone& cone, const Rays& rays, const Span& span) {
    const Vec3 axis = cone.cap - cone.base;
    const Reals inverse_height2(1 / glm::dot(axis, axis));
    const Vec3s axes(axis), base(cone.base);
    const Reals shift =
        dot(Vec3s(cone.base + Real(0.5) * axis) - rays.origin, rays.direction) * rays.inverse_direction2;
    const Vec3s from_base = rays.at(shift) - base;
    const Reals s0 = dot(from_base, axes) * inverse_height2, ds = dot(rays.direction, axes) * inverse_height2;
    const Reals slope(cone.cap_radius - cone.base_radius);
    Chords chords = between_the_ends(s0, ds);
    if (!chords.are.any()) return Roots::none();
    cut_to_the_mantle(chords, from_base - s0 * axes, rays.direction - ds * axes, Reals(cone.base_radius) + slope * s0,
                      slope * ds);
    const Mask are = chords.are & (chords.enter <= chords.leave);
    if (!are.any()) return Roots::none();
    const Reals enter = shift + chords.enter, leave = shift + chords.leave;
    Mask enters = span.contains(enter), leaves = span.contains(leave);
    if (cone.open) {
        enters = enters & (chords.enter_part == Reals(0));
        leaves = leaves & (chords.leave_part == Reals(0));
    }
    return {are & (enters | leaves), select(enters, enter, leave), Reals(0.0), Reals(0.0),
            select(enters, chords.enter_part, chords.leave_part)};
}

Vec3s normal(const Cone& cone, const Vec3s& point, Reals part) {
    const Vec3 axis = cone.cap - cone.base;
    const Vec3s axes(axis), from_base = point - Vec3s(cone.base);
    const Real inverse_height2 = 1 / glm::dot(axis, axis), slope = cone.cap_radius - cone.base_radius;
    const Reals s = dot(from_base, axes) * Reals(inverse_height2);
    const Vec3s from_axis = from_base - s * axes;
    const Vec3s gradient =
        from_axis - ((Reals(cone.base_radius) + Reals(slope) * s) * Reals(slope * inverse_height2)) * axes;
    const Vec3s mantle = select(dot(gradient, gradient) > Reals(0), gradient, Vec3s(slope > 0 ? -axis : axis));
    return select(part == Reals(1), Vec3s(-axis), select(part == Reals(2), axes, mantle));
}

}  // namespace rays::packets
