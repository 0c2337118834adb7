#include "ask.h"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

#include "support/files.h"
#include "support/process.h"

namespace rays::povray_trace {
namespace {

constexpr double kSeconds = 120;

std::string commas(const glm::dvec3& v) { return fmt::format("<{:.17g},{:.17g},{:.17g}>", v.x, v.y, v.z); }
std::string blanks(const glm::dvec3& v) { return fmt::format("{:.17g} {:.17g} {:.17g}", v.x, v.y, v.z); }

glm::dvec3 vector_from(std::istream& in) {
    glm::dvec3 v(0);
    in >> v.x >> v.y >> v.z;
    return v;
}

std::runtime_error short_answers(const char* who) {
    return std::runtime_error(fmt::format("{}: too few answers", who));
}

}  // namespace

Meetings ask_povray(const Povray& povray, const Primitive& primitive, const std::vector<TestRay>& rays) {
    std::string sdl = "#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n";
    sdl += "#declare Thing = " + primitive.sdl + "\n#declare N = <0, 0, 0>;\n";
    sdl += fmt::format("#declare Rays = array[{}][2] {{\n", rays.size());
    for (const TestRay& ray : rays) sdl += fmt::format("{{{},{}}},\n", commas(ray.origin), commas(ray.direction));
    sdl += "}\n#fopen Out \"answers\" write\n";
    sdl += fmt::format("#for (I, 0, {})\n", rays.size() - 1);
    sdl +=
        "#declare P = trace(Thing, Rays[I][0], Rays[I][1], N);\n"
        "#write (Out, vstr(3, P, \" \", 0, 17), \" \", vstr(3, N, \" \", 0, 17), \"\\n\")\n#end\n#fclose Out\n";

    std::istringstream answers(povray.answers(sdl, kSeconds));
    Meetings result;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const glm::dvec3 point = vector_from(answers);
        const glm::dvec3 normal = vector_from(answers);
        const bool miss = normal == glm::dvec3(0);  // a miss is told by a normal of zero
        result.push_back(miss ? std::nullopt : std::optional(Met{point, normal}));
    }
    if (!answers) throw short_answers("POV-Ray");
    return result;
}

Meetings ask_solution(const std::filesystem::path& program, const Primitive& primitive,
                      const std::vector<TestRay>& rays) {
    const std::string scene = "#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n" + primitive.sdl + "\n";
    std::string questions = fmt::format("scene {}\n{}", scene.size(), scene);
    for (const TestRay& ray : rays) {
        questions +=
            fmt::format("nearest {} {} {} {}\n", blanks(ray.origin), blanks(ray.direction), ray.nearest, kFarthest);
    }
    const Ended ended = run_command({{program.string(), "--answer"}, questions, {}, only_time(kSeconds), true});
    if (!ended.ok()) throw std::runtime_error(fmt::format("{}: {}", program.string(), how_it_ended(ended)));

    std::istringstream answers(ended.out);
    Meetings result;
    for (const TestRay& ray : rays) {
        std::string line;
        if (!std::getline(answers, line)) throw short_answers("render-solution");
        std::istringstream words(line);
        std::string verb;
        words >> verb;
        if (verb == "miss") {
            result.push_back(std::nullopt);
            continue;
        }
        double t = 0;
        words >> t;
        const glm::dvec3 normal = vector_from(words);
        const glm::dvec3 shading_normal = vector_from(words);
        if (verb != "hit" || !words) throw std::runtime_error("render-solution answers: " + line);
        result.push_back(Met{ray.origin + t * ray.direction, primitive.smooth ? shading_normal : normal});
    }
    return result;
}

}  // namespace rays::povray_trace
