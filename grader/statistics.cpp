#include "grader/statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "grader/student_t.h"

namespace rays::grader {
namespace {

constexpr double kMostZ = 999;
constexpr double kMostFreedom = 1e6;
/// A channel that is hardly there is judged by the picture's colours: a tenth of their mean counts as its level.
constexpr double kFaintChannel = 0.1;
/// Tiles each way whose variance a tile is also given; the far ones where light is so rare that fewer events than
/// these, a tile in a seed, carry all variance there. Measured: with the near ones alone, fireflies of 600 times the
/// level that come to one sample in 50 000 are missed by all, twice, in 0.15 % of gradings; with the far ones
/// everywhere, a square that is 10 % too dark among edges is seen in 51 % instead of 74 %.
constexpr int kNear = 1, kFar = 2;
constexpr double kFewEvents = 10;

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

/// A variance that was estimated, and how well.
struct Estimate {
    double variance = 0, freedom = 1;
};

/// The mean of variances that all have the same degrees of freedom (Satterthwaite).
Estimate mean_of(const std::vector<double>& variances, double freedom_of_each) {
    double sum = 0, squares = 0;
    for (const double v : variances) sum += v, squares += v * v;
    if (!(squares > 0)) return {0, freedom_of_each};
    return {sum / double(variances.size()), freedom_of_each * sum * sum / squares};
}

/// Over the seeds, of a tile or the whole picture in one channel.
struct Sample {
    double difference = 0, reference = 0, error = 0;
    double variance = 0;       ///< of a seed's mean
    double fourth_powers = 0;  ///< sum over the seeds of their differences from the mean
};

Sample sample_of(const std::vector<double>& means, double reference, double error) {
    const double count = double(means.size());
    double sum = 0, squares = 0;
    for (const double m : means) sum += m - reference;
    const double difference = sum / count;
    double fourth_powers = 0;
    for (const double m : means) {
        const double square = (m - reference - difference) * (m - reference - difference);
        squares += square;
        fourth_powers += square * square;
    }
    return {difference, reference, error, squares / (count - 1), fourth_powers};
}

/// All sums of one rectangle.
class Area {
public:
    Area(int x, int y, int width, int height) : x_(x), y_(y), width_(width), height_(height) {}

    template <class F>
    void each_pixel(F f) const {
        for (int y = y_; y < y_ + height_; ++y)
            for (int x = x_; x < x_ + width_; ++x) f(x, y);
    }
    double mean(const RgbImage& image, std::size_t channel) const {
        double sum = 0;
        each_pixel([&](int x, int y) { sum += double(image.at(x, y)[channel]); });
        return sum / (double(width_) * height_);
    }
    Sample sample(const Pictures& pictures, const AveragedReference& truth, std::size_t channel) const {
        std::vector<double> means;
        for (const RgbImage& p : pictures) means.push_back(mean(p, channel));
        return sample_of(means, mean(truth.mean, channel), mean(truth.error, channel));
    }

private:
    int x_, y_, width_, height_;
};

class Examiner {
public:
    Examiner(const Pictures& pictures, const AveragedReference& truth, const BiasOptions& options)
        : pictures_(pictures),
          truth_(truth),
          options_(options),
          raster_(truth.mean.raster),
          columns_((raster_.width + options.tile - 1) / options.tile),
          rows_((raster_.height + options.tile - 1) / options.tile) {
        result_.seeds = static_cast<int>(pictures.size());
    }

    Examination run(const std::vector<Suspect>& suspects) {
        take_samples();
        // Tiles and the whole picture share the rate: half of it for each.
        const double half = sidak(options_.alarm_rate, 2);
        const auto of_whole = static_cast<int>(
            std::count_if(suspects.begin(), suspects.end(), [](const Suspect& s) { return s.tile < 0; }));
        result_.whole_tests = suspects.empty() ? 3 : of_whole;
        result_.tile_tests = suspects.empty() ? 3 * columns_ * rows_ : static_cast<int>(suspects.size()) - of_whole;
        Limits for_tiles(sidak(half, result_.tile_tests)), for_whole(sidak(half, result_.whole_tests));
        for (std::size_t c = 0; c < 3; ++c) judge_channel(c, for_tiles, for_whole);
        if (!suspects.empty()) keep_only(suspects);
        find_worst();
        measure_noise();
        return std::move(result_);
    }

private:
    double seeds() const { return double(pictures_.size()); }
    double freedom() const { return seeds() - 1; }
    std::size_t tile_index(int column, int row) const { return static_cast<std::size_t>(row * columns_ + column); }

