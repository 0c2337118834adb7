// Holds what a packet finds against what its rays find one by one.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "1_ray_casting/ray_casting.h"
#include "eight.h"
#include "packets/shapes.h"

namespace rays::packets::tests {

using test::Question;
using test::RaysAt;
using test::Special;

/// Eight questions; the longest axis of their directions is the same, or each has its own (triangles know the
/// difference).
struct EightQuestions {
    Lanes<Ray> rays;
    Lanes<Interval> ranges;
};

inline ShearedRays sheared(const Rays& rays) { return {rays, Mask::of(kAllLanes)}; }

class QuestionSource {
public:
    QuestionSource(Special special, std::uint64_t seed) : questions_(std::move(special), seed) {}

    EightQuestions next() {
        for (;;) {
            const Question q = questions_.next();
            const Vec3 size = glm::abs(q.ray.direction);  // as step 1 compares
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            const bool any_way = ++asked_ / 64 % 2 == 1;
            auto& waiting = waiting_[any_way ? 3 : std::size_t(axis)];
            waiting.push_back(q);
            if (waiting.size() < kLanes) continue;
            EightQuestions packet;
            for (std::size_t i = 0; i < kLanes; ++i) {
                packet.rays[i] = waiting[i].ray;
                packet.ranges[i] = waiting[i].range;
            }
            waiting.clear();
            return packet;
        }
    }

private:
    RaysAt questions_;
    std::array<std::vector<Question>, 4> waiting_;
    std::uint64_t asked_ = 0;
};

inline Span together(const Lanes<Interval>& ranges) {
    Lanes<Real> near, far;
    for (std::size_t i = 0; i < kLanes; ++i) {
        near[i] = ranges[i].min;
        far[i] = ranges[i].max;
    }
    return {together(near), together(far)};
}

inline bool same(const std::optional<Root>& a, const std::optional<Root>& b) {
    if (!a || !b) return !a && !b;
    return same(a->t, b->t) && same(a->uv.x, b->uv.x) && same(a->uv.y, b->uv.y) && a->part == b->part;
}
inline std::string text(const std::optional<Root>& root) {
    return root ? fmt::format("t {:.17g} uv {:.17g} {:.17g} part {}", root->t, root->uv.x, root->uv.y, root->part)
                : "miss";
}

/// Packets of hard rays: roots(rays, span) must be what root(ray, range) is, bit by bit. `hit` is called
/// with the rays of a packet, its roots, and a lane that has one.
template <class RootsOf, class RootOf, class Hit>
void expect_same_roots(const std::string& name, const Special& special, RootsOf roots_of, RootOf root_of, Hit hit,
                       int packets = 2500) {
    QuestionSource source(special, 1);
    int hits = 0;
    for (int n = 0; n < packets; ++n) {
        const EightQuestions packet = source.next();
        const Rays rays = together(packet.rays);
        const Roots roots = roots_of(rays, together(packet.ranges));
        const Spread t(roots.t), u(roots.u), v(roots.v), part(roots.part);
        for (int i = 0; i < kLanes; ++i) {
            const Ray& ray = packet.rays[std::size_t(i)];
            const Interval range = packet.ranges[std::size_t(i)];
            std::optional<Root> got;
            if (roots.is.bits() >> i & 1) got = Root{t[i], {u[i], v[i]}, static_cast<std::uint32_t>(part[i])};
            const std::optional<Root> truth = root_of(ray, range);
            ASSERT_TRUE(same(got, truth)) << name << ", packet " << n << ", lane " << i << ", " << text(ray, range)
                                          << ": " << text(got) << " instead of " << text(truth);
            if (!truth) continue;
            ++hits;
            ASSERT_NO_FATAL_FAILURE(hit(rays, roots, ray, *truth, i));
        }
    }
    EXPECT_GT(hits, packets * kLanes / 50) << name << ": the rays look past it";
}

}  // namespace rays::packets::tests
