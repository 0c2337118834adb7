#include "grader/mutants.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/error.h"
#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

class Lines {
public:
    Lines(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}
    bool next(std::string& line) {
        if (rest_.empty()) return false;
        const auto end = std::min(rest_.find('\n'), rest_.size());
        line = std::string(rest_.substr(0, end));
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        ++number_;
        return true;
    }
    int number() const { return number_; }
    std::string where() const { return fmt::format("{}:{}", name_, number_); }
    [[noreturn]] void fail(const std::string& what) const { throw InputError(where() + ": " + what); }

private:
    std::string_view rest_;
    std::string name_;
    int number_ = 0;
};

// Lines up to `end`, without the last line's end: a hunk need not be whole lines.
std::string block(Lines& lines, const std::string& end) {
    std::string text, line;
    for (bool first = true; lines.next(line); first = false) {
        if (line == end) return text;
        if (!first) text += '\n';
        text += line;
    }
    lines.fail("no line " + end + " before the end of the file");
}

Hunk hunk(Lines& lines) {
    Hunk h;
    h.line = lines.number();
    h.before = block(lines, "====");
    h.after = block(lines, ">>>>");
    if (h.before.empty()) lines.fail("nothing between <<<< and ====");
    return h;
}

Mutant::Kind kind_of(const std::string& word, const Lines& lines) {
    if (word == "mutant") return Mutant::Kind::mutant;
    if (word == "variant") return Mutant::Kind::variant;
    if (word == "naive") return Mutant::Kind::naive;
    lines.fail("kind: " + word + ": need mutant, variant or naive");
}

void take_field(Mutant& m, const std::string& line, const Lines& lines) {
    const auto colon = line.find(':');
    if (colon == std::string::npos) lines.fail("need a field like 'task: 1.3', found: " + line);
    const std::string name = line.substr(0, colon);
    const auto begin = line.find_first_not_of(' ', colon + 1);
    const std::string value = begin == std::string::npos ? std::string() : line.substr(begin);
    constexpr std::string_view solutions = "solutions/";
    if (name == "task")
        m.task = value;
    else if (name == "title")
        m.title = value;
    else if (name == "seen")
        m.seen = value;
    else if (name == "kind")
        m.kind = kind_of(value, lines);
    else if (name == "sweep")
        m.sweep = value;
    else if (name == "file" && value.starts_with(solutions))
        m.file = value.substr(solutions.size());
    else
        lines.fail("unknown field: " + line);
}

void check(const Mutant& m) {
    const char* missing = m.task.empty()    ? "task"
                          : m.title.empty() ? "title"
                          : m.file.empty()  ? "file"
                          : m.hunks.empty() ? "<<<<"
                                            : nullptr;
    if (missing) throw InputError(fmt::format("{}: {} has no {}", m.where, m.id, missing));
}

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}  // namespace

std::vector<Mutant> parse_mutants(std::string_view text, const std::string& name) {
    std::vector<Mutant> mutants;
    Lines lines(text, name);
    for (std::string line; lines.next(line);) {
        if (line.starts_with("id: ")) {
            mutants.emplace_back();
            mutants.back().id = line.substr(4);
            mutants.back().where = lines.where();
        } else if (line.find_first_not_of(" \r") == std::string::npos || line[0] == '#') {
            continue;
        } else if (mutants.empty()) {
            lines.fail("expected 'id: ...', found: " + line);
        } else if (line == "<<<<") {
            mutants.back().hunks.push_back(hunk(lines));
        } else {
            take_field(mutants.back(), line, lines);
        }
    }
    for (const Mutant& m : mutants) check(m);
    return mutants;
}

std::vector<Mutant> read_mutants(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".txt") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Mutant> all;
    std::set<std::string> ids;
    for (const fs::path& file : files) {
        for (Mutant& m : parse_mutants(read_file(file), file.filename().string())) {
            if (!ids.insert(m.id).second) throw InputError(fmt::format("{}: the id {} is used twice", m.where, m.id));
            all.push_back(std::move(m));
        }
    }
    return all;
}

std::string apply(const Mutant& mutant, std::string source) {
    for (const Hunk& h : mutant.hunks) {
        const std::size_t count = occurrences(source, h.before);
        if (count != 1)
            throw InputError(fmt::format("{}: {}, hunk of line {}: its text occurs {} times in solutions/{}, not once",
                                         mutant.where, mutant.id, h.line, count, mutant.file));
        source.replace(source.find(h.before), h.before.size(), h.after);
    }
    return source;
}

}  // namespace rays::grader
