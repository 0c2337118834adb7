// Averaged references: the numbers of their frames, their means and errors, their files.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "core/error.h"
#include "references/averaged.h"
#include "references/scene_files.h"
#include "support/files.h"

namespace rays {
namespace {

TEST(FrameNumbers, AreTheSameForever) {
    const std::vector<std::string> declared = frame_declarations(5, 64);
    ASSERT_EQ(declared.size(), 17u);
    EXPECT_EQ(declared[0], "Declare=Frame=5");
    EXPECT_EQ(declared[1], "Declare=Frame_u0=0.524491");
    EXPECT_EQ(declared[16], "Declare=Frame_u15=0.575558");
}

// 64 points of the first two dimensions of a group: one in each of the 64 boxes of every shape.
TEST(FrameNumbers, FillTheirPairsEvenly) {
    const std::vector<std::pair<std::size_t, std::size_t>> pairs{{0, 1}, {5, 6}, {8, 9}, {11, 12}};
    for (int replicate = 0; replicate < kReplicates; ++replicate) {
        for (const auto& [first, second] : pairs) {
            for (int columns = 1; columns <= 64; columns *= 2) {
                const int rows = 64 / columns;
                std::set<std::pair<int, int>> boxes;
                for (int i = 0; i < 64; ++i) {
                    const FrameNumbers u = frame_numbers(64 * replicate + i, 64 * kReplicates);
                    boxes.insert({static_cast<int>(1LL * u[first] * columns / 1000000),
                                  static_cast<int>(1LL * u[second] * rows / 1000000)});
                }
                EXPECT_EQ(boxes.size(), 64u) << "pair " << first << ", " << columns << " x " << rows;
            }
        }
    }
}

TEST(FrameNumbers, KnowNothingOfEachOther) {
    constexpr int kFrames = 4096;
    std::vector<FrameNumbers> frames;
    for (int i = 0; i < kFrames; ++i) frames.push_back(frame_numbers(i, kFrames));
    for (std::size_t a = 0; a < 16; ++a) {
        double mean = 0;
        for (const FrameNumbers& u : frames) {
            ASSERT_GE(u[a], 0);
            ASSERT_LT(u[a], 1000000);
            mean += u[a] * 1e-6 / kFrames;
        }
        EXPECT_NEAR(mean, 0.5, 0.0003) << a;
        for (std::size_t b = 0; b < a; ++b) {
            double covariance = 0;
            for (const FrameNumbers& u : frames) covariance += (u[a] * 1e-6 - 0.5) * (u[b] * 1e-6 - 0.5) / kFrames;
            // Chance has a standard deviation of 1/64; between groups, where neighbours are two of a kind, 1/45.
            EXPECT_NEAR(12 * covariance, 0, 0.1) << a << " and " << b;
        }
    }
}

RgbImage grey(Raster raster, float value) {
    return {raster, std::vector<Rgb>(static_cast<std::size_t>(raster.width * raster.height), Rgb{value, value, value})};
}

FrameSums sums_of(const std::array<float, kReplicates>& replicates) {
    FrameSums sums({2, 1});
    for (int r = 0; r < kReplicates; ++r) {
        const float value = replicates[static_cast<std::size_t>(r)];
        sums.add(r, grey({2, 1}, value - 0.25f));
        sums.add(r, grey({2, 1}, value + 0.25f));
    }
    return sums;
}

TEST(FrameSums, TellMeanAndStandardError) {
    const AveragedReference reference = sums_of({1, 2, 3, 4, 5, 6, 7, 8}).result();
    EXPECT_EQ(reference.mean.at(1, 0)[2], 4.5f);
    // The variance of the numbers 1 to 8 is 6; of their mean 6/8.
    EXPECT_FLOAT_EQ(reference.error.at(0, 0)[0], static_cast<float>(std::sqrt(6.0 / 8)));
    EXPECT_NEAR(rms_error(reference), std::sqrt(6.0 / 8), 1e-6);
    EXPECT_EQ(sums_of({1, 1, 1, 1, 1, 1, 1, 1}).result().error.at(0, 0)[0], 0);
}

TEST(FrameSums, RefuseWhatIsNoFrame) {
    FrameSums sums({2, 1});
    EXPECT_THROW(sums.add(0, grey({1, 2}, 1)), std::invalid_argument);
    EXPECT_THROW(sums.add(0, grey({2, 1}, std::numeric_limits<float>::infinity())), std::invalid_argument);
    EXPECT_THROW(sums.add(0, grey({2, 1}, std::numeric_limits<float>::quiet_NaN())), std::invalid_argument);
    EXPECT_THROW(sums.add(kReplicates, grey({2, 1}, 1)), std::out_of_range);
}

TEST(FrameSums, NoReplicateOfTheirOwnIsAnAlarm) {
    // In the first, one replicate is as far from the mean as it can be.
    for (const std::array<float, kReplicates>& values :
         {std::array<float, kReplicates>{0, 0, 0, 1, 0, 0, 0, 0}, {1, 2, 3, 4, 5, 6, 7, 8}, {1, 1, 1, 1, 1, 1, 1, 1}}) {
        const FrameSums sums = sums_of(values);
        const AveragedReference reference = sums.result();
        for (int r = 0; r < kReplicates; ++r) {
            EXPECT_EQ(difference_of_replicate(reference, sums.replicate_mean(r)), "");
        }
        std::vector<double> other = sums.replicate_mean(3);
        other[4] = reference.mean.at(1, 0)[1] + 1.001 * kFurthestReplicate * reference.error.at(1, 0)[1] + 1e-5;
        EXPECT_NE(difference_of_replicate(reference, other).find("channel G of pixel 1,0"), std::string::npos);
        other[4] = std::numeric_limits<double>::quiet_NaN();
        EXPECT_NE(difference_of_replicate(reference, other), "");
        other.pop_back();
        EXPECT_NE(difference_of_replicate(reference, other), "");
    }
}

TEST(AveragedReference, SurvivesItsFile) {
    const TemporaryFolder folder;
    AveragedReference reference{grey({5, 3}, 1.0f / 3), grey({5, 3}, 1e-5f)};
    reference.mean.at(1, 2) = {0.1f, 1e-20f, 70000};  // what half floats could not hold
    save_averaged_reference(reference, folder.path() / "r.exr");
    const AveragedReference back = load_averaged_reference(folder.path() / "r.exr");
    EXPECT_EQ(back.raster().width, 5);
    EXPECT_EQ(back.raster().height, 3);
    EXPECT_EQ(back.mean.pixels, reference.mean.pixels);
    EXPECT_EQ(back.error.pixels, reference.error.pixels);
}

TEST(AveragedReference, RefusesWhatIsNone) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "r.exr";
    EXPECT_THROW(load_averaged_reference(file), InputError);
    write_atomically(file, "no picture");
    EXPECT_THROW(load_averaged_reference(file), InputError);
    save_reference(make_reference(grey({5, 3}, 0), grey({20, 12}, 0)), file);
    EXPECT_THROW(load_averaged_reference(file), InputError) << "a frame has no errors";

