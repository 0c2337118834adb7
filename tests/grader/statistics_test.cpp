// Noisy pictures: exact numbers of small examples, and that what is promised of tiles, margins and batches holds.
#include "grader/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "grader/statistical_verdict.h"
#include "grader/statistical_words.h"
#include "grader/student_t.h"
#include "tools.h"

namespace rays::grader {
namespace {

RgbImage flat(float value, int width = 24, int height = 16) {
    return {{width, height}, std::vector<Rgb>(static_cast<std::size_t>(width * height), Rgb{value, value, value})};
}

AveragedReference truth_of(float mean, float error = 0) { return {flat(mean), flat(error)}; }

/// K pictures around `mean` that are off by `spread` times -1, 1, -1, 1, ...
Pictures alternating(float mean, float spread, int seeds = 8) {
    Pictures pictures;
    for (int i = 0; i < seeds; ++i) pictures.push_back(flat(mean + (i % 2 ? spread : -spread)));
    return pictures;
}

void add(RgbImage& picture, int x0, int y0, int size, float value) {
    for (int y = y0; y < y0 + size; ++y)
        for (int x = x0; x < x0 + size; ++x)
            for (float& v : picture.at(x, y)) v += value;
}

/// One batch, any margin.
BiasOptions options(double margin = 0.01, double rate = 0.05) { return {8, margin, margin, rate}; }

const Difference& green(const Examination& e, std::size_t tile) { return e.tiles.at(tile).channels[1]; }

// Tables: Abramowitz and Stegun 26.10, and closed forms for 1 and 2 degrees of freedom.
TEST(StudentT, AgreesWithTablesAndClosedForms) {
    EXPECT_NEAR(student_t_limit(0.05, 7), 2.365, 5e-4);
    EXPECT_NEAR(student_t_limit(0.01, 7), 3.499, 5e-4);
    EXPECT_NEAR(student_t_limit(0.001, 15), 4.073, 5e-4);
    EXPECT_NEAR(student_t_limit(0.05, 1e7), 1.959964, 1e-5);
    for (const double t : {0.1, 1.0, 30.0, 1e4}) {
        EXPECT_NEAR(student_t_above(t, 1) / (std::atan(1 / t) / M_PI), 1, 1e-10) << t;
        const double root = std::sqrt(2 + t * t);
        EXPECT_NEAR(student_t_above(t, 2) / (1 / (root * (root + t))), 1, 1e-9) << t;
    }
    EXPECT_DOUBLE_EQ(student_t_above(0, 5), 0.5);
    EXPECT_NEAR(student_t_above(-1.5, 5) + student_t_above(1.5, 5), 1, 1e-14);
    EXPECT_TRUE(std::isnan(student_t_above(NAN, 5)));
}

TEST(StudentT, SidakSharesARate) {
    EXPECT_NEAR(sidak(0.05, 1), 0.05, 1e-15);
    EXPECT_NEAR(1 - std::pow(1 - sidak(0.05, 324), 324), 0.05, 1e-12);
    EXPECT_NEAR(sidak_of_all(sidak(0.05, 324), 324), 0.05, 1e-12);
    EXPECT_LT(sidak(0.05, 324), 0.05 / 300) << "324 tests must each be stricter than one";
}

TEST(Statistics, ATilesNumbersAreTheFormulas) {
    // Eight tile means 0.5 -+ 0.1: variance 8/7 0.01, of the mean 0.01/7.
    const Examination e = examine(alternating(0.5f, 0.1f), truth_of(0.4f, 0.02f), options(0));
    ASSERT_EQ(e.tiles.size(), 6u);
    const double own = 0.01 / 7, known = 0.02 * 0.02;
    const Difference& d = green(e, 0);
    EXPECT_NEAR(d.value, 0.1, 1e-6);
    EXPECT_NEAR(d.reference, 0.4, 1e-6);
    EXPECT_NEAR(d.standard_error, std::sqrt(own + known), 1e-7) << "errors of neighbouring pixels add up linearly";
    EXPECT_NEAR(d.z, 0.1 / std::sqrt(own + known), 1e-4);
    // The tile itself has 7 degrees of freedom before the reference's error is added, Welch and Satterthwaite.
    EXPECT_NEAR(d.freedom, 7 * std::pow((own + known) / own, 2), 1e-3);
    EXPECT_NEAR(d.limit, student_t_limit(sidak(sidak(0.05, 2), 18), std::floor(d.freedom)), 1e-9);
    EXPECT_NEAR(e.whole[0].limit, student_t_limit(sidak(sidak(0.05, 2), 3), std::floor(d.freedom)), 1e-9);
    EXPECT_NEAR(e.mean_variance, 8 * 0.01 / 7, 1e-7);
    EXPECT_NEAR(e.shared_noise, 64, 1e-3) << "all pixels of a tile go up and down together";
}

TEST(Statistics, TilesAtTheEdgeMayBeSmaller) {
    Pictures pictures(8, flat(1, 20, 9));
    const Examination e = examine(pictures, {flat(1, 20, 9), flat(0, 20, 9)}, options());
    ASSERT_EQ(e.tiles.size(), 6u);
    EXPECT_EQ(e.tiles[5].x, 16);
    EXPECT_EQ(e.tiles[5].y, 8);
    EXPECT_EQ(e.tiles[5].width, 4);
    EXPECT_EQ(e.tiles[5].height, 1);
    EXPECT_TRUE(e.passed());
}

TEST(Statistics, OnlyWhatGoesBeyondTheMarginIsWrong) {
    // No noise at all: the margin alone decides.
    EXPECT_TRUE(examine(Pictures(8, flat(1.0099f)), truth_of(1), options()).passed());
    const Examination e = examine(Pictures(8, flat(1.0101f)), truth_of(1), options());
    EXPECT_EQ(e.tiles_wrong, 6);
    EXPECT_TRUE(e.whole[2].wrong);
    EXPECT_GT(green(e, 3).z, 100);
    EXPECT_LT(green(examine(Pictures(8, flat(0.98f)), truth_of(1), options()), 3).z, -100) << "too dark is negative";
}

TEST(Statistics, TheMarginOfADarkTileIsThePictures) {
    AveragedReference truth = truth_of(1);
    add(truth.mean, 0, 0, 8, -0.999f);
    Pictures pictures(8, truth.mean);
    for (RgbImage& p : pictures) add(p, 0, 0, 8, 0.008f);
    EXPECT_TRUE(examine(pictures, truth, options()).passed()) << "eight times as bright, but nobody sees it";
    for (RgbImage& p : pictures) add(p, 0, 0, 8, 0.008f);
    EXPECT_EQ(examine(pictures, truth, options()).tiles_wrong, 1);
    // A brighter tile has a wider margin.
    add(truth.mean, 8, 8, 8, 3);
    EXPECT_NEAR(green(examine(Pictures(8, truth.mean), truth, options()), 4).margin, 0.04, 1e-6);
}

TEST(Statistics, AnAbsentChannelIsNotJudgedByItsRounding) {
    AveragedReference truth = truth_of(1);
    for (Rgb& p : truth.mean.pixels) p[2] = 0;
    Pictures pictures(8, truth.mean);
    for (RgbImage& p : pictures)
        for (Rgb& c : p.pixels) c[2] = 1e-6f;
    EXPECT_TRUE(examine(pictures, truth, options()).passed());
    for (RgbImage& p : pictures)
        for (Rgb& c : p.pixels) c[2] = 0.01f;
    EXPECT_FALSE(examine(pictures, truth, options()).passed());
}

TEST(Statistics, ATileThatMissedTheRareLightIsGivenItsNeighboursNoise) {
    // Seven of eight seeds are calm but for the tile beside: there, light comes rarely.
    const auto pictures = [](float rare) {
        Pictures list(8, flat(0.98f));
        for (int i = 0; i < 8; ++i) add(list[static_cast<std::size_t>(i)], 8, 0, 8, (i % 2 ? rare : -rare));
        return list;
    };
    EXPECT_TRUE(green(examine(pictures(0), truth_of(1), options()), 0).wrong);
    const Examination e = examine(pictures(0.1f), truth_of(1), options());
    EXPECT_FALSE(green(e, 0).wrong);
    EXPECT_NEAR(green(e, 0).standard_error, std::sqrt(0.01 / 7 / 4), 1e-5) << "the mean of a corner's four variances";
    // One of four is all: as many degrees of freedom as that one has.
    EXPECT_NEAR(green(e, 0).freedom, 7, 1e-6);
    EXPECT_TRUE(green(e, 5).wrong == false && green(e, 5).standard_error > 0);
}

TEST(Statistics, LightThatIsRarerStillIsLookedForTwoTilesAway) {
    // All is calm and 2 % too dark; two tiles from the first, tiles at these heights have an event in so many seeds.
    const auto first_tile = [](int seeds, std::vector<int> heights) {
        Pictures list(8, flat(0.98f, 40, 40));
        for (int i = 0; i < seeds; ++i)
            for (const int y : heights) add(list[static_cast<std::size_t>(i)], 16, y, 8, i % 2 ? 0.8f : -0.8f);
        return green(examine(list, {flat(1, 40, 40), flat(0, 40, 40)}, options()), 0);
    };
    const Difference rare = first_tile(1, {0});
    EXPECT_FALSE(rare.wrong) << "the event could as well have been here";
    // The variance of one mean of eight that is off by 0.8 is 0.8^2/8; a corner has nine tiles within two.
    EXPECT_NEAR(rare.standard_error, std::sqrt(0.64 / 8 / 9 / 8), 1e-5);
    EXPECT_TRUE(first_tile(8, {0, 16}).wrong) << "sixteen events are not rare: what is calm beside them is calm";
}

TEST(Statistics, NotANumberFailsAndIsCounted) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Pictures pictures = alternating(1, 0.01f);
        pictures[3].at(2, 2)[1] = bad;
        pictures[5].at(2, 2)[0] = bad;
        const Examination e = examine(pictures, truth_of(1), options());
        EXPECT_EQ(e.not_finite, 2);
        EXPECT_FALSE(e.passed());
        EXPECT_TRUE(e.suspects().empty());
    }
}

