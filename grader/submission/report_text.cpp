#include "grader/submission/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "grader/submission/format.h"
#include "grader/submission/safe_path.h"
#include "grader/text.h"

namespace rays::grader {
namespace {

std::string trimmed(std::string line) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) line.pop_back();
    const auto begin = line.find_first_not_of(" \t");
    line.erase(0, std::min(begin, line.size()));
    if (line.starts_with("$ ")) line.erase(0, 2);  // a prompt
    return line;
}

bool is_command(const std::string& line) {
    return line.starts_with("./rays render ") || line.starts_with("rays render ");
}

bool for_a_shell(char c) {
    return static_cast<unsigned char>(c) < 0x20 ||
           std::string_view("$`\"'\\;&|<>(){}[]*?!#~^%").find(c) != std::string_view::npos;
}

/// The words of a command; --option=value are two.
std::vector<std::string> words_of(const std::string& line) {
    std::istringstream in(line);
    std::vector<std::string> words;
    for (std::string word; in >> word;) {
        const auto equals = word.find('=');
        if (word.starts_with("--") && equals != std::string::npos) {
            words.push_back(word.substr(0, equals));
            words.push_back(word.substr(equals + 1));
        } else {
            words.push_back(word);
        }
    }
    return words;
}

/// A number in a range, or 0.
int number(const std::string& word, int most) {
    int value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() && value >= 1 && value <= most ? value : 0;
}

class CommandReader {
public:
    explicit CommandReader(RenderCommand& command) : command_(command) {}

    void read(const std::vector<std::string>& words) {
        for (std::size_t i = 2; i < words.size() && command_.problem.empty(); ++i) {
            if (!words[i].starts_with('-'))
                positional(words[i]);
            else if (i + 1 == words.size())
                command_.problem = words[i] + " stands without a value, or is not known";
            else
                option(words[i], words[i + 1]), ++i;
        }
        if (command_.problem.empty() && command_.scene.empty()) command_.problem = "names no scene";
        if (command_.problem.empty() && command_.output.empty()) command_.problem = "names no picture: -o PICTURE";
    }

private:
    void positional(const std::string& word) {
        if (!command_.scene.empty()) command_.problem = "names two scenes";
        command_.scene = path(word);
    }

    std::string path(const std::string& word) {
        const std::string name = plain_scene_name(word);
        if (const std::string why = path_problem(name); !why.empty())
            command_.problem = fmt::format("\"{}\" {}", plain(word, 60), why);
        return name;
    }

    int positive(const std::string& name, const std::string& value, int most) {
        const int n = number(value, most);
        if (n == 0) command_.problem = fmt::format("{} {}: need 1 to {}", name, plain(value, 20), most);
        return n;
    }

    void option(const std::string& name, const std::string& value) {
        const auto changes_picture = [&] { command_.options.insert(command_.options.end(), {name, value}); };
        if (name == "-o" || name == "--output")
            command_.output = path(value);
        else if (name == "--width")
            command_.raster.width = positive(name, value, kLargestSide);
        else if (name == "--height")
            command_.raster.height = positive(name, value, kLargestSide);
        else if (name == "--threads")
            positive(name, value, 1024);
        else if (name == "--partition")
            check_one_of(name, value, {"auto", "none", "grid", "octree", "bvh"});
        else if (name == "--from")
            check_one_of(name, value, {"student"});
        else if (name == "--samples")
            check_one_of(name, value, {"1"});
        else if (name == "--without" || name == "--max-trace-level")
            changes_picture();
        else
            command_.problem = plain(name, 40) + " is no option that a report may use";
    }

    void check_one_of(const std::string& name, const std::string& value, std::initializer_list<const char*> allowed) {
        if (std::find(allowed.begin(), allowed.end(), value) == allowed.end())
            command_.problem = fmt::format("{} {} is not for a report", name, plain(value, 40));
    }

    RenderCommand& command_;
};

}  // namespace

RenderCommand parse_command(const std::string& line) {
    RenderCommand command;
    command.text = plain(line, 300);
    if (std::any_of(line.begin(), line.end(), for_a_shell))
        command.problem = "holds a character that means something to a shell; only plain words are read";
    else
        CommandReader(command).read(words_of(line));
    if (command.problem.empty() && std::int64_t{command.raster.width} * command.raster.height > kMostPixels)
        command.problem = fmt::format("asks for more than {} pixels", kMostPixels);
    return command;
}

ReportText read_report(const std::string& markdown) {
    ReportText report;
    std::istringstream in(markdown.substr(0, kLargestReport));
    bool code = false;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        const std::string text = trimmed(line);
        if (text.find(kToBeWritten) != std::string::npos) report.to_be_written.push_back(number);
        if (text.starts_with("```") || text.starts_with("~~~")) {
            code = !code;
        } else if (!code) {
            report.prose += line + "\n";
        } else if (is_command(text) && report.commands.size() < kMostCommands) {
            report.commands.push_back(parse_command(text));
            report.commands.back().line = number;
        }
    }
    return report;
}

}  // namespace rays::grader
