// The references driver with POV-Ray itself, in a folder of scenes of its own.
#include <gtest/gtest.h>

#include <cstdlib>

#include "command_fixture.h"
#include "core/error.h"

namespace rays {
namespace {

constexpr const char* kScene = R"(
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "tint.inc"
camera { location <0, 0, -3> right x*4/3 up y direction z }
sphere { 0, 1 pigment { rgb Tint } finish { ambient 1 diffuse 0 } }
)";

class References : public ReferencesCommand {
protected:
    References() : ReferencesCommand({16, 12}) {}

    void SetUp() override {
        put("1_test/ball.pov", kScene);
        put("1_test/tint.inc", "#declare Tint = <0.5, 0.25, 1>;\n");
    }
};

TEST_F(References, AreMadeOnceAndChecked) {
    ASSERT_EQ(run({}), kSuccess) << err_;
    const Manifest manifest = load_manifest(folders().manifest());
    ASSERT_EQ(manifest.entries.size(), 1u);
    const ManifestEntry& entry = manifest.entries[0];
    EXPECT_EQ(entry.includes.count("tint.inc"), 1u);
    EXPECT_EQ(entry.command.find(folder_.path().string()), std::string::npos) << "a machine's path: " << entry.command;

    const Reference reference = load_reference(folders().references() / entry.reference);
    EXPECT_EQ(reference.frame.at(8, 6), (Rgb{0.5f, 0.25f, 1}));
    EXPECT_EQ(reference.frame.at(0, 0), (Rgb{0, 0, 0}));
    EXPECT_FALSE(reference.silhouette(8, 6));
    EXPECT_FALSE(reference.silhouette(0, 0));
    // The outline is a circle of tan(asin(1/3)) x 12 pixels = 4.24 pixels around (8, 6): row 6 ends between 11 and 13.
    EXPECT_TRUE(reference.silhouette(12, 6));

    ASSERT_EQ(run({}), kSuccess);
    EXPECT_NE(out_.find("0 made, 1 up to date"), std::string::npos) << out_;
    EXPECT_EQ(run({"--hashes"}), kSuccess) << err_;
    EXPECT_EQ(run({"--check"}), kSuccess) << err_;
    EXPECT_EQ(run({"--check", "1"}), kSuccess) << err_;
    EXPECT_EQ(run({"--check", "ball"}), kSuccess) << err_;
    EXPECT_EQ(run({"no_such_scene"}), kBadInput);
    EXPECT_EQ(run({"--no-such-option"}), kBadInput);
}

TEST_F(References, GoStaleWithAnyOfTheirFiles) {
    ASSERT_EQ(run({}), kSuccess) << err_;
    put("1_test/tint.inc", "#declare Tint = <0.5, 0.25, 0.75>;\n");
    EXPECT_EQ(run({"--hashes"}), kCheckFailed);
    EXPECT_TRUE(err_says("an included file has changed")) << err_;
    ASSERT_EQ(run({}), kSuccess) << err_;
    EXPECT_EQ(run({"--hashes"}), kSuccess) << err_;

    put("1_test/ball.pov", std::string(kScene) + "// another word\n");
    EXPECT_EQ(run({"--hashes"}), kCheckFailed);
    EXPECT_TRUE(err_says("the scene has changed")) << err_;
    EXPECT_EQ(run({"--check"}), kCheckFailed);

    put("1_test/new.pov", kScene);
    EXPECT_EQ(run({"--hashes", "new"}), kCheckFailed);
    EXPECT_TRUE(err_says("has no reference")) << err_;
}

TEST_F(References, CheckFindsASinglePixelOfOneBit) {
    ASSERT_EQ(run({}), kSuccess) << err_;
    Manifest manifest = load_manifest(folders().manifest());
    ManifestEntry entry = manifest.entries[0];
    Reference reference = load_reference(folders().references() / entry.reference);
    reference.frame.at(3, 4)[2] = 0x1p-24f;  // the smallest half float
    save_reference(reference, folders().references() / entry.reference);
    EXPECT_EQ(run({"--hashes"}), kCheckFailed);
    EXPECT_TRUE(err_says("the reference has changed")) << err_;
    EXPECT_EQ(run({"--check"}), kCheckFailed);
    EXPECT_TRUE(err_says("1 of 192 pixels differ; pixel 3,4")) << err_;
}

TEST_F(References, QuotePovraysErrorsAndLeaveNothing) {
    put("1_test/bad.pov", std::string(kScene) + "sphere { 0, 1 nonsense }\n");
    EXPECT_EQ(run({}), kCheckFailed);
    EXPECT_TRUE(err_says("1_test/bad.pov")) << err_;
    EXPECT_TRUE(err_says("Parse Error")) << err_;
    EXPECT_TRUE(err_says("nonsense")) << err_;
    EXPECT_FALSE(std::filesystem::exists(folders().references() / "1_test/bad.exr"));
    EXPECT_TRUE(std::filesystem::exists(folders().references() / "1_test/ball.exr"));  // the others are made

    put("1_test/bad.pov", std::string(kScene) + "#warning \"beware\"\n");
    EXPECT_EQ(run({"bad"}), kCheckFailed);
    EXPECT_TRUE(err_says("beware")) << err_;
}

TEST_F(References, StopAtTheTimeLimit) {
    put("1_test/bad.pov", "#version 3.7;\n#while (1) #end\n");
    EXPECT_EQ(run({"bad", "--time-limit", "2"}), kCheckFailed);
    EXPECT_TRUE(err_says("was stopped after 2.")) << err_;
}

TEST_F(References, ScenesReadNothingElse) {
    put("secret/key.inc", "#declare Key = 1;\n");
    std::filesystem::create_symlink(folder_.path() / "secret/key.inc", folder_.path() / "1_test/link.inc");
    const std::string absolute = (folder_.path() / "secret/key.inc").string();
    for (const std::string& name : {std::string("../secret/key.inc"), absolute, std::string("link.inc")}) {
        put("1_test/bad.pov", "#version 3.7;\n#include \"" + name + "\"\n" + kScene);
        EXPECT_EQ(run({"bad"}), kCheckFailed);
        EXPECT_TRUE(err_says("lies outside")) << err_;
    }
}

TEST_F(References, SayWhatToInstall) {
    const std::string path = std::getenv("PATH");
    setenv("PATH", folder_.path().c_str(), 1);
    const int status = run({});
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(status, kBadInput);
    EXPECT_TRUE(err_says("apt-get install povray")) << err_;
}

TEST_F(References, OrphansAreDropped) {
    put("1_test/second.pov", kScene);
    ASSERT_EQ(run({}), kSuccess) << err_;
    std::filesystem::remove(folder_.path() / "1_test/second.pov");
    EXPECT_EQ(run({"--hashes"}), kCheckFailed);
    EXPECT_TRUE(err_says("the scene is gone")) << err_;
    ASSERT_EQ(run({}), kSuccess) << err_;
    EXPECT_FALSE(std::filesystem::exists(folders().references() / "1_test/second.exr"));
    EXPECT_EQ(run({"--hashes"}), kSuccess) << err_;
}

}  // namespace
}  // namespace rays
