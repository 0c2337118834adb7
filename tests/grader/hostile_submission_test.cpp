// Hand-ins that are broken or hostile: every reader says what is wrong, and none believes a word.
#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "core/error.h"
#include "grader/submission/archive.h"
#include "grader/submission/format.h"
#include "grader/submission/report_text.h"
#include "grader/submission/safe_path.h"
#include "tools.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

// ---- names ----------------------------------------------------------------------------------------------------------

TEST(SafePathTest, PlainNamesOnly) {
    for (const char* good : {"a.png", "pictures/a.png", "1_ray_casting/x.cpp", "with space.png"})
        EXPECT_EQ(path_problem(good), "") << good;
    for (const std::string bad :
         {"", "/etc/passwd", "../a", "a/../../b", ".git/config", "a/.hidden", "a\\b", "a//b", "a/", "a\x1b[2J", "./a"})
        EXPECT_NE(path_problem(bad), "") << bad;
    EXPECT_NE(path_problem(std::string(5000, 'a')), "");
}

TEST(SafePathTest, ReadsNoLinksAndNoPipes) {
    const TemporaryFolder folder;
    const fs::path inside = folder.path() / "inside";
    fs::create_directories(inside / "sub");
    std::ofstream(inside / "sub" / "a.txt") << "content";
    std::ofstream(folder.path() / "secret.txt") << "secret";
    fs::create_symlink(folder.path() / "secret.txt", inside / "link.txt");
    fs::create_directory_symlink(folder.path(), inside / "door");
    ASSERT_EQ(::mkfifo((inside / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(read_inside(inside, "sub/a.txt", 100).bytes, "content");
    for (const char* bad : {"link.txt", "door/secret.txt", "../secret.txt", "pipe", "sub", "missing.txt"}) {
        const OutputFile file = read_inside(inside, bad, 100);
        EXPECT_FALSE(file.taken) << bad;
        EXPECT_EQ(file.bytes, "") << bad;
        EXPECT_NE(file.problem, "") << bad;
    }
    EXPECT_TRUE(has(read_inside(inside, "sub/a.txt", 3).problem, "more than the 3 allowed"));
}

// ---- submission.json ------------------------------------------------------------------------------------------------

std::string with_picture(const std::string& picture) { return R"({"version":1,"pictures":[)" + picture + "]}"; }

TEST(SubmissionFormatTest, AGoodOneIsRead) {
    const Submission s = parse_submission(with_picture(
        R"({"file":"submission/a.png","scene":"./scenes/1/x.pov","width":160,"height":120,"shows":["spheres","spheres"]})"));
    EXPECT_TRUE(s.problems.empty());
    ASSERT_EQ(s.pictures.size(), 1u);
    EXPECT_EQ(s.pictures[0].file, "a.png");
    EXPECT_EQ(s.pictures[0].scene, "scenes/1/x.pov");
    EXPECT_EQ(s.pictures[0].raster.width, 160);
    EXPECT_EQ(s.pictures[0].shows, std::vector<std::string>{"spheres"});
}

TEST(SubmissionFormatTest, WhatIsWrongIsSaid) {
    const std::pair<const char*, const char*> cases[] = {
        {"{", "not JSON"},
        {"[]", "\"version\": 1"},
        {R"({"version":2,"pictures":[]})", "\"version\": 1"},
        {R"({"version":1})", "a list \"pictures\""},
        {R"({"version":1,"pictures":[7]})", "is no object"},
        {R"({"version":1,"pictures":[{"file":"a.png"}]})", "has no \"scene\""},
        {R"({"version":1,"pictures":[{"file":"../../a.png","scene":"b.pov","width":1,"height":1,"shows":[]}]})",
         "leads outside"},
        {R"({"version":1,"pictures":[{"file":"a.png","scene":"/etc/passwd","width":1,"height":1,"shows":[]}]})",
         "is absolute"},
        {R"({"version":1,"pictures":[{"file":"a.sh","scene":"b.pov","width":1,"height":1,"shows":[]}]})",
         "does not end in .png or .exr"},
        {R"({"version":1,"pictures":[{"file":"a.png","scene":"b.pov","width":1e300,"height":1,"shows":[]}]})",
         "\"width\" is no whole number"},
        {R"({"version":1,"pictures":[{"file":"a.png","scene":"b.pov","width":-3,"height":1,"shows":[]}]})",
         "\"width\" is no whole number"},
        {R"({"version":1,"pictures":[{"file":"a.png","scene":"b.pov","width":2048,"height":2048,"shows":[]}]})",
         "has more than 1048576 pixels"},
        {R"({"version":1,"pictures":[{"file":"a.png","scene":"b.pov","width":1,"height":1,"shows":"all"}]})",
         "\"shows\" is no list"},
        {R"({"version":1,"pictures":[{"file":"a.png","scene":"b.pov","width":1,"height":1,"shows":[1]}]})", "no text"},
        {R"({"version":1,"pictures":[{"file":"a.png","scene":"b.pov","width":1,"height":1,"shows":[],"run":"x"}]})",
         "unknown field \"run\""},
    };
    for (const auto& [text, expected] : cases) {
        const Submission s = parse_submission(text);
        ASSERT_FALSE(s.problems.empty()) << text;
        EXPECT_TRUE(has(s.problems.front(), expected)) << text << " -> " << s.problems.front();
        EXPECT_TRUE(s.pictures.empty()) << text;
    }
}

TEST(SubmissionFormatTest, DeepOrLongOnesAreRefused) {
    EXPECT_FALSE(parse_submission(std::string(100000, '[')).problems.empty());
    std::string many;
    for (int i = 0; i < 100; ++i)
        many += std::string(i ? "," : "") + R"({"file":"a)" + std::to_string(i) +
                R"(.png","scene":"b.pov","width":1,"height":1,"shows":[]})";
    EXPECT_EQ(parse_submission(with_picture(many)).pictures.size(), kMostPictures);
}

