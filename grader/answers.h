// Asking a render program questions, and reading its answers as hostile text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/sandbox.h"
#include "questions/exchange.h"

namespace rays::grader {

struct Replies {
    std::vector<Answer> answers;  ///< one for each question; kind `missing` or `lost` where none came
    Ended ended;                  ///< of the first run that failed, else of the last run
    std::string problem;          ///< why answers are missing, for the student; empty when none is
    bool infrastructure = false;  ///< the program could not be started: nobody's wrong answer
};

/// An answer for a message; where none came, why: "no answer (the program had crashed)".
std::string shown_answer(const Answer& answer, const Replies& replies, std::size_t limit);

/// The task that the first unfinished answer names; empty when none does.
std::string unfinished_task(const std::vector<Answer>& answers);

/// Asks all of them. When the program crashes or hangs, the questions without an answer are asked once more one by
/// one, so that a crash costs the question that caused it. After four such losses, or two of a task among several, no
/// more is asked: the rest stays without an answer.
Replies ask(const Sandbox& sandbox, const std::filesystem::path& program, const std::vector<const Question*>& questions,
            const Limits& limits);

}  // namespace rays::grader
