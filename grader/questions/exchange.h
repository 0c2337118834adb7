// Questions and answers as text (ARCHITECTURE.md, "Questions and answers").
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "questions.h"

namespace rays::grader {

/// One line of a reply. "hit 1 2 3", "miss", "unfinished 1.3", "error ...", or numbers; anything else is an error.
Answer parse_answer(std::string_view line);

/// The question blocks for a render program's --answer: equal scenes in a row are sent once.
std::string question_text(const std::vector<const Question*>& questions);

}  // namespace rays::grader
