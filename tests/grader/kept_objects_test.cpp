// Objects that are taken instead of compiled: exactly where compiling would give the same.
#include "grader/kept_objects.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "1_ray_casting/torus.cpp";

/// A course in a folder of its own, compiled with the real one's commands.
class KeptObjectsTest : public testing::Test {
protected:
    KeptObjectsTest() : real(find_project()), builder(real), course(real) {
        course.root = folder.path();
        course.build = folder.path() / "build";
        for (const char* side : {"steps", "solutions"}) {
            fs::create_directories(course.root / side / "1_ray_casting");
            fs::copy_file(real.root / side / kFile, course.root / side / kFile);
        }
        fs::create_directories(course.steps() / "core");
        for (const char* header : {"core/unfinished.h", "1_ray_casting/ray_casting.h"})
            fs::copy_file(real.steps() / header, course.steps() / header);
    }

    /// Compiles this text as a submission's.
    Built submit(const std::string& text) const {
        const fs::path source = folder.path() / "submitted.cpp";
        write_atomically(source, text);
        return KeptObjects(builder, course).compile(kFile, source, folder.path() / "submitted.o");
    }
    std::string starter() const { return read_file(course.steps() / kFile); }
    void add_to(const std::string& file, const std::string& text) const {
        std::ofstream(course.root / file, std::ios::app) << text;
    }

    std::vector<fs::path> kept() const {
        std::vector<fs::path> files;
        if (fs::exists(course.build / "kept-objects"))
            for (const auto& entry : fs::directory_iterator(course.build / "kept-objects"))
                files.push_back(entry.path());
        return files;
    }
    /// What is kept is replaced by a mark: an object that is the mark was not compiled.
    void mark() const {
        ASSERT_EQ(kept().size(), 1U);
        write_atomically(kept().front(), "mark");
    }
    static bool is_marked(const Built& built) { return built.good && read_file(built.file) == "mark"; }

    TemporaryFolder folder;
    const Project real;
    const Builder builder;
    Project course;
};

TEST_F(KeptObjectsTest, TheSolutionsTextHasItsObjectInTheBuild) {
    const Built built = submit(read_file(course.root / "solutions" / kFile));
    EXPECT_TRUE(built.good);
    EXPECT_EQ(built.file, builder.solution_object(kFile));
    EXPECT_TRUE(kept().empty());
}

TEST_F(KeptObjectsTest, AStarterIsCompiledOnceAndGivesWhatTheCompilerGave) {
    const Built compiled = submit(starter());
    ASSERT_TRUE(compiled.good) << compiled.message;
    const std::string object = read_file(compiled.file);
    EXPECT_TRUE(
        object.starts_with("\x7f"
                           "ELF"));
    EXPECT_EQ(read_file(submit(starter()).file), object);
    mark();
    EXPECT_TRUE(is_marked(submit(starter())));
}

TEST_F(KeptObjectsTest, OneLetterMoreIsCompiledAndNotKept) {
    submit(starter());
    mark();
    const Built built = submit(starter() + "\n");
    EXPECT_TRUE(built.good);
    EXPECT_FALSE(is_marked(built));
    mark();
}

TEST_F(KeptObjectsTest, AChangedStarterTakesThePlaceOfItsOlderState) {
    submit(starter());
    mark();
    add_to("steps/1_ray_casting/torus.cpp", "// changed\n");
    EXPECT_FALSE(is_marked(submit(starter())));
    mark();
    EXPECT_TRUE(is_marked(submit(starter())));
}

TEST_F(KeptObjectsTest, AChangedHeaderMakesItCompileAgain) {
    submit(starter());
    mark();
    add_to("steps/core/unfinished.h", "// changed\n");
    EXPECT_FALSE(is_marked(submit(starter())));
}

// What such a file includes may change without anybody seeing it here.
TEST_F(KeptObjectsTest, AFileWithOtherHeadersIsCompiledEachTime) {
    add_to("elsewhere.h", "");
    const std::string original = starter();
    for (const char* include : {"#include \"../../elsewhere.h\"\n", "  #  include \"elsewhere.h\"\n",
                                "#define OTHER <vector>\n#include OTHER\n"}) {
        write_atomically(course.steps() / "1_ray_casting/elsewhere.h", "");
        write_atomically(course.steps() / kFile, include + original);
        EXPECT_TRUE(submit(starter()).good || std::string(include).find("elsewhere") != std::string::npos);
        EXPECT_TRUE(kept().empty()) << include;
    }
}

TEST_F(KeptObjectsTest, WhatDoesNotCompileSaysSoEachTime) {
    add_to("steps/1_ray_casting/torus.cpp", "this is no C++\n");
    for (int i = 0; i < 2; ++i) {
        const Built built = submit(starter());
        EXPECT_FALSE(built.good);
        EXPECT_NE(built.message.find("steps/1_ray_casting/torus.cpp"), std::string::npos) << built.message;
    }
    EXPECT_TRUE(kept().empty());
}

}  // namespace
}  // namespace rays::grader
