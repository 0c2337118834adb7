#include "grader/statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "grader/student_t.h"
#include "grader/tile_samples.h"

namespace rays::grader {
namespace {

constexpr double kMostZ = 999;
constexpr double kMostFreedom = 1e6;
/// A channel that is hardly there is judged by the picture's colours: a tenth of their mean counts as its level.
constexpr double kFaintChannel = 0.1;

bool finite(const Rgb& c) { return std::isfinite(c[0]) && std::isfinite(c[1]) && std::isfinite(c[2]); }

int count_not_finite(const Pictures& pictures) {
    int count = 0;
    for (const RgbImage& picture : pictures)
        count += static_cast<int>(
            std::count_if(picture.pixels.begin(), picture.pixels.end(), [](const Rgb& p) { return !finite(p); }));
    return count;
}

void check_sizes(const Pictures& pictures, const AveragedReference& truth) {
    const Raster& raster = truth.mean.raster;
    const auto fits = [&](const RgbImage& i) {
        return i.raster.width == raster.width && i.raster.height == raster.height &&
               i.pixels.size() == truth.mean.pixels.size();
    };
    if (pictures.size() < 2) throw std::invalid_argument("statistics need at least two pictures");
    if (truth.mean.pixels.empty() || !fits(truth.error) || !std::all_of(pictures.begin(), pictures.end(), fits))
        throw std::invalid_argument("pictures and reference have different sizes");
}

/// Values of t by degrees of freedom, for one chance. Rounding those down makes t larger, never smaller.
class Limits {
public:
    explicit Limits(double alpha) : alpha_(alpha) {}
    double at(double freedom) {
        const double f = rounded_down(freedom);
        const auto known = known_.find(f);
        return known != known_.end() ? known->second : known_[f] = student_t_limit(alpha_, f);
    }

private:
    static double rounded_down(double f) {
        if (f < 30) return std::max(1.0, std::floor(f));
        return std::exp2(std::floor(std::log2(f) * 8) / 8);
    }
    double alpha_;
    std::map<double, double> known_;
};

class Examiner {
public:
    Examiner(const Pictures& pictures, const AveragedReference& truth, const BiasOptions& options)
        : pictures_(pictures), truth_(truth), options_(options), tiles_(pictures, truth, options.tile) {
        const Raster raster = truth.mean.raster;
        for (std::size_t c = 0; c < 3; ++c)
            whole_[c] = sample_of({0, 0, raster.width, raster.height}, pictures, truth, c);
        for (const Rectangle& r : tiles_.rectangles()) result_.tiles.push_back({r.x, r.y, r.width, r.height});
        result_.seeds = static_cast<int>(pictures.size());
    }

    Examination run(const std::vector<Suspect>& suspects) {
        // Tiles and the whole picture share the rate: half of it for each.
        const double half = sidak(options_.alarm_rate, 2);
        const auto of_whole = static_cast<int>(
            std::count_if(suspects.begin(), suspects.end(), [](const Suspect& s) { return s.tile < 0; }));
        result_.whole_tests = suspects.empty() ? 3 : of_whole;
        result_.tile_tests =
            suspects.empty() ? 3 * static_cast<int>(tiles_.count()) : static_cast<int>(suspects.size()) - of_whole;
        Limits for_tiles(sidak(half, result_.tile_tests)), for_whole(sidak(half, result_.whole_tests));
        for (std::size_t c = 0; c < 3; ++c) judge_channel(c, for_tiles, for_whole);
        if (!suspects.empty()) keep_only(suspects);
        find_worst();
        measure_noise();
        return std::move(result_);
    }

private:
    double seeds() const { return double(pictures_.size()); }

    double level(std::size_t channel) const {
        double all = 0;
        for (const Sample& s : whole_) all += std::abs(s.reference) / 3;
        return std::max(std::abs(whole_[channel].reference), kFaintChannel * all);
    }

    void judge_channel(std::size_t c, Limits& for_tiles, Limits& for_whole) {
        const double picture_level = level(c);
        for (std::size_t tile = 0; tile < tiles_.count(); ++tile) {
            const Sample& s = tiles_.sample(tile, c);
            result_.tiles[tile].channels[c] =
                judged(s, options_.tile_margin * std::max(std::abs(s.reference), picture_level), seeds(),
                       tiles_.variances(tile, c), for_tiles);
        }
        result_.whole[c] = judged(whole_[c], options_.whole_margin * picture_level, seeds(),
                                  {{whole_[c].variance, seeds() - 1}}, for_whole);
    }

    static Difference judged(const Sample& s, double margin, double seeds, const std::vector<Variance>& variances,
                             Limits& limits) {
        Difference d;
        d.value = s.difference;
        d.reference = s.reference;
        d.margin = margin;
        double allowed = -1;
        for (const Variance& v : variances) {
            const double own = v.value / seeds, known = s.error * s.error;
            const double error = std::sqrt(own + known);
            const double freedom = own > 0
                                       ? std::min(kMostFreedom, v.freedom * (own + known) * (own + known) / (own * own))
                                       : kMostFreedom;
            const double limit = limits.at(freedom);
            if (limit * error <= allowed) continue;
            allowed = limit * error;
            d.standard_error = error;
            d.freedom = freedom;
            d.limit = limit;
        }
        const double beyond = std::max(0.0, std::abs(d.value) - d.margin);
        d.z = beyond == 0 ? 0 : std::copysign(std::min(kMostZ, beyond / d.standard_error), d.value);
        d.wrong = !(std::abs(d.value) - d.margin <= allowed);
        return d;
    }

