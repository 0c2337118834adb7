// Rays of a block of pixels that are on the same level of their trees and in the same media: what is traced together.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "packets/rays.h"
#include "renderer/packets.h"

namespace rays::packets {

using Number = std::uint8_t;  ///< of a ray in its batch, or of a pixel in its block

/// Numbers of rays, in some order.
struct Numbers {
    int count = 0;
    Number of[Block::kSize];

    void add(Number n) { of[count++] = n; }
    void add(const Number (&eight)[kLanes], unsigned which) {
        if (which == kAllLanes) {
            std::memcpy(of + count, eight, kLanes);
            count += kLanes;
        } else {
            each_lane(which, [&](int i) { add(eight[i]); });
        }
    }
    const Number* begin() const { return of; }
    const Number* end() const { return of + count; }
};

/// Moves those out of the list whose property is that of the first.
template <class Property>
void take_alike(Numbers& numbers, Numbers& alike, const Property& property) {
    const auto first = property(numbers.of[0]);
    int taken = 0, left = 0;
    for (int i = 0; i < numbers.count; ++i) {  // both are written, and what left was read: no branch
        const Number n = numbers.of[i];
        const bool is_alike = property(n) == first;
        alike.of[taken] = numbers.of[left] = n;
        taken += is_alike;
        left += !is_alike;
    }
    alike.count = taken;
    numbers.count = left;
}

/// Up to eight rays of a batch, as lanes see them.
struct Chunk {
    Number of[kLanes];
    unsigned lanes;
    bool is_run;  ///< eight that follow each other: they are loaded and stored at once

    /// The eight from `first` on, up to `end`. Lanes that are left over repeat the last one.
    Chunk(const Number* numbers, int first, int end) {
        const int count = std::min(kLanes, end - first);
        if (count == kLanes) {
            std::memcpy(of, numbers + first, kLanes);
            const auto in_a_word = std::bit_cast<std::uint64_t>(of);
            is_run = of[0] <= 256 - kLanes && in_a_word == of[0] * 0x0101010101010101u + 0x0706050403020100u;
        } else {
            for (int i = 0; i < kLanes; ++i) of[i] = numbers[first + std::min(i, count - 1)];
            is_run = false;
        }
        lanes = (1u << count) - 1;
    }
    Reals load(const double* column) const {
        if (is_run) return Reals::load_anywhere(column + of[0]);
        return {column[of[0]], column[of[1]], column[of[2]], column[of[3]],
                column[of[4]], column[of[5]], column[of[6]], column[of[7]]};
    }
    Floats load(const float* column) const {
        if (is_run) return _mm256_loadu_ps(column + of[0]);
        return _mm256_setr_ps(column[of[0]], column[of[1]], column[of[2]], column[of[3]], column[of[4]], column[of[5]],
                              column[of[6]], column[of[7]]);
    }
    void store(float* column, unsigned which, Floats values) const {
        if (is_run && which == kAllLanes) return _mm256_storeu_ps(column + of[0], values.v);
        alignas(32) float v[kLanes];
        values.store(v);
        each_lane(which, [&](int i) { column[of[i]] = v[i]; });
    }
};

/// Calls what(chunk) for the rays of the list, eight by eight.
template <class What>
void each_chunk(const Numbers& numbers, const What& what) {
    for (int first = 0; first < numbers.count; first += kLanes) what(Chunk(numbers.of, first, numbers.count));
}

/// Vectors and light side by side, component by component.
struct VectorColumns {
    double of[3][Block::kSize];

    Vec3s load(const Chunk& chunk) const { return {chunk.load(of[0]), chunk.load(of[1]), chunk.load(of[2])}; }
    /// Eight from `first` on.
    Vec3s load(int first) const {
        return {Reals::load_anywhere(of[0] + first), Reals::load_anywhere(of[1] + first),
                Reals::load_anywhere(of[2] + first)};
    }
    void store(int first, const Vec3s& v) {
        for (int a = 0; a < 3; ++a) v[a].store_anywhere(of[a] + first);
    }
    void store(const Chunk& chunk, const Vec3s& v) {
        if (chunk.is_run) return store(chunk.of[0], v);
        const Spread3 lanes(v);
        each_lane(chunk.lanes, [&](int i) { set(chunk.of[i], lanes, i); });
    }
    template <class Vectors>
    void set(Number n, const Vectors& v, int lane) {
        of[0][n] = v.x[lane];
        of[1][n] = v.y[lane];
        of[2][n] = v.z[lane];
    }
};

/// The ways that eight rays go, from 0 to 7: the signs of their directions.
inline __m256i ways_of(const Vec3s& d) {
    const auto where_back = [](Reals along, int bit) {
        const __m256 yes = _mm256_castsi256_ps(_mm256_set1_epi32(bit));
        return _mm256_castps_si256(select(narrow(along < Reals(0.0)), yes, _mm256_setzero_ps()));
    };
    return _mm256_or_si256(_mm256_or_si256(where_back(d.x, 1), where_back(d.y, 2)), where_back(d.z, 4));
}

/// Calls what(chunk) for rays that go the same way, eight by eight.
template <class What>
void each_chunk_by_way(const VectorColumns& direction, int count, const What& what) {
    constexpr int kWays = 8;
    alignas(32) std::int32_t way[Block::kSize];
    for (int first = 0; first < count; first += kLanes)  // of lanes without a ray, too: they are not looked at
        _mm256_store_si256(reinterpret_cast<__m256i*>(way + first), ways_of(direction.load(first)));
    std::uint16_t counts[kWays] = {}, next[kWays];
    unsigned taken = 0;
    for (int n = 0; n < count; ++n) ++counts[way[n]], taken |= 1u << way[n];
    std::uint16_t begin = 0;
    each_lane(taken, [&](int w) { next[w] = begin, begin = static_cast<std::uint16_t>(begin + counts[w]); });
    Number ordered[Block::kSize];
    for (int n = 0; n < count; ++n) ordered[next[way[n]]++] = static_cast<Number>(n);
    each_lane(taken, [&](int w) {  // next is where the way ends by now
        for (int first = next[w] - counts[w]; first < next[w]; first += kLanes) what(Chunk(ordered, first, next[w]));
    });
}

struct LightColumns {
    float of[3][Block::kSize];