// ---- archives -------------------------------------------------------------------------------------------------------

struct Member {
    std::string name, bytes{};
    unsigned type = AE_IFREG;
    std::string link{};
};

fs::path archive_of(const TemporaryFolder& folder, const std::vector<Member>& members, bool zip = false) {
    const fs::path file = folder.path() / (zip ? "x.zip" : "x.tar.gz");
    archive* writer = archive_write_new();
    if (zip) {
        archive_write_set_format_zip(writer);
    } else {
        archive_write_set_format_pax_restricted(writer);
        archive_write_add_filter_gzip(writer);
    }
    archive_write_open_filename(writer, file.c_str());
    for (const Member& m : members) {
        archive_entry* entry = archive_entry_new();
        archive_entry_set_pathname(entry, m.name.c_str());
        archive_entry_set_filetype(entry, m.type);
        archive_entry_set_perm(entry, 0644);
        archive_entry_set_size(entry, static_cast<la_int64_t>(m.bytes.size()));
        if (m.type == AE_IFLNK) archive_entry_set_symlink(entry, m.link.c_str());
        if (m.type == AE_IFREG && !m.link.empty()) archive_entry_set_hardlink(entry, m.link.c_str());
        archive_write_header(writer, entry);
        archive_write_data(writer, m.bytes.data(), m.bytes.size());
        archive_entry_free(entry);
    }
    archive_write_close(writer);
    archive_write_free(writer);
    return file;
}

std::string refusal(const std::vector<Member>& members, const ArchiveLimits& limits = {}) {
    const TemporaryFolder from, into;
    try {
        unpack(archive_of(from, members), into.path(), limits);
    } catch (const InputError& e) {
        return e.what();
    }
    return "";
}

TEST(ArchiveTest, GoodOnesAreUnpackedAsTarAndAsZip) {
    for (const bool zip : {false, true}) {
        const TemporaryFolder from, into;
        const fs::path file = archive_of(from,
                                         {{"./me/1_ray_casting/a.cpp", "code"},
                                          {"me/submission.json", "{}"},
                                          {"me/.git/x", "no"},
                                          {"__MACOSX/y", "no"}},
                                         zip);
        const fs::path folder = unpack(file, into.path());
        EXPECT_EQ(read_file(folder / "1_ray_casting" / "a.cpp"), "code");
        EXPECT_EQ(read_file(folder / "submission.json"), "{}");
        EXPECT_FALSE(fs::exists(folder / ".git"));
    }
}

