#include "grader/submission/report_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "core/error.h"
#include "grader/submission/looks.h"
#include "grader/submission/report_text.h"
#include "grader/submission/safe_path.h"
#include "grader/text.h"

namespace rays::grader {
namespace {

constexpr int kLeastWords = 60;  ///< a paragraph: less cannot say what was implemented and how

Check check_of(const std::string& id, const std::string& title, double max) {
    Check check;
    check.id = "report." + id;
    check.kind = "report";
    check.mode = "all mine";
    check.title = title;
    check.max = max;
    check.reproduce = "./rays submission";
    return check;
}

/// Points by the share of its questions that are right; without any there is nothing to earn.
Check judged(Check check, const std::string& good, const std::string& nothing) {
    const auto right =
        std::count_if(check.questions.begin(), check.questions.end(), [](const AskedQuestion& q) { return q.ok; });
    const auto all = static_cast<std::ptrdiff_t>(check.questions.size());
    check.points = all ? check.max * double(right) / double(all) : 0;
    check.verdict = all == 0       ? Verdict::not_started
                    : right == all ? Verdict::pass
                    : right        ? Verdict::partial
                                   : Verdict::fail;
    check.message = all == 0 ? nothing : fmt::format("{} of {} {}", right, all, good);
    for (const AskedQuestion& q : check.questions)
        if (!q.ok && check.message.size() < 300) check.message += fmt::format("; {}: {}", q.about, q.answer);
    return check;
}

std::set<std::string> claimed(const std::vector<Demonstration>& pictures) {
    std::set<std::string> features;
    for (const Demonstration& d : pictures) features.insert(d.picture.shows.begin(), d.picture.shows.end());
    return features;
}

Check claims_check(const std::vector<Demonstration>& pictures, double max) {
    Check check = check_of("claims", "Every claimed feature is demonstrated", max);
    for (const std::string& feature : claimed(pictures)) {
        std::string by;
        for (const Demonstration& d : pictures)
            for (const Proof& p : d.proofs)
                if (by.empty() && p.feature == feature && p.shown) by = plain(d.picture.file);
        check.questions.push_back(
            {feature, "", "", "a picture that counts shows it", by.empty() ? "none does" : by, !by.empty()});
    }
    return judged(check, "claimed features are demonstrated", "nothing is claimed in submission.json");
}

/// Commands against the pictures that they name.
class CommandChecker {
public:
    CommandChecker(const HandInBench& bench, const std::vector<Demonstration>& pictures)
        : bench_(bench), pictures_(pictures) {}

    std::vector<AskedQuestion> judge(const std::vector<RenderCommand>& commands) {
        std::vector<AskedQuestion> questions;
        std::set<std::string> named;
        for (const RenderCommand& command : commands) {
            named.insert(command.output);
            const std::string found = outcome(command);
            questions.push_back({fmt::format("line {}", command.line), command.text, "", "reproduces its picture",
                                 found.empty() ? "it does" : found, found.empty()});
        }
        for (const Demonstration& d : pictures_)
            if (!named.count(d.picture.file))
                questions.push_back(
                    {plain(d.picture.file), "", "", "a command in a code block of report.md", "there is none", false});
        return questions;
    }

private:
    /// What is wrong; empty when the picture is reproduced.
    std::string outcome(const RenderCommand& command) const {
        if (!command.problem.empty()) return command.problem;
        const auto found = std::find_if(pictures_.begin(), pictures_.end(),
                                        [&](const Demonstration& d) { return d.picture.file == command.output; });
        if (found == pictures_.end()) return "submission.json does not list this picture";
        const SubmittedPicture& p = found->picture;
        const Raster raster = command.raster;
        if (raster.width != p.raster.width || raster.height != p.raster.height)
            return fmt::format("renders {} x {} pixels; the picture has {} x {}", raster.width, raster.height,
                               p.raster.width, p.raster.height);
        // The same command as the demonstration's has been tried already.
        if (command.scene == p.scene && command.options.empty())
            return found->reproduced ? "" : "does not reproduce it: " + found->check.message;
        return rendered(command, p);
    }

