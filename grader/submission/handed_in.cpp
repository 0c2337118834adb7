#include "grader/submission/handed_in.h"

#include <fmt/format.h>

#include <algorithm>

#include "grader/submission/report_check.h"
#include "grader/submission/report_text.h"
#include "grader/submission/safe_path.h"
#include "grader/text.h"
#include "grader/verdicts.h"
#include "references/in_parallel.h"

namespace rays::grader {
namespace {

constexpr std::size_t kShownReport = 40'000;

const RubricRow* find_row(const Rubric& rubric, const std::string& id) {
    const auto found =
        std::find_if(rubric.rows.begin(), rubric.rows.end(), [&](const RubricRow& r) { return r.id == id; });
    return found == rubric.rows.end() ? nullptr : &*found;
}

std::vector<Demonstration> demonstrations(const HandInBench& bench, const std::vector<SubmittedPicture>& pictures) {
    std::vector<Demonstration> results(pictures.size());
    in_parallel(pictures.size(), bench.workers, [&](std::size_t i) {
        try {
            results[i] = demonstrate(bench, pictures[i], i + 1);
        } catch (const std::exception& e) {
            results[i].picture = pictures[i];
            results[i].check.id = fmt::format("handed_in.{}", i + 1);
            results[i].check.kind = "demonstration";
            results[i].check.title = plain(pictures[i].file);
            results[i].check.verdict = Verdict::infrastructure_error;
            results[i].check.message = e.what();
        }
    });
    return results;
}

// Why a picture does not show the feature, for whoever claimed it.
std::string objection(const Demonstration& d, const std::string& feature) {
    for (const Proof& p : d.proofs)
        if (p.feature == feature) return fmt::format("{}, need {}", p.found, p.expected);
    return d.check.message;
}

Check feature_check(const std::vector<Demonstration>& pictures, const std::string& feature, double max) {
    Check check;
    check.id = "pictures." + feature;
    check.kind = "demonstration";
    check.mode = "all mine";
    check.title = feature;
    std::replace(check.title.begin(), check.title.end(), '_', ' ');
    check.title += " demonstrated";
    check.max = max;
    check.reproduce = "./rays submission";
    check.verdict = Verdict::not_started;
    check.message = "no picture in submission.json claims to show " + feature;
    for (const Demonstration& d : pictures) {
        if (std::find(d.picture.shows.begin(), d.picture.shows.end(), feature) == d.picture.shows.end()) continue;
        for (const Proof& p : d.proofs) {
            if (p.feature != feature || !p.shown) continue;
            check.verdict = Verdict::pass;
            check.points = max;
            check.message = fmt::format("shown by {}: {} ({})", plain(d.picture.file), p.found, p.how);
            return check;
        }
        check.message = check.verdict == Verdict::fail ? check.message + "; " : std::string();
        check.verdict = Verdict::fail;
        check.message += fmt::format("{} does not show it: {}", plain(d.picture.file), objection(d, feature));
    }
    return check;
}

std::string report_text(const std::filesystem::path& folder) {
    std::string text = read_inside(folder, kReportFile, kLargestReport).bytes.substr(0, kShownReport);
    // Escape sequences and the like; letters of any language stay. The page shows all of it as text.
    std::erase_if(text, [](char c) { return (c >= 0 && c < 0x20 && c != '\n' && c != '\t') || c == 0x7f; });
    return text;
}

Check format_check(const Submission& submission) {
    Check check;
    check.id = "handed_in.format";
    check.kind = "report";
    check.mode = "all mine";
    check.title = kSubmissionFile;
    check.reproduce = "./rays submission";
    check.verdict = submission.problems.empty() ? Verdict::pass
                    : submission.present        ? Verdict::fail
                                                : Verdict::not_started;
    check.message = fmt::format("{} pictures", submission.pictures.size());
    if (!submission.problems.empty()) check.message.clear();
    for (const std::string& p : submission.problems) check.message += (check.message.empty() ? "" : "; ") + p;
    return check;
}

}  // namespace

std::string row_of(const Check& check) {
    for (const char* row : {"pictures", "report"})
        if (check.id.starts_with(std::string(row) + ".")) return row;
    return {};
}

HandedIn grade_handed_in(const HandInBench& bench, const Rubric& rubric) {
    HandedIn result;
    const Submission submission = read_submission(bench.folder);
    const auto pictures = demonstrations(bench, submission.pictures);
    if (const RubricRow* row = find_row(rubric, "pictures"))
        for (const std::string& feature : row->shows)
            result.checks.push_back(feature_check(pictures, feature, row->points / double(row->shows.size())));
    if (const RubricRow* row = find_row(rubric, "report"))
        for (const Check& check : report_checks(bench, pictures, row->points)) result.checks.push_back(check);
    result.checks.push_back(format_check(submission));
    for (const Demonstration& d : pictures) result.checks.push_back(d.check);
    std::vector<Verdict> verdicts;
    for (const Check& c : result.checks) {
        verdicts.push_back(c.verdict);
        result.points += c.points;
        result.max += c.max;
    }
    result.verdict = combine(verdicts);
    // It is a step that does not build; here this is a picture that cannot be rendered again.
    if (result.verdict == Verdict::build_error) result.verdict = Verdict::fail;
    result.report = report_text(bench.folder);
    return result;
}

}  // namespace rays::grader
