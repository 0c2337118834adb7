// Rays of a block of pixels that are on the same level of their trees and in the same media: what is traced together.
#pragma once

#include <algorithm>
#include <cmath>

#include "packets/rays.h"
#include "renderer/packets.h"

namespace rays::packets {

using Number = std::uint8_t;  ///< of a ray in its batch, or of a pixel in its block

/// Numbers of rays, in some order.
struct Numbers {
    int count = 0;
    Number of[Block::kSize];

    void add(Number n) { of[count++] = n; }
    const Number* begin() const { return of; }
    const Number* end() const { return of + count; }
};

/// Up to eight rays of a batch, as lanes see them.
struct Chunk {
    Number of[kLanes];
    unsigned lanes;

    /// The eight from `first` on. Lanes that are left over repeat the last one.
    Chunk(const Numbers& numbers, int first) {
        const int count = std::min(kLanes, numbers.count - first);
        for (int i = 0; i < kLanes; ++i) of[i] = numbers.of[first + std::min(i, count - 1)];
        lanes = (1u << count) - 1;
    }
    Reals load(const double* column) const {
        return {_mm256_setr_pd(column[of[0]], column[of[1]], column[of[2]], column[of[3]]),
                _mm256_setr_pd(column[of[4]], column[of[5]], column[of[6]], column[of[7]])};
    }
    Floats load(const float* column) const {
        return _mm256_setr_ps(column[of[0]], column[of[1]], column[of[2]], column[of[3]], column[of[4]],
                              column[of[5]], column[of[6]], column[of[7]]);
    }
};

/// Vectors and light side by side, component by component.
struct VectorColumns {
    double of[3][Block::kSize];

    Vec3s load(const Chunk& chunk) const { return {chunk.load(of[0]), chunk.load(of[1]), chunk.load(of[2])}; }
    template <class Vectors>
    void set(Number n, const Vectors& v, int lane) {
        of[0][n] = v.x[lane];
        of[1][n] = v.y[lane];
        of[2][n] = v.z[lane];
    }
};
struct LightColumns {
    float of[3][Block::kSize];

    Radiances load(const Chunk& chunk) const { return {chunk.load(of[0]), chunk.load(of[1]), chunk.load(of[2])}; }
    Radiance operator[](Number n) const { return {of[0][n], of[1][n], of[2][n]}; }
    void set(Number n, const Radiance& light) {
        for (int c = 0; c < 3; ++c) of[c][n] = light[c];
    }
    void store(const Chunk& chunk, unsigned lanes, const Radiances& light) {
        alignas(32) float v[3][kLanes];
        light.r.store(v[0]), light.g.store(v[1]), light.b.store(v[2]);
        each_lane(lanes, [&](int i) {
            for (int c = 0; c < 3; ++c) of[c][chunk.of[i]] = v[c][i];
        });
    }
};

struct Batch {
    int count = 0;
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
    Rays load(const Chunk& chunk) const { return {origin.load(chunk), direction.load(chunk)}; }

    /// All of them; rays that go the same way follow each other, unless they do already.
    Numbers in_order(bool sorted) const {
        Numbers all;
        for (int n = 0; n < count && sorted; ++n) all.add(static_cast<Number>(n));
        if (sorted) return all;
        Number way[Block::kSize];
        int begin[33] = {};
        for (int n = 0; n < count; ++n) ++begin[(way[n] = way_of(n)) + 1];
        for (int w = 0; w < 32; ++w) begin[w + 1] += begin[w];
        for (int n = 0; n < count; ++n) all.of[begin[way[n]]++] = static_cast<Number>(n);
        all.count = count;
        return all;
    }

private:
    /// The signs of the direction, and its longest axis.
    Number way_of(int n) const {
        const double x = direction.of[0][n], y = direction.of[1][n], z = direction.of[2][n];
        const double ax = std::abs(x), ay = std::abs(y), az = std::abs(z);
        const int axis = ax >= ay && ax >= az ? 0 : ay >= az ? 1 : 2;
        return static_cast<Number>((x < 0) | (y < 0) << 1 | (z < 0) << 2 | axis << 3);
    }
};

}  // namespace rays::packets
