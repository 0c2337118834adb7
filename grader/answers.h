// Asking a render program questions, and reading its answers as hostile text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grader/questions.h"
#include "grader/sandbox.h"

namespace rays::grader {

/// One line of a reply. "hit 1 2 3", "miss", "unfinished 1.3", "error ...", or numbers; anything else is an error.
Answer parse_answer(std::string_view line);

/// The question blocks for a render program's --answer: equal scenes in a row are sent once.
std::string question_text(const std::vector<const Question*>& questions);

struct Replies {
    std::vector<Answer> answers;  ///< one for each question; kind `missing` where none came
    Ended ended;                  ///< of the first run that failed, else of the last run
    std::string problem;          ///< why answers are missing, for the student; empty when none is
    bool infrastructure = false;  ///< the program could not be started: nobody's wrong answer
};

/// Asks all of them. When the program crashes or hangs, the questions without an answer are asked once more one by
/// one, so that a crash costs the question that caused it; after four such losses the rest counts as lost, too.
Replies ask(const Sandbox& sandbox, const std::filesystem::path& program, const std::vector<const Question*>& questions,
            const Limits& limits);

}  // namespace rays::grader
