#include "grader/sandbox.h"

#include <gtest/gtest.h>

#include "tools.h"

namespace rays::grader {
namespace {

class SandboxTest : public testing::Test {
protected:
    TemporaryFolder folder;
    std::unique_ptr<Sandbox> sandbox = make_sandbox();

    JobResult run(const std::string& text) const {
        Job job;
        job.program = script(folder, text);
        job.files = {{"scene.pov", "sphere"}, {"parts/more.inc", "more"}};
        job.outputs = {"out.exr"};
        job.limits.output_mb = 1;
        return sandbox->run(job);
    }
    OutputFile output(const std::string& text) const { return run(text).files.at("out.exr"); }
};

TEST_F(SandboxTest, SaysItsTier) { EXPECT_EQ(sandbox->tier(), "limits"); }

TEST_F(SandboxTest, FilesGoInAndOneComesOut) {
    const OutputFile file = output("cat scene.pov parts/more.inc > out.exr");
    EXPECT_TRUE(file.taken) << file.problem;
    EXPECT_EQ(file.bytes, "spheremore");
}

TEST_F(SandboxTest, TheFolderHoldsNothingElseAndIsGoneAfterwards) {
    const JobResult result = run("ls; pwd");
    const std::string& out = result.ended.out;
    EXPECT_EQ(out.substr(0, out.find('/')), "parts\nscene.pov\n");
    const std::string folder_name = out.substr(out.find('/'), out.find_last_not_of('\n') - out.find('/') + 1);
    EXPECT_FALSE(std::filesystem::exists(folder_name)) << folder_name;
}

TEST_F(SandboxTest, ReferencesAreNotInReachByRelativePath) {
    const JobResult result =
        run("cat references/*.exr ../references/*.exr ../../scenes/references/*.exr scenes/references/*.exr > out.exr");
    EXPECT_FALSE(result.files.at("out.exr").taken);
    EXPECT_EQ(result.files.at("out.exr").problem, "is empty");
}

TEST_F(SandboxTest, MissingAndEmptyFilesAreToldApart) {
    EXPECT_EQ(output(":").problem, "was not written");
    EXPECT_EQ(output("> out.exr").problem, "is empty");
}

TEST_F(SandboxTest, LinksPipesAndFoldersAreRefused) {
    EXPECT_EQ(output("ln -s /etc/passwd out.exr").problem, "is a symbolic link");
    EXPECT_EQ(output("echo x > other; ln other out.exr").problem, "is a link to another file");
    EXPECT_EQ(output("mkfifo out.exr").problem, "is not a regular file");
    EXPECT_EQ(output("mkdir out.exr").problem, "is not a regular file");
}

TEST_F(SandboxTest, HugeFilesAreRefused) {
    const OutputFile file = output("truncate -s 1M out.exr; echo x >> out.exr || true");
    EXPECT_LE(file.bytes.size(), 1u << 20);
    // A sparse file is as long as it says.
    EXPECT_FALSE(run("truncate -s 100G out.exr").files.at("out.exr").taken);
}

TEST_F(SandboxTest, AProgramThatIsNotThereIsNobodysCrash) {
    Job job;
    job.program = "/no/such/program";
    const JobResult result = sandbox->run(job);
    EXPECT_FALSE(result.ended.started);
    EXPECT_FALSE(result.ended.problem.empty());
}

TEST_F(SandboxTest, InputNamesMustStayInside) {
    Job job;
    job.program = "/bin/true";
    job.files = {{"../outside.inc", "x"}};
    EXPECT_FALSE(sandbox->run(job).ended.started);
}

}  // namespace
}  // namespace rays::grader
