// The parts of the references driver that need no POV-Ray.
#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "references/manifest.h"
#include "references/reference.h"
#include "references/scene_files.h"
#include "support/files.h"
#include "support/sha256.h"

namespace rays {
namespace {

// FIPS 180-4 examples, as published by NIST.
TEST(Sha256, KnownAnswers) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Files, AppearWholeOrNotAtAll) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "deep" / "file";
    write_atomically(file, "first");
    EXPECT_THROW(write_atomically(file,
                                  [](const std::filesystem::path& partial) {
                                      write_atomically(partial, "half");
                                      throw InputError("interrupted");
                                  }),
                 InputError);
    EXPECT_EQ(read_file(file), "first");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}), 1);  // nothing left behind
    EXPECT_THROW(read_file(folder.path() / "missing"), InputError);
    EXPECT_THROW(read_file(folder.path()), InputError);
}

TEST(Includes, OnlyWherePovrayReadsThem) {
    const auto names = included_names(R"(
        // #include "comment.inc"
        /* #include "block.inc" /* nested */ #include "still.inc" */
        #include "first.inc" #declare S = "#include \"string.inc\" ";
        # include "second.inc"
        density_file df3 "smoke.df3"
        #debug "unclosed)",
                                      "test");
    EXPECT_EQ(names, (std::vector<std::string>{"first.inc", "second.inc", "smoke.df3"}));
    EXPECT_THROW(included_names("#include concat(\"a\", \".inc\")", "test"), InputError);
    EXPECT_TRUE(included_names("/* never closed", "test").empty());
}

TEST(Includes, NestedAndCircular) {
    const TemporaryFolder folder;
    write_atomically(folder.path() / "scene.pov", "#include \"a.inc\"");
    write_atomically(folder.path() / "a.inc", "#include \"b.inc\"");
    write_atomically(folder.path() / "library" / "b.inc", "#include \"a.inc\"");
    const auto files = included_files(folder.path() / "scene.pov", {folder.path() / "library"});
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files.at("b.inc"), folder.path() / "library" / "b.inc");
    EXPECT_THROW(included_files(folder.path() / "scene.pov", {}), InputError);
}

TEST(Scenes, AreFoundAndNamed) {
    const TemporaryFolder folder;
    for (const char* name :
         {"1_ray_casting/b.pov", "1_ray_casting/a.pov", "2_phong/a.pov", "2_phong/a.inc", "other/c.pov"}) {
        write_atomically(folder.path() / name, "");
    }
    const auto scenes = find_scenes(folder.path());
    EXPECT_EQ(scenes, (std::vector<std::string>{"1_ray_casting/a.pov", "1_ray_casting/b.pov", "2_phong/a.pov"}));
    EXPECT_EQ(scenes_named(scenes, "a").size(), 2u);
    EXPECT_EQ(scenes_named(scenes, "2_phong/a.pov").size(), 1u);
    EXPECT_EQ(scenes_named(scenes, "1").size(), 2u);
    EXPECT_EQ(scenes_named(scenes, "2_phong").size(), 1u);
    EXPECT_THROW(scenes_named(scenes, "c"), InputError);
    EXPECT_THROW(find_scenes(folder.path() / "missing"), InputError);
}

TEST(Manifest, SurvivesItsFile) {
    const TemporaryFolder folder;
    Manifest manifest{"3.7", {}};
    manifest.put({.scene = "2/b.pov",
                  .reference = "2/b.exr",
                  .raster = {3, 2},
                  .command = "povray",
                  .sha256 = "x",
                  .includes = {{"colors.inc", "y"}},
                  .sha256_reference = "z"});
    ManifestEntry first;
    first.scene = "1/a.pov";
    manifest.put(first);
    save_manifest(manifest, folder.path() / "manifest.json");
    const Manifest back = load_manifest(folder.path() / "manifest.json");
    ASSERT_EQ(back.entries.size(), 2u);
    EXPECT_EQ(back.entries[0].scene, "1/a.pov");
    EXPECT_EQ(back.find("2/b.pov")->includes.at("colors.inc"), "y");
    EXPECT_EQ(back.find("2/b.pov")->raster.height, 2);
    EXPECT_EQ(back.find("3/c.pov"), nullptr);
    for (const char* bad : {"", "{", "[]", "{\"version\": 2}", R"({"version":1,"povray":3,"entries":[]})",
                            R"({"version":1,"povray":"","entries":[{"scene":1}]})"}) {
        write_atomically(folder.path() / "manifest.json", std::string_view(bad));
        EXPECT_THROW(load_manifest(folder.path() / "manifest.json"), InputError) << bad;
    }
}

