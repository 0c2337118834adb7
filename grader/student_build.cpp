#include "grader/student_build.h"

#include <fmt/format.h>

#include <algorithm>

#include "references/in_parallel.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

struct Work {
    int step = 0;
    std::string file;
    Built built;
};

std::string object_name(std::string file) {
    std::replace(file.begin(), file.end(), '/', '.');
    return file + ".o";
}

std::vector<Work> compile_all(const Builder& builder, const Project& project, const std::vector<Step>& steps,
                              const fs::path& submission, const fs::path& folder, int workers) {
    std::vector<Work> list;
    for (const Step& step : steps)
        for (const std::string& file : builder.files_of(step.number)) list.push_back({step.number, file, {}});
    in_parallel(list.size(), workers, [&](std::size_t i) {
        list[i].built = builder.compile(list[i].file, submitted_file(project, submission, list[i].file),
                                        folder / object_name(list[i].file), "-O2");
    });
    return list;
}

}  // namespace

fs::path submitted_file(const Project& project, const fs::path& submission, const std::string& file) {
    for (const fs::path& candidate : {submission / file, submission / fs::path(file).filename()})
        if (fs::is_regular_file(candidate)) return candidate;
    return project.steps() / file;
}

StudentPrograms build_student(const Builder& builder, const Project& project, const std::vector<Step>& steps,
                              const fs::path& submission, const fs::path& folder, int workers) {
    StudentPrograms programs;
    fs::create_directories(folder);
    std::map<int, std::map<std::string, fs::path>> objects;
    std::map<std::string, fs::path> all;
    for (const Work& work : compile_all(builder, project, steps, submission, folder, workers)) {
        if (work.built.infrastructure)
            programs.infrastructure_error = work.built.message;
        else if (!work.built.good)
            programs.build_errors[work.step] += work.built.message;
        objects[work.step][work.file] = work.built.file;
        all[work.file] = work.built.file;
    }
    if (!programs.infrastructure_error.empty()) return programs;
    for (const Step& step : steps) {
        if (programs.build_errors.count(step.number)) continue;
        const Built built = builder.link(objects[step.number], folder / fmt::format("render-student-{}", step.number));
        if (built.infrastructure)
            programs.infrastructure_error = built.message;
        else if (built.good)
            programs.isolated[step.number] = built.file;
        else
            programs.build_errors[step.number] = built.message;
    }
    if (!programs.build_errors.empty()) return programs;
    const Built built = builder.link(all, folder / "render-student");
    if (built.good) programs.all_mine = built.file;
    return programs;
}

}  // namespace rays::grader