TEST(Statistics, RefusesWhatDoesNotFit) {
    EXPECT_THROW(examine({flat(1)}, truth_of(1), options()), std::invalid_argument) << "one picture has no spread";
    EXPECT_THROW(examine({flat(1), flat(1, 8, 8)}, truth_of(1), options()), std::invalid_argument);
    EXPECT_THROW(examine({flat(1), flat(1)}, {flat(1), flat(1, 8, 8)}, options()), std::invalid_argument);
}

TEST(Statistics, SuspectsAloneMayBeWrongAndOnlyInTheirDirection) {
    Pictures pictures(8, flat(1));
    for (RgbImage& p : pictures) add(p, 0, 0, 8, 0.2f), add(p, 8, 0, 8, 0.2f);
    EXPECT_EQ(examine(pictures, truth_of(1), options()).tiles_wrong, 2);
    const Examination one = examine(pictures, truth_of(1), options(), {{0, 1, true}});
    EXPECT_EQ(one.tiles_wrong, 1);
    ASSERT_EQ(one.suspects().size(), 1u);
    EXPECT_EQ(one.tile_tests, 1);
    EXPECT_TRUE(examine(pictures, truth_of(1), options(), {{0, 1, false}}).passed()) << "it was too dark before";
    EXPECT_TRUE(examine(pictures, truth_of(1), options(), {{2, 1, true}}).passed());
}