    void take_samples() {
        for (int row = 0; row < rows_; ++row) {
            for (int column = 0; column < columns_; ++column) {
                Tile tile{column * options_.tile, row * options_.tile, options_.tile, options_.tile};
                tile.width = std::min(tile.width, raster_.width - tile.x);
                tile.height = std::min(tile.height, raster_.height - tile.y);
                const Area area(tile.x, tile.y, tile.width, tile.height);
                for (std::size_t c = 0; c < 3; ++c) samples_[c].push_back(area.sample(pictures_, truth_, c));
                result_.tiles.push_back(tile);
            }
        }
        const Area all(0, 0, raster_.width, raster_.height);
        for (std::size_t c = 0; c < 3; ++c) whole_[c] = all.sample(pictures_, truth_, c);
    }

    double level(std::size_t channel) const {
        double all = 0;
        for (const Sample& s : whole_) all += std::abs(s.reference) / 3;
        return std::max(std::abs(whole_[channel].reference), kFaintChannel * all);
    }

    template <class F>
    void each_near(int column, int row, int reach, F f) const {
        for (int r = std::max(0, row - reach); r <= std::min(rows_ - 1, row + reach); ++r)
            for (int c = std::max(0, column - reach); c <= std::min(columns_ - 1, column + reach); ++c)
                f(tile_index(c, r));
    }

    Estimate of_neighbourhood(std::size_t channel, int column, int row, int reach) const {
        std::vector<double> variances;
        each_near(column, row, reach, [&](std::size_t tile) { variances.push_back(samples_[channel][tile].variance); });
        return mean_of(variances, freedom());
    }

    /// As many equal ones would have the same squares and fourth powers as what the seeds' tiles show around here.
    double events(std::size_t channel, int column, int row) const {
        double squares = 0, fourth_powers = 0;
        each_near(column, row, kFar, [&](std::size_t tile) {
            squares += samples_[channel][tile].variance * freedom();
            fourth_powers += samples_[channel][tile].fourth_powers;
        });
        return fourth_powers > 0 ? squares * squares / fourth_powers : kFewEvents;
    }

    std::vector<Estimate> estimates(std::size_t channel, int column, int row) const {
        std::vector<Estimate> all{{samples_[channel][tile_index(column, row)].variance, freedom()},
                                  of_neighbourhood(channel, column, row, kNear)};
        if (events(channel, column, row) < kFewEvents) all.push_back(of_neighbourhood(channel, column, row, kFar));
        return all;
    }

    void judge_channel(std::size_t c, Limits& for_tiles, Limits& for_whole) {
        const double picture_level = level(c);
        for (int row = 0; row < rows_; ++row) {
            for (int column = 0; column < columns_; ++column) {
                const Sample& s = samples_[c][tile_index(column, row)];
                result_.tiles[tile_index(column, row)].channels[c] =
                    judged(s, options_.tile_margin * std::max(std::abs(s.reference), picture_level), seeds(),
                           estimates(c, column, row), for_tiles);
            }
        }
        result_.whole[c] = judged(whole_[c], options_.whole_margin * picture_level, seeds(),
                                  {{whole_[c].variance, freedom()}}, for_whole);
    }

    static Difference judged(const Sample& s, double margin, double seeds, const std::vector<Estimate>& estimates,
                             Limits& limits) {
        Difference d;
        d.value = s.difference;
        d.reference = s.reference;
        d.margin = margin;
        double allowed = -1;
        for (const Estimate& e : estimates) {
            const double own = e.variance / seeds, known = s.error * s.error;
            const double error = std::sqrt(own + known);
            const double freedom = own > 0
                                       ? std::min(kMostFreedom, e.freedom * (own + known) * (own + known) / (own * own))
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
                of_pixels += squares / freedom();
            }
        }
        for (std::size_t t = 0; t < result_.tiles.size(); ++t) {
            const double pixels = double(result_.tiles[t].width) * result_.tiles[t].height;
            for (std::size_t c = 0; c < 3; ++c) of_tiles += samples_[c][t].variance * pixels * pixels;
        }
        result_.mean_variance = of_pixels / (3 * double(truth_.mean.pixels.size()));
        result_.shared_noise = of_pixels > 0 ? of_tiles / of_pixels : 0;
    }

    const Pictures& pictures_;
    const AveragedReference& truth_;
    const BiasOptions& options_;
    Raster raster_;
    int columns_, rows_;
    std::array<std::vector<Sample>, 3> samples_;  ///< a tile
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
