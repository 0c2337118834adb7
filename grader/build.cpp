#include "grader/build.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "core/error.h"
#include "grader/text.h"
#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

// A compiler that a hostile template keeps busy: this is patience, not a measure.
const Limits kCompileLimits{120, 180, 4096, 0, 256, 4};

/// Words of a command line as a shell would see them: quotes and backslashes, nothing else.
std::vector<std::string> words(const std::string& command) {
    std::vector<std::string> result;
    std::string word;
    bool open = false;
    char quote = 0;
    for (std::size_t i = 0; i < command.size(); ++i) {
        const char c = command[i];
        if (quote) {
            if (c == quote)
                quote = 0;
            else if (c == '\\' && quote == '"' && i + 1 < command.size())
                word += command[++i];
            else
                word += c;
        } else if (c == '"' || c == '\'') {
            quote = c;
            open = true;
        } else if (c == '\\' && i + 1 < command.size()) {
            word += command[++i];
            open = true;
        } else if (c == ' ' || c == '\n') {
            if (open || !word.empty()) result.push_back(word);
            word.clear();
            open = false;
        } else {
            word += c;
        }
    }
    if (open || !word.empty()) result.push_back(word);
    return result;
}

// Link-time optimisation makes a program faster, not different, and costs seconds a link.
void drop_lto(std::vector<std::string>& command) {
    std::erase_if(command, [](const std::string& w) {
        return w.starts_with("-flto") || w == "-ffat-lto-objects" || w == "-fno-fat-lto-objects";
    });
}

std::string value_of(const std::vector<std::string>& command, const std::string& option) {
    const auto at = std::find(command.begin(), command.end(), option);
    return at != command.end() && at + 1 != command.end() ? *(at + 1) : std::string();
}

void drop_with_value(std::vector<std::string>& command, const std::string& option) {
    const auto at = std::find(command.begin(), command.end(), option);
    if (at != command.end() && at + 1 != command.end()) command.erase(at, at + 2);
}

// In a UTF-8 locale the compiler's quotation marks are not ASCII, which is all that a message keeps.
Command plain_speaking(std::vector<std::string> argv, const fs::path& folder) {
    return {std::move(argv), {}, folder, kCompileLimits, true, {{"LC_ALL", "C"}}};
}

Built finish(const Ended& ended, const fs::path& file) {
    Built built;
    built.file = file;
    built.good = ended.ok();
    built.infrastructure = !ended.started;
    built.message = !ended.started    ? ended.problem
                    : ended.timed_out ? "the compiler ran out of time"
                                      : plain_lines(ended.err.empty() ? ended.out : ended.err);
    return built;
}

}  // namespace

Builder::Builder(const Project& project) : project_(project) {
    read_compile_commands();
    read_link_command();
}

void Builder::read_compile_commands() {
    const fs::path file = project_.build / "compile_commands.json";
    try {
        static const std::regex solution_side(R"((?:^|/)solution_([0-9]+)\.dir/)");
        for (const auto& entry : nlohmann::json::parse(read_file(file))) {
            Unit unit;
            unit.compile = words(entry.at("command"));
            unit.solution_object = value_of(unit.compile, "-o");
            std::smatch found;
            if (!std::regex_search(unit.solution_object, found, solution_side)) continue;
            unit.step = std::stoi(found[1]);
            drop_lto(unit.compile);
            drop_with_value(unit.compile, "-o");
            drop_with_value(unit.compile, "-c");
            const fs::path source = entry.at("file").get<std::string>();
            units_[source.lexically_relative(project_.root / "solutions").string()] = unit;
        }
    } catch (const nlohmann::json::exception& e) {
        throw InputError(fmt::format("{}: {}", file.string(), e.what()));
    }
    if (units_.empty())
        throw InputError(file.string() + ": no step's solution is built there; configure again with Ninja");
}

