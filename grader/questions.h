// Questions to a student's program whose truth is known by construction.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace rays::grader {

/// One line of a program's reply.
struct Answer {
    enum class Kind { value, miss, unfinished, error, missing, lost };
    /// missing: the process ended or timed out before it; lost: it did so when asked this question alone
    Kind kind = Kind::missing;
    std::vector<double> numbers;  ///< value: all numbers of the line, the word "hit" left out
    std::string text;             ///< the line as it came: hostile

    bool came() const { return kind != Kind::missing && kind != Kind::lost; }
};

struct Judgement {
    bool ok = false;
    double error = 0;      ///< what a sweep charts; infinity for a wrong kind of answer
    std::string expected;  ///< in words or numbers, for the report
};

/// A query in the language of ARCHITECTURE.md ("Questions and answers") and who can tell whether the answer is right.
struct Question {
    std::string task;   ///< "1.3"
    std::string scene;  ///< SDL
    std::string query;  ///< one line
    std::string about;  ///< the claim, e.g. "origin inside the sphere: the far root"
    std::function<Judgement(const Answer&)> judge;
};

/// Stability: the same question over decades of a parameter.
struct Sweep {
    struct Point {
        double x = 0;
        std::vector<Question> questions;
    };
    std::string id;  ///< "1.3.distance"
    std::string task;
    std::string title, x_label, y_label;
    bool log_x = true, log_y = true;    ///< a linear y axis: the share of wrong answers to yes-or-no questions
    double pass_from = 0, pass_to = 0;  ///< the stated range of x in which every question must be answered right
    std::vector<Point> points;
};

/// Fresh for every seed. At least 24 questions a task, the typical mistakes of methods.md among them.
std::vector<Question> questions_1_ray_casting(std::uint64_t seed);
std::vector<Question> questions_2_phong(std::uint64_t seed);
std::vector<Question> questions_3_recursion(std::uint64_t seed);
std::vector<Question> questions_4_partitioning(std::uint64_t seed);
std::vector<Question> questions_5_distributed(std::uint64_t seed);
std::vector<Sweep> sweeps_1_ray_casting(std::uint64_t seed);
std::vector<Sweep> sweeps_2_phong(std::uint64_t seed);
std::vector<Sweep> sweeps_3_recursion(std::uint64_t seed);
std::vector<Sweep> sweeps_4_partitioning(std::uint64_t seed);
std::vector<Sweep> sweeps_5_distributed(std::uint64_t seed);

}  // namespace rays::grader
