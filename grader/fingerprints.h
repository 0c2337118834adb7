// What each mutant answers to a fixed set of questions, and which mutant a student's answers look like.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grader/questions.h"
#include "grader/results.h"

namespace rays::grader {

/// Questions of a step that never change: fixed seed, probes through fresh scenes included.
std::vector<Question> diagnostic_questions(int step, const std::vector<std::string>& tasks);

/// Which questions were asked, as one number: fingerprints of other questions are of no use.
std::string questions_hash(const std::vector<Question>& questions);

/// A program's answers where they differ from the solution's: number of the question -> answer, shortened.
using Fingerprint = std::map<int, std::string>;

/// "none" for a question on which the program crashes, hangs or fails. What is unfinished, or was not asked for after
/// too many losses, is not part of it.
Fingerprint fingerprint(const std::vector<Answer>& answers, const std::vector<Answer>& solution);

/// The numbers of the questions whose task is not written yet.
std::set<int> unfinished_questions(const std::vector<Answer>& answers);

struct KnownMutant {
    std::string id, task, title, seen;
    Fingerprint fingerprint;
};

struct StepFingerprints {
    std::string questions;  ///< questions_hash
    std::vector<KnownMutant> mutants;
    std::map<std::string, std::vector<ChartSeries>> naive;  ///< by sweep: what naive methods reach
};

struct Fingerprints {
    std::map<int, StepFingerprints> steps;
};

Fingerprints read_fingerprints(const std::filesystem::path& file);
void write_fingerprints(const Fingerprints& fingerprints, const std::filesystem::path& file);

/// The one mutant that explains the answers: it shares nine tenths of its own differences with them, half of theirs
/// with its own, and no other mutant comes as near. Mutants are finished programs: `unfinished` questions, to which the
/// student has no answer yet, are left out of theirs.
std::optional<KnownMutant> nearest_mutant(const Fingerprint& student, const std::vector<KnownMutant>& mutants,
                                          const std::set<int>& unfinished = {});

}  // namespace rays::grader