    std::string rendered(const RenderCommand& command, const SubmittedPicture& p) const {
        if (bench_.student.empty()) return "your steps do not build";
        try {
            const SceneFiles files = submitted_scene(bench_, command.scene);
            const Shot shot = shoot(bench_.sandbox, bench_.student, files, p.raster, bench_.limits, command.options);
            if (shot.against) return shot.against->message;
            const OutputFile file = read_inside(bench_.folder, p.file, kLargestPicture);
            if (!file.taken) return plain(p.file) + " " + file.problem;
            const Likeness like = likeness(p.file, file.bytes, shot.picture);
            if (!like.problem.empty()) return plain(p.file) + " " + like.problem;
            return like.same()
                       ? ""
                       : fmt::format("renders another picture: {} of {} pixels differ", like.differing, like.pixels);
        } catch (const InputError& e) {
            return plain(e.what(), 300);
        }
    }

    const HandInBench& bench_;
    const std::vector<Demonstration>& pictures_;
};

Check commands_check(const HandInBench& bench, const std::vector<Demonstration>& pictures, const ReportText& report,
                     double max) {
    Check check = check_of("commands", "Every command reproduces its picture", max);
    check.questions = CommandChecker(bench, pictures).judge(report.commands);
    return judged(check, "commands and pictures go together", "there are neither pictures nor commands");
}

/// Small letters, with spaces for what is neither letter nor digit, so that "recursive reflection" and
/// "recursive_reflection" are the same.
std::string plain_words(const std::string& text) {
    std::string result = " ";
    for (const char c : text) {
        const auto u = static_cast<unsigned char>(c);
        if (std::isalnum(u) || u >= 0x80)
            result += static_cast<char>(std::tolower(u));
        else if (result.back() != ' ')
            result += ' ';
    }
    return result.back() == ' ' ? result : result + ' ';
}

int count_words(const std::string& words) { return static_cast<int>(std::count(words.begin(), words.end(), ' ')) - 1; }

Check text_check(const std::vector<Demonstration>& pictures, const ReportText& report, double max) {
    Check check = check_of("text", "The prose says what was done and which picture shows it", max);
    const std::string words = plain_words(report.prose);
    const auto ask = [&](const std::string& about, const std::string& expected, const std::string& answer, bool ok) {
        check.questions.push_back({about, "", "", expected, answer, ok});
    };
    const int count = std::max(0, count_words(words));
    ask("length", fmt::format("at least {} words outside of code blocks", kLeastWords), fmt::format("{} words", count),
        count >= kLeastWords);
    ask("template", "nothing left to be written",
        report.to_be_written.empty() ? "nothing"
                                     : fmt::format("line {} is the template's", report.to_be_written.front()),
        report.to_be_written.empty());
    const auto named = [&](const std::string& name) { return words.find(plain_words(name)) != std::string::npos; };
    for (const Demonstration& d : pictures) {
        const std::string name = std::filesystem::path(d.picture.file).filename().string();
        ask(plain(name), "named in the prose", named(name) ? "named" : "not named", named(name));
    }
    for (const std::string& feature : claimed(pictures))
        ask(feature, "named in the prose", named(feature) ? "named" : "not named", named(feature));
    return judged(check, "points of form are met", "");
}

}  // namespace

std::vector<Check> report_checks(const HandInBench& bench, const std::vector<Demonstration>& pictures, double max) {
    const OutputFile file = read_inside(bench.folder, kReportFile, kLargestReport);
    if (!file.taken) {
        Check check = check_of("text", "A written report", max);
        check.verdict = file.problem == "was not found" ? Verdict::not_started : Verdict::fail;
        check.message = fmt::format("{} {}", kReportFile, file.problem);
        return {check};
    }
    const ReportText report = read_report(file.bytes);
    return {claims_check(pictures, max * ReportShares::claims),
            commands_check(bench, pictures, report, max * ReportShares::commands),
            text_check(pictures, report, max * ReportShares::text)};
}

}  // namespace rays::grader
