// Questions as they are made up, one scene after another.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "questions.h"

namespace rays::grader {

using Judge = std::function<Judgement(const Answer&)>;

/// Takes down questions of one task.
class BasicNotebook {
public:
    explicit BasicNotebook(std::string task) : task_(std::move(task)) {}

    void scene(std::string sdl) { scene_ = std::move(sdl); }
    void ask(std::string query, std::string about, Judge judge) {
        questions_.push_back({task_, scene_, std::move(query), std::move(about), std::move(judge)});
    }
    std::vector<Question> take() { return std::move(questions_); }

private:
    std::string task_, scene_;
    std::vector<Question> questions_;
};

}  // namespace rays::grader