TEST(Statistics, ZIsPaintedTileByTile) {
    Pictures pictures(8, flat(1));
    for (RgbImage& p : pictures) add(p, 8, 8, 8, -0.2f);
    const RgbImage z = z_picture(examine(pictures, truth_of(1), options()), {24, 16});
    EXPECT_EQ(z.at(7, 8)[0], 0);
    EXPECT_EQ(z.at(8, 8)[0], -999) << "without noise any difference is endlessly many standard errors";
    EXPECT_EQ(z.at(15, 15)[2], -999);
    EXPECT_EQ(z.at(16, 15)[2], 0);
}

class Confirmation : public testing::Test {
protected:
    BiasVerdict verdict(const Pictures& first, const Pictures& second) {
        return judge_bias(first, truth_of(1), VerdictOptions{}, [&](int seeds) {
            asked_ = seeds;
            return second;
        });
    }
    static Pictures with(float value, int x, int seeds) {
        Pictures list = alternating(1, 0.001f, seeds);
        for (RgbImage& p : list) add(p, x, 0, 8, value);
        return list;
    }
    int asked_ = 0;
};

TEST_F(Confirmation, ARightPictureNeedsNoSecondBatch) {
    const BiasVerdict v = verdict(alternating(1, 0.01f), {});
    EXPECT_TRUE(v.passed);
    EXPECT_EQ(v.batches, 1);
    EXPECT_EQ(asked_, 0);
}

