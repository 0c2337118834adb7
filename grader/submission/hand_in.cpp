#include "grader/submission/hand_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "core/error.h"
#include "grader/submission/archive.h"
#include "grader/submission/handed_in.h"
#include "grader/submission/template.h"
#include "grader/text.h"
#include "grader/verdicts.h"
#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

void write_templates(const fs::path& folder, HandInResult& result) {
    const auto write = [&](const char* name, const std::string& text) {
        if (fs::exists(folder / name)) return;
        write_atomically(folder / name, text);
        result.made.emplace_back(name);
    };
    write(kSubmissionFile, submission_template());
    write(kReportFile, report_template(read_submission(folder).pictures));
}

/// The picture as the student's program writes it. Returns why there is none; empty when there is one.
std::string render(const HandInBench& bench, const SubmittedPicture& picture) {
    Job job;
    try {
        job.files = submitted_scene(bench, picture.scene);
    } catch (const InputError& e) {
        return e.what();
    }
    const std::string name = "picture" + fs::path(picture.file).extension().string();
    job.program = bench.student;
    job.limits = bench.limits;
    job.arguments = {job.files.front().name,
                     "-o",
                     name,
                     "--width",
                     std::to_string(picture.raster.width),
                     "--height",
                     std::to_string(picture.raster.height),
                     "--threads",
                     "1"};
    job.outputs = {name};
    JobResult result = bench.sandbox.run(job);
    if (const auto against = against_run(result.ended)) return against->message;
    if (!result.files[name].taken) return "the picture " + result.files[name].problem;
    write_atomically(bench.folder / picture.file, result.files[name].bytes);
    return {};
}

std::vector<std::string> step_files(const fs::path& steps) {
    std::vector<std::string> files;
    for (const Step& step : read_steps(steps))
        for (const auto& entry : fs::directory_iterator(steps / step.id))
            if (entry.is_regular_file() && entry.path().extension() == ".cpp")
                files.push_back(step.id + "/" + entry.path().filename().string());
    std::sort(files.begin(), files.end());
    return files;
}

/// Everything that is handed in, gathered in one folder.
class Gathering {
public:
    explicit Gathering(fs::path folder) : folder_(std::move(folder)) {}

    void add(const std::string& name, const std::string& bytes) {
        if (std::find(files.begin(), files.end(), name) != files.end()) return;
        write_atomically(folder_ / name, bytes);
        files.push_back(name);
    }
    void copy(const fs::path& from, const std::string& name) {
        if (fs::is_regular_file(from / name)) add(name, read_file(from / name));
    }

    std::vector<std::string> files;

private:
    fs::path folder_;
};

void gather(const HandInBench& bench, const WorkingCopy& copy, Gathering& gathering) {
    for (const std::string& file : step_files(copy.steps)) gathering.copy(copy.steps, file);
    for (const char* name : {kSubmissionFile, kReportFile}) gathering.copy(copy.submission, name);
    for (const SubmittedPicture& p : read_submission(copy.submission).pictures) {
        gathering.copy(copy.submission, p.file);
        if (!fs::is_regular_file(copy.submission / p.scene)) continue;  // the course's
        const fs::path beside = fs::path(p.scene).parent_path();
        try {
            for (const InputFile& file : submitted_scene(bench, p.scene))
                gathering.add((beside / file.name).string(), file.bytes);
        } catch (const InputError&) {
            gathering.copy(copy.submission, p.scene);  // its includes are missing: the check has said so
        }
    }
}

void check_target(const fs::path& out) {
    if (fs::exists(out) && !fs::is_directory(out))
        throw InputError(out.string() + ": is no folder, and does not end in .tar.gz");
    if (fs::is_directory(out) && !fs::is_empty(out) && !fs::exists(out / kSubmissionFile))
        throw InputError(out.string() + ": holds something else than an earlier hand-in; name a new folder");
}

bool is_archive(const fs::path& out) { return out.string().ends_with(".tar.gz"); }

void put(const fs::path& gathered, const std::vector<std::string>& files, const fs::path& out) {
    if (is_archive(out)) return pack(gathered, files, out);
    for (const std::string& name : files) write_atomically(out / name, read_file(gathered / name));
}

}  // namespace

WorkingCopy working_copy(const Project& project) {
    return {project.steps(), project.root / "submission", project.program("render-student")};
}

HandInResult hand_in(const Project& project, const WorkingCopy& copy, const fs::path& out) {
    if (!fs::exists(copy.program)) throw InputError(copy.program.string() + " is not built");
    if (!is_archive(out)) check_target(out);
    HandInResult result;
    fs::create_directories(copy.submission);
    write_templates(copy.submission, result);
    const auto sandbox = make_sandbox();
    Limits limits;
    if (project.sanitized()) limits.memory_mb = 0;
    const int workers = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const HandInBench bench{project, *sandbox, project.program("render-solution"), copy.program, copy.submission, {},
                            limits,  workers};
    for (const SubmittedPicture& picture : read_submission(copy.submission).pictures)
        if (const std::string why = render(bench, picture); !why.empty())
            result.failed.push_back(fmt::format("{} was not rendered: {}", picture.file, why));
    result.checked = grade_handed_in(bench, read_rubric(project.root / "grader" / "rubric.json"));
    const TemporaryFolder scratch;
    Gathering gathering(scratch.path());
    gather(bench, copy, gathering);
    put(scratch.path(), gathering.files, out);
    result.packed = gathering.files;
    return result;
}

bool is_complete(const HandInResult& result) {
    return std::all_of(result.checked.checks.begin(), result.checked.checks.end(),
                       [](const Check& c) { return c.verdict == Verdict::pass; });
}

std::string hand_in_text(const HandInResult& result, const fs::path& out) {
    std::string text;
    for (const std::string& name : result.made)
        text += fmt::format("submission/{} was missing: a template has been written, please edit it\n", name);
    for (const std::string& failure : result.failed) text += plain(failure, 400) + "\n";
    for (const Check& c : result.checked.checks) {
        text += fmt::format("{:<14} {}{}\n", to_string(c.verdict), plain(c.title, 60),
                            c.max > 0 ? fmt::format("  ({:.4g} of {:.4g} points)", c.points, c.max) : std::string());
        if (c.verdict != Verdict::pass) text += fmt::format("               {}\n", plain(c.message, 500));
        for (const Diagnosis& d : c.diagnosis) text += fmt::format("               {}\n", plain(d.text, 300));
    }
    text += fmt::format("Pictures and report: {:.4g} of {:.4g} points. {}\n", result.checked.points, result.checked.max,
                        is_complete(result) ? "Nothing is missing." : "What is not passed above is missing or wrong.");
    return text + fmt::format("{} files are in {}; your steps are graded with ./rays grade --submission {}\n",
                              result.packed.size(), out.string(), out.string());
}

}  // namespace rays::grader