void Builder::read_link_command() {
    Command ninja{{project_.setting("CMAKE_MAKE_PROGRAM"), "-C", project_.build.string(), "-t", "commands",
                   "bin/render-solution"},
                  {},
                  {},
                  kCompileLimits,
                  true};
    const Ended ended = run_command(ninja);
    if (!ended.ok())
        throw InputError("the link command of render-solution is not known: build with Ninja. " +
                         plain(ended.problem + ended.err));
    std::string line = ended.out;
    while (!line.empty() && line.back() == '\n') line.pop_back();
    line = line.substr(line.rfind('\n') + 1);
    link_ = words(line);
    // Ninja's form: ": && c++ ... && :"
    if (link_.size() < 5 || link_[0] != ":" || link_[1] != "&&")
        throw InputError("not the expected link command: " + plain(line));
    link_.erase(link_.begin(), link_.begin() + 2);
    link_.resize(static_cast<std::size_t>(std::find(link_.begin(), link_.end(), "&&") - link_.begin()));
    drop_lto(link_);
    // Packets are the solution's way through all steps at once: they would pass a student's step by. Without them the
    // renderer's archive brings no_packets.cpp.
    std::erase_if(link_,
                  [](const std::string& word) { return word.find("/solution_packets.dir/") != std::string::npos; });
    drop_with_value(link_, "-o");
    for (const auto& [file, unit] : units_)
        if (std::find(link_.begin(), link_.end(), unit.solution_object) == link_.end())
            throw InputError(fmt::format("render-solution is linked without {}", unit.solution_object));
}

std::vector<std::string> Builder::files_of(int step) const {
    std::vector<std::string> files;
    for (const auto& [file, unit] : units_)
        if (unit.step == step) files.push_back(file);
    return files;
}

std::string Builder::state(const std::string& file) const {
    const Unit& unit = units_.at(file);
    const auto built = fs::last_write_time(project_.build / unit.solution_object).time_since_epoch().count();
    return fmt::format("{}\n{}\n", fmt::join(unit.compile, "\n"), built);
}

Built Builder::compile(const std::string& file, const fs::path& source, const fs::path& object,
                       const std::string& optimisation) const {
    Command command = plain_speaking(units_.at(file).compile, project_.build);
    if (project_.sanitized()) command.limits.memory_mb = 0;
    std::erase_if(command.argv, [](const std::string& w) { return w.starts_with("-O"); });
    const std::string shown = fmt::format("-ffile-prefix-map={}=steps/{}", source.string(), file);
    for (const std::string& w :
         {optimisation, shown, std::string("-Wno-unused-parameter"), std::string("-fdiagnostics-color=never"),
          std::string("-fmax-errors=5"), std::string("-o"), object.string(), std::string("-c"), source.string()})
        command.argv.push_back(w);
    if (project_.setting("CMAKE_CXX_COMPILER").find("clang") != std::string::npos) {
        std::replace(command.argv.begin(), command.argv.end(), std::string("-fmax-errors=5"),
                     std::string("-ferror-limit=5"));
        command.argv.emplace_back("-Wno-unused-private-field");  // members wait for their task, as parameters do
    }
    Built built = finish(run_command(command), object);
    // The student knows the file by its name among the steps.
    const std::string path = source.string(), name = "steps/" + file;
    for (auto at = built.message.find(path); at != std::string::npos; at = built.message.find(path, at + name.size()))
        built.message.replace(at, path.size(), name);
    return built;
}

Built Builder::link(const std::map<std::string, fs::path>& objects, const fs::path& program) const {
    Command command = plain_speaking(link_, project_.build);
    if (project_.sanitized()) command.limits.memory_mb = 0;
    for (const auto& [file, object] : objects)
        std::replace(command.argv.begin(), command.argv.end(), units_.at(file).solution_object, object.string());
    command.argv.push_back("-fno-lto");
    command.argv.push_back("-o");
    command.argv.push_back(program.string());
    return finish(run_command(command), program);
}

}  // namespace rays::grader
