#include "example_submissions.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "grader/build.h"
#include "grader/mutants.h"
#include "grader/step_data.h"
#include "support/files.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

fs::path example_folder(const Project& project, const std::string& name) {
    return project.root / "tests" / "grader" / "submissions" / name;
}

bool is_mark(const std::string& line, const std::string& mark, const std::string& task) {
    std::istringstream words(line);
    std::string first, second;
    return words >> first >> second && first == mark && second == task;
}

std::string file_with(const Project& project, const std::string& task) {
    for (const Step& step : read_steps(project.steps()))
        if (const Task* t = step.find(task)) return step.id + "/" + t->file;
    throw std::runtime_error("no task " + task);
}

}  // namespace

std::string without_task(const std::string& source, const std::string& task) {
    std::istringstream in(source);
    std::string result;
    bool inside = false, found = false;
    for (std::string line; std::getline(in, line);) {
        if (is_mark(line, "//>", task)) {
            inside = found = true;
            const bool is_void = line.find("//> " + task + " void") != std::string::npos;
            result += fmt::format("unfinished(\"{}\");{}\n", task, is_void ? "" : " return {};");
        }
        if (!inside) result += line + "\n";
        if (is_mark(line, "//<", task)) inside = false;
    }
    if (!found || inside) throw std::runtime_error("no region of task " + task);
    return result;
}

std::map<std::string, std::string> changed_files(const Project& project, const fs::path& example) {
    std::map<std::string, std::string> files;
    const auto text_of = [&](const std::string& file) -> std::string& {
        if (!files.count(file)) files[file] = read_file(project.root / "solutions" / file);
        return files[file];
    };
    const auto mutants = read_mutants(project.mutants());
    std::ifstream in(example / "steps.txt");
    for (std::string what, which; in >> what >> which;) {
        if (what == "unwritten") {
            const std::string file = file_with(project, which);
            text_of(file) = without_task(text_of(file), which);
            continue;
        }
        const auto mutant =
            std::find_if(mutants.begin(), mutants.end(), [&](const Mutant& m) { return m.id == which; });
        if (what != "mistake" || mutant == mutants.end())
            throw std::runtime_error(what + " " + which + ": what is that?");
        text_of(mutant->file) = apply(*mutant, text_of(mutant->file));
    }
    return files;
}

void write_example(const Project& project, const std::string& name, const fs::path& folder) {
    const fs::path example = example_folder(project, name);
    for (const Step& step : read_steps(project.steps())) {
        fs::create_directories(folder / step.id);
        fs::copy_file(step.folder / "step.json", folder / step.id / "step.json");
        for (const auto& entry : fs::directory_iterator(project.root / "solutions" / step.id))
            if (entry.path().extension() == ".cpp")
                fs::copy_file(entry.path(), folder / step.id / entry.path().filename());
    }
    for (const auto& [file, text] : changed_files(project, example)) write_atomically(folder / file, text);
    for (const auto& entry : fs::directory_iterator(example))
        if (entry.path().filename() != "steps.txt")
            write_atomically(folder / "submission" / entry.path().filename(), read_file(entry.path()));
}

fs::path example_program(const Project& project, const std::string& name, const fs::path& folder) {
    const auto files = changed_files(project, example_folder(project, name));
    if (files.empty()) return project.program("render-solution");
    const Builder builder(project);
    std::map<std::string, fs::path> objects;
    for (const auto& [file, text] : files) {
        std::string object = file + ".o";
        std::replace(object.begin(), object.end(), '/', '.');
        const Built built = builder.compile(file, folder / file, folder / object, "-O1");
        if (!built.good) throw std::runtime_error(built.message);
        objects[file] = built.file;
    }
    const Built built = builder.link(objects, folder / "program");
    if (!built.good) throw std::runtime_error(built.message);
    // What writes PNG is looked for beside the program.
    fs::copy_file(project.program("rays-formats"), folder / "rays-formats");
    return built.file;
}

}  // namespace rays::grader
