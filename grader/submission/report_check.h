// What can be checked of a written report. The prose itself is for a person.
#pragma once

#include <string>
#include <vector>

#include "grader/submission/demonstrate.h"

namespace rays::grader {

/// The points of the report's row, by share: claims shown, commands that reproduce, words.
struct ReportShares {
    static constexpr double claims = 0.4, commands = 0.4, text = 0.2;
};

/// Three checks of kind "report", with `max` points together:
/// report.claims: every feature that submission.json claims is demonstrated by a picture;
/// report.commands: every picture has a command in the report, and every command reproduces the picture it names;
/// report.text: the prose names every picture and every claimed feature, says something, and is no template any more.
/// A report that is missing earns nothing in any of them.
std::vector<Check> report_checks(const HandInBench& bench, const std::vector<Demonstration>& pictures, double max);

}  // namespace rays::grader