TEST_F(Confirmation, AFailureNeedsTheSamePlaceInTheSameDirectionTwice) {
    const BiasVerdict same = verdict(with(0.02f, 0, 8), with(0.02f, 0, 16));
    EXPECT_EQ(asked_, 16) << "twice the seeds";
    EXPECT_FALSE(same.passed);
    EXPECT_EQ(same.batches, 2);
    EXPECT_EQ(same.examination.tiles_wrong, 1);
    EXPECT_LT(same.chance, 1e-6);
    EXPECT_TRUE(verdict(with(0.02f, 0, 8), with(0.02f, 16, 16)).passed) << "another tile";
    EXPECT_TRUE(verdict(with(0.02f, 0, 8), with(-0.02f, 0, 16)).passed) << "the other direction";
    EXPECT_TRUE(verdict(with(0.02f, 0, 8), alternating(1, 0.001f, 16)).passed) << "chance";
}

TEST_F(Confirmation, NotANumberIsNoChance) {
    Pictures bad = alternating(1, 0.01f);
    bad[0].at(0, 0)[0] = NAN;
    const BiasVerdict v = verdict(bad, alternating(1, 0.01f, 16));
    EXPECT_FALSE(v.passed);
    EXPECT_EQ(asked_, 0);
    EXPECT_TRUE(has(bias_text(v, {24, 16}), "1 pixel of 8 pictures is not finite")) << bias_text(v, {24, 16});
}

TEST_F(Confirmation, WithoutASecondBatchNothingIsPassed) {
    const BiasVerdict v = verdict(with(0.02f, 0, 8), {});
    EXPECT_FALSE(v.passed);
    EXPECT_TRUE(v.cut_short);
}

Examination noise(double variance, double shared = 1) {
    Examination e;
    e.mean_variance = variance;
    e.shared_noise = shared;
    return e;
}

TEST(Noise, PointsFallBetweenTwoRatios) {
    const VerdictOptions o;
    const auto share = [&](double ratio) { return judge_noise(noise(ratio), false, noise(1), o).share; };
    EXPECT_EQ(share(0.3), 1);
    EXPECT_EQ(share(1.75), 1);
    EXPECT_NEAR(share(2.125), 0.5, 1e-12);
    EXPECT_EQ(share(2.5), 0);
    EXPECT_EQ(share(NAN), 0);
    EXPECT_EQ(share(INFINITY), 0);
    EXPECT_EQ(judge_noise(noise(0), false, noise(0), o).share, 1) << "a scene without noise";
    EXPECT_EQ(judge_noise(noise(1), false, noise(0), o).share, 0);
}

TEST(Noise, HiddenNoiseIsFound) {
    const VerdictOptions o;
    EXPECT_TRUE(judge_noise(noise(0), true, noise(1), o).equal);
    EXPECT_EQ(judge_noise(noise(0), true, noise(1), o).share, 0);
    EXPECT_EQ(judge_noise(noise(1, 64), false, noise(1), o).share, 0) << "one set of random numbers for all pixels";
    EXPECT_EQ(judge_noise(noise(1, 4), false, noise(1), o).share, 1);
    EXPECT_EQ(judge_noise(noise(1, 20), false, noise(1, 3), o).share, 1) << "the solution shares some as well";
}