    Radiances load(const Chunk& chunk) const { return {chunk.load(of[0]), chunk.load(of[1]), chunk.load(of[2])}; }
    Radiance operator[](Number n) const { return {of[0][n], of[1][n], of[2][n]}; }
    /// Eight from `first` on; there may be fewer, but never is there less room.
    void multiply(int first, const Radiances& by) {
        const __m256 factor[3] = {by.r.v, by.g.v, by.b.v};
        for (int c = 0; c < 3; ++c)
            _mm256_storeu_ps(of[c] + first, _mm256_mul_ps(_mm256_loadu_ps(of[c] + first), factor[c]));
    }
    void set(Number n, const Radiance& light) {
        for (int c = 0; c < 3; ++c) of[c][n] = light[c];
    }
    /// All of them, to radiances side by side.
    void add_to(Radiance (&sum)[Block::kSize]) const {
        for (int n = 0; n < Block::kSize; n += 4) {
            __m128 r = _mm_loadu_ps(of[0] + n), g = _mm_loadu_ps(of[1] + n), b = _mm_loadu_ps(of[2] + n),
                   none = _mm_setzero_ps();
            _MM_TRANSPOSE4_PS(r, g, b, none);
            const __m128 rgb[4] = {r, g, b, none};
            for (int i = 0; i < 4; ++i) _mm_store_ps(sum[n + i].lane, _mm_add_ps(_mm_load_ps(sum[n + i].lane), rgb[i]));
        }
    }
    void store(const Chunk& chunk, unsigned lanes, const Radiances& light) {
        if (lanes == 0) return;
        chunk.store(of[0], lanes, light.r);
        chunk.store(of[1], lanes, light.g);
        chunk.store(of[2], lanes, light.b);
    }
    /// Eight from `first` on.
    Radiances load(int first) const {
        return {Floats(_mm256_loadu_ps(of[0] + first)), Floats(_mm256_loadu_ps(of[1] + first)),
                Floats(_mm256_loadu_ps(of[2] + first))};
    }
};

struct Batch {
    int count = 0;
    int above = 0;          ///< as in World; the same for all
    int level = 0;          ///< as in Branch; the same for all
    bool straight = false;  ///< as in Branch
    Inside inside;          ///< as in Branch
    VectorColumns origin, direction;
    float weight[Block::kSize];
    Number pixel[Block::kSize];   ///< whose tree it is in
    Number parent[Block::kSize];  ///< the ray of the batch above that it comes from

    Ray ray(Number n) const {
        return {{origin.of[0][n], origin.of[1][n], origin.of[2][n]},
                {direction.of[0][n], direction.of[1][n], direction.of[2][n]}};
    }
    /// Of a batch above.
    void add(const Batch& from, const Chunk& chunk, unsigned which, const Rays& rays, Floats weights) {
        if (which == kAllLanes) {
            origin.store(count, rays.origin);
            direction.store(count, rays.direction);
            _mm256_storeu_ps(weight + count, weights.v);
            std::memcpy(parent + count, chunk.of, kLanes);
            for (const Number n : chunk.of) pixel[count++] = from.pixel[n];
            return;
        }
        const SpreadRays single(rays);
        alignas(32) float w[kLanes];
        weights.store(w);
        each_lane(which, [&](int i) {
            const auto n = static_cast<Number>(count++);
            origin.set(n, single.origin, i);
            direction.set(n, single.direction, i);
            weight[n] = w[i];
            parent[n] = chunk.of[i];
            pixel[n] = from.pixel[chunk.of[i]];
        });
    }
    Rays load(const Chunk& chunk) const { return {origin.load(chunk), direction.load(chunk)}; }
};

}  // namespace rays::packets
