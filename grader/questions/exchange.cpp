#include "questions/exchange.h"

#include <fmt/format.h>

#include <charconv>

namespace rays::grader {
namespace {

// Thousands of points of a pattern or of a lens, with 17 digits a number.
constexpr std::size_t kMostNumbers = 16384;
constexpr std::size_t kLongestLine = kMostNumbers * 25;

// All of the words as numbers; false when one is none.
bool parse_numbers(std::string_view words, std::vector<double>& numbers) {
    const char* const end = words.data() + words.size();
    for (const char* at = words.data(); at != end;) {
        if (*at == ' ') {
            ++at;
            continue;
        }
        double value = 0;
        const auto [next, problem] = std::from_chars(at, end, value);
        if (problem != std::errc() || (next != end && *next != ' ') || numbers.size() == kMostNumbers) return false;
        numbers.push_back(value);
        at = next;
    }
    return !numbers.empty();
}

}  // namespace

Answer parse_answer(std::string_view line) {
    Answer answer;
    answer.text = std::string(line.substr(0, kLongestLine));
    while (!answer.text.empty() && (answer.text.back() == ' ' || answer.text.back() == '\r')) answer.text.pop_back();
    const std::string_view text = answer.text;
    if (text == "miss")
        answer.kind = Answer::Kind::miss;
    else if (text.starts_with("unfinished "))
        answer.kind = Answer::Kind::unfinished;
    else if (parse_numbers(text.starts_with("hit ") ? text.substr(4) : text, answer.numbers))
        answer.kind = Answer::Kind::value;
    else
        answer.kind = Answer::Kind::error;
    if (answer.kind != Answer::Kind::value) answer.numbers.clear();
    return answer;
}

std::string question_text(const std::vector<const Question*>& questions) {
    std::string text;
    const std::string* scene = nullptr;
    for (const Question* q : questions) {
        if (!scene || *scene != q->scene) text += fmt::format("scene {}\n{}", q->scene.size(), q->scene);
        scene = &q->scene;
        text += q->query + '\n';
    }
    return text;
}

}  // namespace rays::grader