TEST(Noise, ANoiseThatHidesEverythingIsUnresolved) {
    const VerdictOptions o;
    Examination student = examine(alternating(1, 0.1f), truth_of(1), options());
    EXPECT_TRUE(judge_noise(student, false, noise(student.mean_variance / 10), o).unresolved);
    EXPECT_FALSE(judge_noise(student, false, noise(student.mean_variance), o).unresolved)
        << "the solution cannot do better";
    student = examine(alternating(1, 0.001f), truth_of(1), options());
    EXPECT_FALSE(judge_noise(student, false, noise(student.mean_variance / 10), o).unresolved);
}

TEST(Noise, TheKinderOfTwoCounts) {
    const VerdictOptions o;
    const NoiseVerdict good = judge_noise(noise(1), false, noise(1), o),
                       bad = judge_noise(noise(9), false, noise(1), o);
    EXPECT_EQ(kinder(bad, good).share, 1);
    EXPECT_EQ(kinder(good, bad).share, 1);
    EXPECT_EQ(kinder(bad, bad).share, 0);
    EXPECT_EQ(kinder(bad, good).batches, 2);
}

class ExplainBias : public testing::Test {
protected:
    ExplainBias() {
        truth_ = {test_picture(48, 32), flat(1e-4f, 48, 32)};
        for (int i = 0; i < 8; ++i) {
            pictures_.push_back(truth_.mean);
            for (Rgb& p : pictures_.back().pixels)
                for (float& v : p) v *= 1 + (i % 2 ? 0.002f : -0.002f);
        }
    }
    std::string changed(const std::function<float(float)>& f) {
        Pictures list = pictures_;
        for (RgbImage& picture : list)
            for (Rgb& p : picture.pixels)
                for (float& v : p) v = f(v);
        return explain_bias(list, truth_, VerdictOptions{}).value_or("");
    }
    AveragedReference truth_;
    Pictures pictures_;
};

TEST_F(ExplainBias, NamesTheUsualMistakes) {
    EXPECT_TRUE(has(changed([](float v) { return 1.25f * v; }), "every value is 1.25 times the right one"));
    EXPECT_TRUE(has(changed([](float v) { return v + 0.05f; }), "every value is 0.05 too large"));
    EXPECT_TRUE(has(changed([](float v) { return std::pow(v, 1 / 2.2f); }), "gamma encoded"));
    EXPECT_TRUE(has(changed([](float) { return 0.0f; }), "black"));
    EXPECT_EQ(changed([](float v) { return v > 0.5f ? v + 0.3f : v * v; }), "") << "no mistake that it knows";
    Pictures swapped = pictures_;
    for (RgbImage& picture : swapped)
        for (Rgb& p : picture.pixels) std::swap(p[0], p[2]);
    EXPECT_EQ(explain_bias(swapped, truth_, VerdictOptions{}).value_or(""), "red and blue are swapped");
}

TEST(StatisticalWords, SayWhereAndHowMuch) {
    Pictures first(8, flat(1)), second(16, flat(1));
    for (RgbImage& p : first) add(p, 16, 8, 8, -0.1f);
    for (RgbImage& p : second) add(p, 16, 8, 8, -0.1f);
    const BiasVerdict v = judge_bias(first, truth_of(1, 0.001f), VerdictOptions{}, [&](int) { return second; });
    const std::string text = bias_text(v, {24, 16});
    EXPECT_TRUE(has(text, "1 of 6 tiles wrong, most of all at pixels (16, 8) to (23, 15), lower right")) << text;
    EXPECT_TRUE(has(text, "too dark by 10 % (0.9 instead of 1)")) << text;
    EXPECT_TRUE(has(text, "8 seeds and then 16 others")) << text;
    EXPECT_TRUE(has(text, "less than once in 10^9 gradings")) << text;
}

}  // namespace
}  // namespace rays::grader
