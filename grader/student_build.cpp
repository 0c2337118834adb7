#include "grader/student_build.h"

#include <fmt/format.h>

#include <algorithm>

#include "grader/kept_objects.h"
#include "references/in_parallel.h"

namespace rays::grader {
namespace {

namespace fs = std::filesystem;

struct Work {
    int step = 0;
    std::string file;
    Built built;
};

using Objects = std::map<std::string, fs::path>;  // by file

struct Program {
    int step = 0;  ///< 0: all steps are the student's
    Objects objects;
    std::string name;
    Built built;
};

std::string object_name(std::string file) {
    std::replace(file.begin(), file.end(), '/', '.');
    return file + ".o";
}

std::vector<Work> compile_all(const Builder& builder, const Project& project, const std::vector<Step>& steps,
                              const fs::path& submission, const fs::path& folder, int workers) {
    const KeptObjects objects(builder, project);
    std::vector<Work> list;
    for (const Step& step : steps)
        for (const std::string& file : builder.files_of(step.number)) list.push_back({step.number, file, {}});
    in_parallel(list.size(), workers, [&](std::size_t i) {
        list[i].built = objects.compile(list[i].file, submitted_file(project, submission, list[i].file),
                                        folder / object_name(list[i].file));
    });
    return list;
}

// Where every file is the solution's, so is the program.
Built linked(const Builder& builder, const Project& project, const Objects& objects, const fs::path& program) {
    const bool solution = std::all_of(objects.begin(), objects.end(),
                                      [&](const auto& o) { return o.second == builder.solution_object(o.first); });
    if (solution) return {true, false, project.program("render-solution"), {}};
    return builder.link(objects, program);
}

void note(const Program& program, StudentPrograms& programs) {
    const Built& built = program.built;
    if (program.step == 0)
        programs.all_mine = built.good ? built.file : fs::path();
    else if (built.infrastructure)
        programs.infrastructure_error = built.message;
    else if (built.good)
        programs.isolated[program.step] = built.file;
    else
        programs.build_errors[program.step] = built.message;
}

}  // namespace

fs::path submitted_file(const Project& project, const fs::path& submission, const std::string& file) {
    for (const fs::path& candidate : {submission / file, submission / fs::path(file).filename()})
        if (fs::is_regular_file(candidate)) return candidate;
    return project.steps() / file;
}

StudentPrograms build_student(const Builder& builder, const Project& project, const std::vector<Step>& steps,
                              const std::vector<Step>& graded, const fs::path& submission, const fs::path& folder,
                              int workers) {
    StudentPrograms programs;
    fs::create_directories(folder);
    std::map<int, Objects> objects;
    Objects all;
    for (const Work& work : compile_all(builder, project, steps, submission, folder, workers)) {
        if (work.built.infrastructure)
            programs.infrastructure_error = work.built.message;
        else if (!work.built.good)
            programs.build_errors[work.step] += work.built.message;
        objects[work.step][work.file] = work.built.file;
        all[work.file] = work.built.file;
    }
    if (!programs.infrastructure_error.empty()) return programs;
    std::vector<Program> list;
    for (const Step& step : graded)
        if (!programs.build_errors.count(step.number))
            list.push_back({step.number, objects[step.number], fmt::format("render-student-{}", step.number), {}});
    if (programs.build_errors.empty()) list.push_back({0, all, "render-student", {}});
    in_parallel(list.size(), workers, [&](std::size_t i) {
        list[i].built = linked(builder, project, list[i].objects, folder / list[i].name);
    });
    for (const Program& program : list) note(program, programs);
    if (!programs.build_errors.empty()) programs.all_mine.clear();
    return programs;
}

}  // namespace rays::grader
