#include "scene_reader/formula.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "scene_reader/functions.h"

namespace rays::sdl {

namespace {

bool is_true(double value) { return std::abs(value) > 1e-10; }

/// What an operation gives that has no value: no sum of it is finite.
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

int Formula::operands_of(Does does) {
    if (does < Does::add) return 1;
    if (does < Does::choose) return 2;
    if (does <= Does::subscript) return 3;
    return does == Does::draw ? 1 : 0;
}

[[gnu::always_inline]] inline double Formula::compute(Does does, double a, double b, double c) {
    constexpr double kDegree = std::numbers::pi / 180;
    switch (does) {
        case Does::negate: return -a;
        case Does::invert: return is_true(a) ? 0 : 1;
        case Does::add: return a + b;
        case Does::subtract: return a - b;
        case Does::multiply: return a * b;
        case Does::divide: return a / b;  // by 0 it is not finite
        case Does::less: return a < b;
        case Does::greater: return a > b;
        case Does::less_equal: return a <= b || !is_true(a - b);
        case Does::greater_equal: return a >= b || !is_true(a - b);
        case Does::equal: return !is_true(a - b);
        case Does::unequal: return is_true(a - b);
        case Does::both: return is_true(a) && is_true(b);
        case Does::either: return is_true(a) || is_true(b);
        case Does::choose: return is_true(a) ? b : c;
        case Does::subscript:
            if (!(b > -0.5) || !(b + 1e-10 < c)) return kNone;
            return a * c + std::floor(std::max(b + 1e-10, 0.0));
        case Does::abs: return std::abs(a);
        case Does::acos: return std::acos(std::clamp(a, -1.0, 1.0));
        case Does::acosh: return std::acosh(a);
        case Does::asin: return std::asin(std::clamp(a, -1.0, 1.0));
        case Does::asinh: return std::asinh(a);
        case Does::atan: return std::atan(a);
        case Does::atanh: return std::atanh(a);
        case Does::ceil: return std::ceil(a);
        case Does::cos: return std::cos(a);
        case Does::cosh: return std::cosh(a);
        case Does::degrees: return a / kDegree;
        case Does::exp: return std::exp(a);
        case Does::floor: return std::floor(a);
        case Does::integer: return to_int(a);
        case Does::ln: return a > 0 ? std::log(a) : kNone;
        case Does::log: return a > 0 ? std::log10(a) : kNone;
        case Does::radians: return a * kDegree;
        case Does::sin: return std::sin(a);
        case Does::sinh: return std::sinh(a);
        case Does::sqrt: return a < 0 ? kNone : std::sqrt(a);
        case Does::tan: return std::tan(a);
        case Does::tanh: return std::tanh(a);
        case Does::atan2: return std::abs(a) <= 1e-10 && std::abs(b) <= 1e-10 ? kNone : std::atan2(a, b);
        case Does::div: return std::isfinite(a / b) ? to_int(a / b) : kNone;
        case Does::max: return std::max(a, b);
        case Does::min: return std::min(a, b);
        case Does::mod: return std::fmod(a, b);
        case Does::pow: return a == 0 && b == 0 ? kNone : std::pow(a, b);
        default: return kNone;
    }
}

double Formula::constant(Does does, double a, double b, double c) { return compute(does, a, b, c); }

double Formula::call(const Operation& o, const World& world, const double* places) const {
    std::array<double, 56> arguments;
    for (std::size_t i = 0; i < o.c; ++i) {
        arguments[i] = places[operands_[o.b + i]];
        if (!std::isfinite(arguments[i])) return kNone;
    }
    const auto value = (*world.functions[o.a])({arguments.data(), o.c});
    return value ? *value : kNone;
}

namespace {

double element(const Array& array, double index, int component, int count) {
    if (!(index >= 0)) return kNone;
    const Numbers* numbers = array.elements[static_cast<std::size_t>(index)].as<Numbers>();
    return numbers && numbers->count == count ? numbers->at[component] : kNone;
}

}  // namespace

bool Formula::run(const World& world, double* places) const {
    std::copy(constants_.begin(), constants_.end(), places);
    std::copy(world.numbers.begin(), world.numbers.end(), places + constants_.size());
    double* const first = places + constants_.size() + numbers_;
    double* out = first;
    std::array<std::pair<std::uint32_t*, std::uint32_t>, kMostDraws> drawn;  // the streams, as they were
    std::size_t draws = 0;
    const auto vector = [&](std::uint16_t i) {
        return V3(places[operands_[i]], places[operands_[i + 1u]], places[operands_[i + 2u]]);
    };
    const auto put = [&](const V3& v) {
        for (int i = 0; i < 3; ++i) out[i] = v[i];
    };
    for (const Operation& o : operations_) {
        switch (o.does) {
            case Does::element: *out = element(*world.arrays[o.a], places[o.b], o.c % 8, o.c / 8); break;
            case Does::call: *out = call(o, world, places); break;
            case Does::draw: {
                std::uint32_t* stream = random_stream(*world.random, places[o.a]);
                *out = kNone;
                if (!stream || draws == drawn.size()) break;
                drawn[draws++] = {stream, *stream};
                *out = draw_random(*stream);
                break;
            }
            case Does::rotate: put(Affine::rotation(vector(o.a + 3)).vector(vector(o.a))); break;
            case Does::spin: {
                const V3 axis = vector(o.a + 3);
                const bool is_none = axis == V3(0);
                put(is_none ? V3(kNone) : Affine::axis_rotation(axis, places[operands_[o.a + 6u]]).vector(vector(o.a)));
                break;
            }
            case Does::rest: break;
            default: *out = compute(o.does, places[o.a], places[o.b], places[o.c]);
        }
        ++out;
    }
    // Where nothing is infinite on the way, the text has no error to tell.
    const bool is_finite = std::all_of(places + constants_.size(), out, [](double x) { return std::isfinite(x); });
    while (!is_finite && draws > 0) {
        --draws;
        *drawn[draws].first = drawn[draws].second;
    }
    return is_finite;
}

bool Formula::operator()(const World& world, Numbers& result) const {
    std::array<double, kMostPlaces> places;
    if (!run(world, places.data())) return false;
    for (int i = 0; i < 5; ++i) result.at[i] = places[results_[i]];
    result.count = count_;
    return true;
}

std::optional<double> Formula::operator()(std::span<const double> arguments) const {
    std::array<double, kMostPlaces> places;
    if (!run({arguments, {}, functions_, nullptr}, places.data())) return std::nullopt;
    return places[results_[0]];
}

}  // namespace rays::sdl
