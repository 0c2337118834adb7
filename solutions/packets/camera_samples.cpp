#include "packets/camera_samples.h"

#include "5_distributed/beyond/sobol.h"

namespace rays::packets {
namespace {

__m256i reversed(__m256i x) {
    // Nibbles by table, then the bytes of each number the other way round.
    const __m256i table =
        _mm256_broadcastsi128_si256(_mm_setr_epi8(0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15));
    const __m256i low = _mm256_set1_epi8(15);
    const __m256i upper = _mm256_slli_epi16(_mm256_shuffle_epi8(table, _mm256_and_si256(x, low)), 4);
    const __m256i lower = _mm256_shuffle_epi8(table, _mm256_and_si256(_mm256_srli_epi16(x, 4), low));
    const __m256i order =
        _mm256_broadcastsi128_si256(_mm_setr_epi8(3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12));
    return _mm256_shuffle_epi8(_mm256_or_si256(upper, lower), order);
}

__m256i all(std::uint32_t x) { return _mm256_set1_epi32(static_cast<int>(x)); }
__m256i times_itself(__m256i x, std::uint32_t factor) {
    return _mm256_xor_si256(x, _mm256_mullo_epi32(x, all(factor)));
}

/// As in step 5.
__m256i turned(__m256i x, std::uint32_t key) {
    x = _mm256_add_epi32(times_itself(x, 0x3d20adeau), all(key));
    x = _mm256_mullo_epi32(x, all(key >> 16 | 1));
    return times_itself(times_itself(x, 0x05526c56u), 0x53a22864u);
}

/// Sobol's second dimension as step 5 has it, its bits reversed.
constexpr std::uint32_t second(std::uint32_t index) {
    std::uint32_t x = index;
    x ^= x >> 1 & 0x55555555u;
    x ^= x >> 2 & 0x33333333u;
    x ^= x >> 4 & 0x0f0f0f0fu;
    x ^= x >> 8 & 0x00ff00ffu;
    return x ^ (x >> 16 & 0x0000ffffu);
}

/// What a dimension makes of the lowest three bits.
struct LowBits {
    alignas(32) std::uint32_t of[kLanes];

    __m256i at(__m256i index) const {
        return _mm256_permutevar8x32_epi32(_mm256_load_si256(reinterpret_cast<const __m256i*>(of)), index);
    }
};
template <class Dimension>
constexpr LowBits low_bits_of(Dimension dimension) {
    LowBits low{};
    for (std::uint32_t i = 0; i < kLanes; ++i) low.of[i] = dimension(i);
    return low;
}
constexpr LowBits kSecond = low_bits_of(second);
constexpr LowBits kThird = low_bits_of([](std::uint32_t i) { return kSobol.at(0, i); });
constexpr LowBits kFourth = low_bits_of([](std::uint32_t i) { return kSobol.at(1, i); });

Reals fraction(__m256i x) {
    const __m256i upper = _mm256_srli_epi32(x, 8);
    const Reals whole(upper);
    return whole * Reals(0x1p-24);
}

/// Sine and cosine of angles within an eighth of the circle, by their series: to the last bit or the one before.
Reals sine(Reals x) {
    const Reals square = x * x;
    Reals sum(-1.0 / 1307674368000);
    for (const double term : {1.0 / 6227020800, -1.0 / 39916800, 1.0 / 362880, -1.0 / 5040, 1.0 / 120, -1.0 / 6})
        sum = fma(sum, square, Reals(term));
    return fma(sum * square, x, x);
}
Reals cosine(Reals x) {
    const Reals square = x * x;
    Reals sum(1.0 / 20922789888000);
    for (const double term :
         {-1.0 / 87178291200, 1.0 / 479001600, -1.0 / 3628800, 1.0 / 40320, -1.0 / 720, 1.0 / 24, -0.5})
        sum = fma(sum, square, Reals(term));
    return fma(sum, square, Reals(1));
}

/// As disc_point of step 5: the larger one is the radius, the other over it an eighth of the circle.
Vec2s disc_points(Vec2s u) {
    const Reals a = Reals(2) * u.x - Reals(1), b = Reals(2) * u.y - Reals(1), zero(0.0);
    const Mask beside = abs(a) > abs(b);
    const Reals radius = select(beside, a, b), other = select(beside, b, a);
    const Reals angle = select(radius == zero, zero, Reals(kPi / 4) * (other / radius));
    const Reals along = radius * cosine(angle), across = radius * sine(angle);
    return {select(beside, along, across), select(beside, across, along)};
}

/// All eight, wanted or not: SampleRays has room for them.
void store(double* to, Reals numbers) { numbers.store_anywhere(to); }
template <class Columns>
void store(Columns* columns, int at, const Vec3s& vectors) {
    for (int a = 0; a < 3; ++a) store(&columns[a][static_cast<std::size_t>(at)], vectors[a]);
}

}  // namespace

SobolPoints::SobolPoints(const Draw& first)
    : first_(first),
      samples_(reversed(_mm256_add_epi32(all(first.sample), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7)))) {}