    const AveragedReference good{grey({5, 3}, 1), grey({5, 3}, 0)};
    for (const auto& [mean, error] : {std::pair{1.0f, -0.1f},
                                      {std::numeric_limits<float>::quiet_NaN(), 0.0f},
                                      {1.0f, std::numeric_limits<float>::infinity()}}) {
        AveragedReference bad = good;
        bad.mean.at(2, 1)[0] = mean;
        bad.error.at(2, 1)[0] = error;
        save_averaged_reference(bad, file);
        EXPECT_THROW(load_averaged_reference(file), InputError) << mean << " +- " << error;
    }
    save_averaged_reference(good, file);
    EXPECT_NO_THROW(load_averaged_reference(file));
    EXPECT_THROW(load_reference(file), InputError) << "a mean has no envelope";
    const std::string whole = read_file(file);
    for (const std::size_t length : {std::size_t{0}, std::size_t{8}, whole.size() / 2, whole.size() - 1}) {
        write_atomically(file, std::string_view(whole).substr(0, length));
        EXPECT_THROW(load_averaged_reference(file), InputError) << length << " bytes";
    }
}

TEST(Scenes, HaveFramesWhenTheySayTheWord) {
    EXPECT_TRUE(mentions("#ifdef (Frame) #end", "Frame"));
    EXPECT_FALSE(mentions("// Frame\n/* Frame */ #declare S = \"Frame\"; Frame_u0 frame WindowFrame", "Frame"));
    const TemporaryFolder folder;
    const auto scene = folder.path() / "scenes" / "scene.pov", library = folder.path() / "library";
    write_atomically(folder.path() / "scenes" / "own.inc", "#ifdef (Frame) #end");
    write_atomically(library / "povrays.inc", "#ifdef (Frame) #end");
    write_atomically(scene, "#include \"povrays.inc\"");
    EXPECT_FALSE(has_frames(scene, {library}));
    write_atomically(scene, "#include \"povrays.inc\"\n#include \"own.inc\"");
    EXPECT_TRUE(has_frames(scene, {library}));
    write_atomically(scene, "#ifndef (Frame) #end");
    EXPECT_TRUE(has_frames(scene, {library}));
}

}  // namespace
}  // namespace rays