TEST(ArchiveTest, HostileOnesAreRefused) {
    EXPECT_TRUE(has(refusal({{"../outside.txt", "x"}}), "leads outside"));
    EXPECT_TRUE(has(refusal({{"a/../../outside.txt", "x"}}), "leads outside"));
    EXPECT_TRUE(has(refusal({{"/tmp/absolute.txt", "x"}}), "absolute"));
    EXPECT_TRUE(has(refusal({{"link", "", AE_IFLNK, "/etc"}, {"link/passwd", "x"}}), "is a link"));
    EXPECT_TRUE(has(refusal({{"hard", "", AE_IFREG, "/etc/passwd"}}), "is a link"));
    EXPECT_TRUE(has(refusal({{"device", "", AE_IFCHR}}), "is a link or something else"));
    EXPECT_TRUE(has(refusal({{"a", "1"}, {"a", "2"}}), "twice"));
    EXPECT_TRUE(has(refusal({{"a", "1"}, {"b", "2"}, {"c", "3"}}, {2, 100}), "more than 2 entries"));
    EXPECT_TRUE(has(refusal({{"bomb", std::string(1 << 20, '\0')}}, {10, 1000}), "more bytes"));
    EXPECT_TRUE(has(refusal({}), "empty"));
}

TEST(ArchiveTest, WhatIsNoArchiveIsRefused) {
    const TemporaryFolder folder, into;
    std::ofstream(folder.path() / "x.zip") << "PK\x03\x04 this is no archive";
    EXPECT_THROW(unpack(folder.path() / "x.zip", into.path()), InputError);
    std::ofstream(folder.path() / "y.tar.gz") << std::string(100000, 'x');
    EXPECT_THROW(unpack(folder.path() / "y.tar.gz", into.path()), InputError);
}

TEST(ArchiveTest, PackedTwiceIsTheSameAndComesBack) {
    const TemporaryFolder folder, into;
    write_atomically(folder.path() / "a" / "b.txt", "text");
    pack(folder.path(), {"a/b.txt"}, folder.path() / "1.tar.gz");
    pack(folder.path(), {"a/b.txt"}, folder.path() / "2.tar.gz");
    EXPECT_EQ(read_file(folder.path() / "1.tar.gz"), read_file(folder.path() / "2.tar.gz"));
    EXPECT_EQ(read_file(unpack(folder.path() / "1.tar.gz", into.path()) / "b.txt"), "text")
        << "the only folder is the submission";
}

// ---- report.md ------------------------------------------------------------------------------------------------------

TEST(ReportTextTest, CommandsAreReadFromCodeBlocksOnly) {
    const ReportText r = read_report(
        "# Title\n./rays render a.pov -o not.png\n```sh\n$ ./rays render scenes/1/x.pov -o submission/a.png --from "
        "student "
        "--width=160 --height 120\nls -l\nrays render my.pov --output b.exr --without phong\n```\nMore words.\n");
    ASSERT_EQ(r.commands.size(), 2u);
    EXPECT_EQ(r.commands[0].problem, "");
    EXPECT_EQ(r.commands[0].line, 4);
    EXPECT_EQ(r.commands[0].scene, "scenes/1/x.pov");
    EXPECT_EQ(r.commands[0].output, "a.png");
    EXPECT_EQ(r.commands[0].raster.width, 160);
    EXPECT_EQ(r.commands[1].raster.width, 320) << "the program's own size";
    EXPECT_EQ(r.commands[1].options, (std::vector<std::string>{"--without", "phong"}));
    EXPECT_TRUE(has(r.prose, "More words") && !has(r.prose, "ls -l"));
}

TEST(ReportTextTest, WhatAShellWouldRunIsRefused) {
    for (const char* bad :
         {"./rays render a.pov -o b.png; rm -rf x", "./rays render a.pov -o $(id).png",
          "./rays render a.pov -o b.png | sh", "./rays render `id` -o b.png", "./rays render a.pov -o ../b.png",
          "./rays render /etc/passwd -o b.png", "./rays render a.pov -o b.png --stats x",
          "./rays render a.pov -o b.png --answer", "./rays render a.pov -o b.png --from solution",
          "./rays render a.pov -o b.png --width 99999999999", "./rays render a.pov -o b.png --width -1",
          "./rays render a.pov b.pov -o b.png", "./rays render a.pov", "./rays render -o b.png",
          "./rays render a.pov -o", "./rays render a.pov -o b.png --samples 4096",
          "./rays render a.pov -o b.png --width 2048 --height 2048"})
        EXPECT_NE(parse_command(bad).problem, "") << bad;
}

TEST(ReportTextTest, HugeOnesAreCut) {
    std::string text = "```\n";
    for (int i = 0; i < 100000; ++i) text += "./rays render a.pov -o b.png\n";
    const ReportText r = read_report(text);
    EXPECT_EQ(r.commands.size(), kMostCommands);
    EXPECT_LT(read_report(std::string(50'000'000, 'x')).prose.size(), kLargestReport + 10);
}

}  // namespace
}  // namespace rays::grader