RgbImage grey(Raster raster, float value) {
    return {raster, std::vector<Rgb>(static_cast<std::size_t>(raster.width * raster.height), Rgb{value, value, value})};
}

TEST(Reference, EnvelopeReachesHalfAPixelAround) {
    RgbImage fine = grey({16, 12}, 0.5f);
    // Fine pixel (9, 5) lies in pixel (2, 1). Its centre is 2.375, 1.375: within half a pixel around (1 | 2, 0 | 1)
    // only.
    fine.at(9, 5)[1] = 0.75f;
    const Reference reference = make_reference(grey({4, 3}, 0.5f), fine);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 4; ++x) {
            const bool near = (x == 1 || x == 2) && (y == 0 || y == 1);
            EXPECT_EQ(reference.max.at(x, y)[1], near ? 0.75f : 0.5f) << x << "," << y;
            EXPECT_EQ(reference.min.at(x, y)[1], 0.5f);
            EXPECT_EQ(reference.silhouette(x, y), near);
        }
    }
    EXPECT_TRUE(reference.within_envelope(1, 1, {0.5f, 0.7f, 0.5f}));
    EXPECT_TRUE(reference.within_envelope(1, 1, {0.5f, 0.7503f, 0.5f}));  // the rounding of halves
    EXPECT_FALSE(reference.within_envelope(1, 1, {0.5f, 0.76f, 0.5f}));
    EXPECT_FALSE(reference.within_envelope(1, 1, {0.7f, 0.7f, 0.5f}));
    EXPECT_FALSE(reference.within_envelope(1, 1, {0.5f, std::numeric_limits<float>::quiet_NaN(), 0.5f}));
    EXPECT_THROW(make_reference(grey({4, 3}, 0), grey({16, 13}, 0)), std::invalid_argument);
}

TEST(Reference, SurvivesItsFile) {
    const TemporaryFolder folder;
    RgbImage fine = grey({20, 12}, 0.25f);
    fine.at(0, 0) = {2, 0.125f, 65504};
    const Reference reference = make_reference(grey({5, 3}, 0.25f), fine);
    save_reference(reference, folder.path() / "r.exr");
    const Reference back = load_reference(folder.path() / "r.exr");
    EXPECT_EQ(back.raster().width, 5);
    EXPECT_EQ(back.raster().height, 3);
    EXPECT_EQ(back.frame.pixels, reference.frame.pixels);
    EXPECT_EQ(back.min.pixels, reference.min.pixels);
    EXPECT_EQ(back.max.pixels, reference.max.pixels);
}

TEST(Reference, RefusesWhatIsNone) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "r.exr";
    EXPECT_THROW(load_reference(file), InputError);
    write_atomically(file, "no picture");
    EXPECT_THROW(load_reference(file), InputError);
    save_reference(make_reference(grey({5, 3}, 0), grey({20, 12}, 0)), file);
    const std::string whole = read_file(file);
    for (const std::size_t length : {std::size_t{0}, std::size_t{8}, whole.size() / 2, whole.size() - 1}) {
        write_atomically(file, std::string_view(whole).substr(0, length));
        EXPECT_THROW(load_reference(file), InputError) << length << " bytes";
    }
}

}  // namespace
}  // namespace rays
