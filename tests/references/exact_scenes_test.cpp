// Every committed scene, rendered by the solution, against its committed reference by POV-Ray.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ostream>

#include "core/error.h"
#include "core/vec.h"
#include "references/command.h"
#include "references/library.h"
#include "support/files.h"
#include "support/process.h"

namespace rays {

void PrintTo(const ManifestEntry& entry, std::ostream* out) { *out << entry.scene; }

namespace {

const ReferenceFolders kFolders{SCENES_FOLDER};

/// At most this share of the pixels may differ, where an edge or a crease decides by the last digit: one pixel in 2000.
constexpr double kShareAllowed = 0.0005;

/// Shading is computed in single precision on both sides, in another order of operations: a few units of 6e-8 each.
constexpr float kShading = 2e-6f;

bool differs(const Rgb& ours, const Rgb& reference) {
    for (std::size_t c = 0; c < 3; ++c) {
        if (!(std::abs(ours[c] - reference[c]) <= half_rounding(reference[c]) + kShading)) return true;
    }
    return false;
}

RgbImage render(const ManifestEntry& entry) {
    const TemporaryFolder temporary;
    const auto picture = temporary.path() / "picture.exr";
    const Ended ended =
        run_command({{RENDER_SOLUTION, (kFolders.scenes / entry.scene).string(), "-o", picture.string(), "--width",
                      std::to_string(entry.raster.width), "--height", std::to_string(entry.raster.height)},
                     {},
                     {},
                     only_time(60),
                     true});
    if (!ended.ok()) throw InputError(how_it_ended(ended) + ": " + ended.err);
    return load_rgb_exr(picture);
}

class ExactScene : public testing::TestWithParam<ManifestEntry> {};

TEST_P(ExactScene, IsPovraysPicture) {
    if (sizeof(Real) < sizeof(double)) GTEST_SKIP() << "the exact pictures are promised for geometry in double";
    const Reference reference = load_reference(kFolders.references() / GetParam().reference);
    const RgbImage ours = render(GetParam());
    ASSERT_EQ(ours.pixels.size(), reference.frame.pixels.size());
    int count = 0;
    std::string where;
    for (int y = 0; y < ours.raster.height; ++y) {
        for (int x = 0; x < ours.raster.width; ++x) {
            if (!differs(ours.at(x, y), reference.frame.at(x, y))) continue;
            ++count;
            where += fmt::format(" {},{}", x, y);
            EXPECT_TRUE(reference.within_envelope(x, y, ours.at(x, y)))
                << "pixel " << x << "," << y << " is on no edge";
        }
    }
    RecordProperty("differing_pixels", count);
    EXPECT_LE(count, kShareAllowed * static_cast<double>(ours.pixels.size())) << "pixels" << where;
}

std::vector<ManifestEntry> entries() { return load_manifest(kFolders.manifest()).entries; }

std::string test_name(const testing::TestParamInfo<ManifestEntry>& info) {
    std::string name = info.param.scene.substr(0, info.param.scene.rfind('.'));
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    }
    return name;
}

/// Without those that are means: nothing equals them exactly.
std::vector<ManifestEntry> exact_entries() {
    std::vector<ManifestEntry> result = entries();
    std::erase_if(result, [](const ManifestEntry& entry) { return entry.averaged(); });
    return result;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExactScene, testing::ValuesIn(exact_entries()), test_name);

TEST(CommittedReferences, MatchTheirScenes) {
    const std::string scenes = kFolders.scenes.string();
    const char* const argv[] = {"references", "--hashes", "--scenes", scenes.c_str()};
    EXPECT_EQ(references_command(4, argv), kSuccess) << "make them anew: rays references";
}

TEST(CommittedReferences, AreSmall) {
    std::uintmax_t bytes = 0;
    for (const ManifestEntry& entry : entries())
        bytes += std::filesystem::file_size(kFolders.references() / entry.reference);
    EXPECT_LT(bytes, 25u << 20);  // all together, in every clone
}

}  // namespace
}  // namespace rays