// Sobol's dimensions are linear: what the common bits of the eight numbers make is computed once and added to what the
// lowest three make, by a table of eight.
Vec2s SobolPoints::of(std::uint32_t dimension) {
    Draw draw = first_;
    if (const std::uint32_t pair = dimension & ~1u; pair != pair_) {
        draw.dimension = pair_ = pair;
        index_ = reversed(turned(samples_, static_cast<std::uint32_t>(key_of(draw))));
        common_ = static_cast<std::uint32_t>(_mm256_cvtsi256_si32(index_)) & ~7u;
    }
    draw.dimension = dimension;
    const std::uint64_t keys = mixed(key_of(draw), 1);
    const auto x = static_cast<std::uint32_t>(keys), y = static_cast<std::uint32_t>(keys >> 32);
    const auto number = [&](std::uint32_t common, const LowBits& low) {
        return _mm256_xor_si256(all(common), low.at(index_));
    };
    if (dimension % 2 == 0)
        return {fraction(reversed(turned(index_, x))), fraction(reversed(turned(number(second(common_), kSecond), y)))};
    return {fraction(reversed(turned(reversed(number(kSobol.at(0, common_), kThird)), x))),
            fraction(reversed(turned(reversed(number(kSobol.at(1, common_), kFourth)), y)))};
}

CameraSamples::CameraSamples(const Scene& scene, const Raster& raster, const Purposes& purposes)
    : scene_(scene), raster_(raster), purposes_(purposes) {
    const Camera& camera = scene.camera;
    axis_ = glm::cross(camera.right, camera.up);
    lens_right_ = glm::normalize(camera.right);
    lens_up_ = glm::normalize(camera.up);
}

/// As camera_ray of step 1.
Rays CameraSamples::camera_rays(int x, int y, Vec2s offset, Vec2s lens) const {
    const Camera& camera = scene_.camera;
    const Reals from_left = (Reals(x + 0.5) + offset.x) / Reals(raster_.width);
    const Reals from_top = (Reals(y + 0.5) + offset.y) / Reals(raster_.height);
    const Reals across = from_left - Reals(0.5), up = Reals(0.5) - from_top;
    const Vec3s on_film = across * Vec3s(camera.right), above = up * Vec3s(camera.up);
    const Vec3s location(camera.location), direction(camera.direction);
    const Rays pinhole = camera.kind == Camera::Kind::orthographic ? Rays(location + on_film + above, direction)
                                                                   : Rays(location, direction + on_film + above);
    return purposes_.lens ? through_lens(pinhole, lens) : pinhole;
}

/// As lens_ray of step 5.
Rays CameraSamples::through_lens(const Rays& pinhole, Vec2s lens) const {
    const Camera& camera = scene_.camera;
    const Vec3s axis(axis_);
    const Reals t = dot(Vec3s(camera.focal_point) - pinhole.origin, axis) / dot(pinhole.direction, axis);
    const Vec3s in_focus = pinhole.origin + t * pinhole.direction;
    const Vec2s disc = disc_points(lens);
    const Reals radius(camera.aperture / 4);
    const Vec3s on_lens = pinhole.origin + (radius * disc.x) * Vec3s(lens_right_) + (radius * disc.y) * Vec3s(lens_up_);
    return {on_lens, in_focus - on_lens};
}

void CameraSamples::add(int x, int y, const Draw& first, int count, SampleRays& rays) const {
    static_assert(SampleRays::kTogether == kLanes);
    SobolPoints sobol(first);
    const auto points = [&](Purpose purpose, std::uint32_t number = 0) {
        return sobol.of(dimension_of(purpose, number, purposes_));
    };
    const int at = rays.count;
    const Vec2s pixel = points(Purpose::pixel);
    const Vec2s offset{pixel.x - Reals(0.5), pixel.y - Reals(0.5)};
    const Rays chosen = camera_rays(x, y, offset, purposes_.lens ? points(Purpose::lens) : Vec2s());
    store(rays.origin, at, chosen.origin);
    store(rays.direction, at, normalize(chosen.direction));
    for (std::uint32_t l = 0; 3 * l < rays.light.size(); ++l) {
        const Light& light = scene_.lights[l];
        Vec3s place(light.location);
        if (light.area) {
            Vec2s u = points(Purpose::light, l);
            if (light.circular) {
                const Vec2s disc = disc_points(u);
                u = {Reals(0.5) * disc.x, Reals(0.5) * disc.y};
            } else {
                u = {u.x - Reals(0.5), u.y - Reals(0.5)};
            }
            place = place + (u.x * Vec3s(light.axis_u) + u.y * Vec3s(light.axis_v));
        }
        store(&rays.light[3 * l], at, place);
    }
    rays.count += count;
}

}  // namespace rays::packets