    void keep_only(const std::vector<Suspect>& suspects) {
        std::vector<Suspect> confirmed;
        for (const Suspect& s : suspects)
            if (result_.of(s).wrong && (result_.of(s).value > 0) == s.too_bright) confirmed.push_back(s);
        for (Tile& t : result_.tiles)
            for (Difference& d : t.channels) d.wrong = false;
        for (Difference& d : result_.whole) d.wrong = false;
        for (const Suspect& s : confirmed) const_cast<Difference&>(result_.of(s)).wrong = true;
    }

    void find_worst() {
        double worst = -1;
        for (std::size_t i = 0; i < result_.tiles.size(); ++i) {
            const auto& channels = result_.tiles[i].channels;
            result_.tiles_wrong += channels[0].wrong || channels[1].wrong || channels[2].wrong;
            for (std::size_t c = 0; c < 3; ++c) {
                // What is wrong comes first, then what is nearest to it.
                const Difference& d = channels[c];
                const double rank = (d.wrong ? 1e6 : 0) + std::abs(d.z) / d.limit;
                if (rank <= worst) continue;
                worst = rank;
                result_.worst_tile = static_cast<int>(i);
                result_.worst_channel = c;
            }
        }
    }

    void measure_noise() {
        double of_pixels = 0, of_tiles = 0;
        for (std::size_t i = 0; i < truth_.mean.pixels.size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                double sum = 0, squares = 0;
                for (const RgbImage& p : pictures_) sum += double(p.pixels[i][c]);
                const double mean = sum / double(pictures_.size());
                for (const RgbImage& p : pictures_)
                    squares += (double(p.pixels[i][c]) - mean) * (double(p.pixels[i][c]) - mean);
                of_pixels += squares / (seeds() - 1);
            }
        }
        for (std::size_t t = 0; t < result_.tiles.size(); ++t) {
            const double pixels = double(result_.tiles[t].width) * result_.tiles[t].height;
            for (std::size_t c = 0; c < 3; ++c) of_tiles += tiles_.sample(t, c).variance * pixels * pixels;
        }
        result_.mean_variance = of_pixels / (3 * double(truth_.mean.pixels.size()));
        result_.shared_noise = of_pixels > 0 ? of_tiles / of_pixels : 0;
    }

    const Pictures& pictures_;
    const AveragedReference& truth_;
    const BiasOptions& options_;
    TileSamples tiles_;
    std::array<Sample, 3> whole_;
    Examination result_;
};

}  // namespace

std::vector<Suspect> Examination::suspects() const {
    std::vector<Suspect> list;
    for (std::size_t c = 0; c < 3; ++c)
        if (whole[c].wrong) list.push_back({-1, c, whole[c].value > 0});
    for (std::size_t t = 0; t < tiles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c)
            if (tiles[t].channels[c].wrong) list.push_back({static_cast<int>(t), c, tiles[t].channels[c].value > 0});
    return list;
}

const Difference& Examination::of(const Suspect& s) const {
    return s.tile < 0 ? whole[s.channel] : tiles[static_cast<std::size_t>(s.tile)].channels[s.channel];
}

Examination examine(const Pictures& pictures, const AveragedReference& truth, const BiasOptions& options,
                    const std::vector<Suspect>& suspects) {
    check_sizes(pictures, truth);
    if (const int bad = count_not_finite(pictures)) {
        Examination result;
        result.seeds = static_cast<int>(pictures.size());
        result.not_finite = bad;
        return result;
    }
    return Examiner(pictures, truth, options).run(suspects);
}

RgbImage mean_of(const Pictures& pictures) {
    RgbImage mean = pictures.front();
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0;
            for (const RgbImage& p : pictures) sum += double(p.pixels[i][c]);
            mean.pixels[i][c] = static_cast<float>(sum / double(pictures.size()));
        }
    }
    return mean;
}

RgbImage z_picture(const Examination& examination, Raster raster) {
    RgbImage picture{
        raster, std::vector<Rgb>(static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height))};
    for (const Tile& t : examination.tiles)
        for (int y = t.y; y < t.y + t.height; ++y)
            for (int x = t.x; x < t.x + t.width; ++x)
                for (std::size_t c = 0; c < 3; ++c) picture.at(x, y)[c] = static_cast<float>(t.channels[c].z);
    return picture;
}

bool all_equal(const Pictures& pictures) {
    return std::all_of(pictures.begin(), pictures.end(),
                       [&](const RgbImage& p) { return p.pixels == pictures.front().pixels; });
}

}  // namespace rays::grader
