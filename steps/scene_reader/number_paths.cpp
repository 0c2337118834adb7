#include "scene_reader/number_paths.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "core/error.h"
#include "scene_reader/scene_numbers.h"

namespace rays::sdl {
namespace {

struct Paths {
    std::map<std::size_t, std::string>& found;
    std::vector<std::string> stack{};
    std::size_t next = 0;

    void number(const char* name, double) {
        const auto wanted = found.find(next++);
        if (wanted == found.end()) return;
        for (const std::string& part : stack) wanted->second += part + ".";
        wanted->second += name;
    }
    void fixed(std::int64_t) {}
    void enter(const char* name) { stack.emplace_back(name); }
    void enter(const char* name, std::size_t i) { stack.push_back(fmt::format("{}[{}]", name, i)); }
    void leave() { stack.pop_back(); }
};

struct FirstNotFinite {
    std::size_t next = 0;
    std::optional<std::size_t> found{};

    void number(const char*, double x) {
        if (!found && !std::isfinite(x)) found = next;
        ++next;
    }
    void fixed(std::int64_t) {}
    void enter(const char*) {}
    void enter(const char*, std::size_t) {}
    void leave() {}
};

}  // namespace

void find_paths(const Scene& scene, std::map<std::size_t, std::string>& paths) {
    Paths visitor{paths};
    visit_numbers(scene, visitor);
}

std::string path_of(const Scene& scene, std::size_t number) {
    std::map<std::size_t, std::string> paths{{number, {}}};
    find_paths(scene, paths);
    return paths[number];
}

void require_finite(const Scene& scene, const Source& text) {
    FirstNotFinite check;
    visit_numbers(scene, check);
    if (!check.found) return;
    throw InputError(fmt::format("{}:1:1: {} is not a finite number; look for a transform or a size that is too large",
                                 text.name, path_of(scene, *check.found)));
}

}  // namespace rays::sdl
