// The grader's questions, asked in this very process: a debugger can stop at the mistake.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "questions.h"
#include "renderer/answer.h"

namespace rays::tests {

/// As the grader reads a line: numbers, or "hit" and numbers, or a word.
inline grader::Answer parsed(const std::string& line) {
    using Kind = grader::Answer::Kind;
    grader::Answer answer;
    answer.text = line;
    std::istringstream in(line);
    std::string word;
    answer.kind = in >> word ? Kind::value : Kind::missing;
    if (word == "miss") answer.kind = Kind::miss;
    if (word == "unfinished") answer.kind = Kind::unfinished;
    if (word == "hit") in >> word;
    while (answer.kind == Kind::value) {
        char* end = nullptr;
        answer.numbers.push_back(std::strtod(word.c_str(), &end));
        if (*end != '\0') answer.kind = Kind::error;
        if (!(in >> word)) break;
    }
    return answer;
}

/// One answer for each question.
inline std::vector<grader::Answer> asked(const std::vector<grader::Question>& questions) {
    std::ostringstream text;
    std::string scene;
    for (const grader::Question& q : questions) {
        if (q.scene != scene) text << "scene " << q.scene.size() << '\n' << q.scene;
        scene = q.scene;
        text << q.query << '\n';
    }
    std::istringstream in(text.str());
    std::stringstream out;
    answer_questions(in, out);
    std::vector<grader::Answer> answers;
    for (std::string line; std::getline(out, line);) answers.push_back(parsed(line));
    answers.resize(questions.size());
    return answers;
}

inline void expect_all_right(const std::vector<grader::Question>& questions, const std::string& where) {
    const std::vector<grader::Answer> answers = asked(questions);
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const auto judgement = questions[i].judge(answers[i]);
        EXPECT_TRUE(judgement.ok) << where << ", task " << questions[i].task << ": " << questions[i].about << '\n'
                                  << questions[i].scene << questions[i].query << "\nexpected " << judgement.expected
                                  << ", got " << answers[i].text;
    }
}

}  // namespace rays::tests
