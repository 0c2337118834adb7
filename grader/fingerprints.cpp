#include "grader/fingerprints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "grader/answers.h"
#include "grader/course.h"
#include "grader/fresh_scenes.h"
#include "support/files.h"
#include "support/sha256.h"

namespace rays::grader {
namespace {

using nlohmann::ordered_json;

constexpr std::uint64_t kDiagnosticSeed = 2026;

// Fingerprints keep six digits, and equal mistakes in single and double precision agree to about four.
constexpr double kSame = 2e-4;

constexpr double kOwnShare = 0.9, kTheirShare = 0.5;
// The next best must be worse by this much of the share of common differences.
constexpr double kUnique = 0.002;

// Written so that two NaN agree: a mutant that answers NaN is recognised by it.
bool same(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    if (std::isinf(a) || std::isinf(b)) return a == b;
    return a == b || std::abs(a - b) <= kSame * std::max({1e-3, std::abs(a), std::abs(b)});
}

bool same(const Answer& a, const Answer& b) {
    if (a.kind != b.kind || a.numbers.size() != b.numbers.size()) return false;
    for (std::size_t i = 0; i < a.numbers.size(); ++i)
        if (!same(a.numbers[i], b.numbers[i])) return false;
    return true;
}

// Limits decide whether what needs too much runs out of time or of memory, and a crash is often luck: all of them are
// one answer. `error` is a program's own word for it, since questions are well formed.
const char* const kNoAnswer = "none";  // which parse_answer reads as an error, too
bool is_no_answer(const Answer& a) { return a.kind == Answer::Kind::lost || a.kind == Answer::Kind::error; }

bool comparable(const Answer& a) {
    return a.kind == Answer::Kind::value || a.kind == Answer::Kind::miss || is_no_answer(a);
}

std::string shortened(const Answer& a) {
    if (is_no_answer(a)) return kNoAnswer;
    if (a.kind != Answer::Kind::value) return "miss";
    // Of thousands of points the first few tell whose they are.
    constexpr std::size_t kMany = 64, kOfMany = 8;
    const std::size_t count = a.numbers.size() > kMany ? kOfMany : a.numbers.size();
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += fmt::format("{}{:.6g}", i ? " " : "", a.numbers[i]);
    return text;
}

struct Likeness {
    double own = 0, theirs = 0, both = 0;
};

Likeness likeness(const Fingerprint& student, const Fingerprint& mutant, const std::set<int>& unfinished) {
    int common = 0, asked = 0;
    for (const auto& [number, answer] : mutant) {
        if (unfinished.count(number)) continue;
        ++asked;
        const auto found = student.find(number);
        common += found != student.end() && same(parse_answer(found->second), parse_answer(answer));
    }
    const auto all = static_cast<double>(student.size()) + asked - common;
    return {double(common) / std::max(1, asked), double(common) / double(std::max<std::size_t>(1, student.size())),
            common / std::max(1.0, all)};
}

// Questions are computed: compilers and their options may move the last bits of a number, which makes no other
// question.
std::string with_six_digits(const std::string& text) {
    constexpr double kNothing = 1e-12;
    std::string result;
    for (const char* at = text.c_str(); *at != '\0';) {
        char* end = nullptr;
        const bool number = std::isdigit(static_cast<unsigned char>(*at)) || *at == '-' || *at == '.';
        const double value = number ? std::strtod(at, &end) : 0;
        if (!number || end == at) {
            result += *at++;
            continue;
        }
        result += fmt::format("{:.6g}", std::abs(value) < kNothing ? 0.0 : value);
        at = end;
    }
    return result;
}

ordered_json json_of(const ChartSeries& s) {
    ordered_json points = ordered_json::array();
    for (const auto& [x, y] : s.points) points.push_back({x, y ? ordered_json(*y) : ordered_json(nullptr)});
    return {{"name", s.name}, {"points", points}};
}

ChartSeries series_of(const ordered_json& j) {
    ChartSeries s{j.at("name"), "naive", {}};
    for (const auto& p : j.at("points"))
        s.points.emplace_back(p.at(0), p.at(1).is_null() ? std::nullopt : std::optional<double>(p.at(1)));
    return s;
}

}  // namespace

std::vector<Question> diagnostic_questions(int step, const std::vector<std::string>& tasks) {
    std::vector<Question> questions = questions_of(step, kDiagnosticSeed);
    for (Question& q : probe_questions(tasks, kDiagnosticSeed)) questions.push_back(std::move(q));
    return questions;
}

std::string questions_hash(const std::vector<Question>& questions) {
    std::string text;
    for (const Question& q : questions) text += with_six_digits(q.scene) + '\n' + with_six_digits(q.query) + '\n';
    return sha256(text).substr(0, 16);
}

Fingerprint fingerprint(const std::vector<Answer>& answers, const std::vector<Answer>& solution) {
    Fingerprint result;
    for (std::size_t i = 0; i < std::min(answers.size(), solution.size()); ++i)
        if (comparable(answers[i]) && !same(answers[i], solution[i]))
            result[static_cast<int>(i)] = shortened(answers[i]);
    return result;
}

std::set<int> unfinished_questions(const std::vector<Answer>& answers) {
    std::set<int> numbers;
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (answers[i].kind == Answer::Kind::unfinished) numbers.insert(static_cast<int>(i));
    return numbers;
}

std::optional<KnownMutant> nearest_mutant(const Fingerprint& student, const std::vector<KnownMutant>& mutants,
                                          const std::set<int>& unfinished) {
    const KnownMutant* best = nullptr;
    Likeness best_likeness, second;
    for (const KnownMutant& m : mutants) {
        const Likeness l = likeness(student, m.fingerprint, unfinished);
        if (l.both > best_likeness.both) {
            second = best_likeness;
            best_likeness = l;
            best = &m;
        } else if (l.both > second.both) {
            second = l;
        }
    }
    const bool good = best && best_likeness.own >= kOwnShare && best_likeness.theirs >= kTheirShare &&
                      best_likeness.both > second.both + kUnique;
    return good ? std::optional(*best) : std::nullopt;
}

Fingerprints read_fingerprints(const std::filesystem::path& file) {
    Fingerprints result;
    if (!std::filesystem::exists(file)) return result;
    try {
        const auto json = ordered_json::parse(read_file(file));
        for (const auto& [number, j] : json.at("steps").items()) {
            StepFingerprints& step = result.steps[std::stoi(number)];
            step.questions = j.at("questions");
            for (const auto& m : j.at("mutants")) {
                KnownMutant known{m.at("id"), m.at("task"), m.at("title"), m.at("seen"), {}};
                for (const auto& [question, answer] : m.at("answers").items())
                    known.fingerprint[std::stoi(question)] = answer;
                step.mutants.push_back(std::move(known));
            }
            for (const auto& [sweep, list] : j.at("naive").items())
                for (const auto& s : list) step.naive[sweep].push_back(series_of(s));
        }
    } catch (const std::exception& e) {
        throw InputError(fmt::format("{}: {}; run rays mutants --update", file.string(), e.what()));
    }
    return result;
}

void write_fingerprints(const Fingerprints& fingerprints, const std::filesystem::path& file) {
    ordered_json steps;
    for (const auto& [number, step] : fingerprints.steps) {
        ordered_json mutants = ordered_json::array(), naive = ordered_json::object();
        for (const KnownMutant& m : step.mutants) {
            ordered_json answers = ordered_json::object();
            for (const auto& [question, answer] : m.fingerprint) answers[std::to_string(question)] = answer;
            mutants.push_back(
                {{"id", m.id}, {"task", m.task}, {"title", m.title}, {"seen", m.seen}, {"answers", answers}});
        }
        for (const auto& [sweep, list] : step.naive)
            for (const ChartSeries& s : list) naive[sweep].push_back(json_of(s));
        steps[std::to_string(number)] = {{"questions", step.questions}, {"mutants", mutants}, {"naive", naive}};
    }
    write_atomically(file, ordered_json{{"version", 1}, {"steps", steps}}.dump() + "\n");
}

}  // namespace rays::grader
