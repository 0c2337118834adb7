#include "core/unfinished.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <utility>

namespace rays {
namespace {

std::mutex mutex;
std::vector<UnfinishedTask> tasks;
thread_local const char* first_asked = nullptr;

// "1.10" comes after "1.9".
std::pair<int, int> task_order(const std::string& id) {
    const auto dot = id.find('.');
    return {std::atoi(id.c_str()), dot == std::string::npos ? 0 : std::atoi(id.c_str() + dot + 1)};
}

void remember(const char* task, const char* file, unsigned line) {
    const std::lock_guard lock(mutex);
    const auto known = std::any_of(tasks.begin(), tasks.end(), [&](const auto& t) { return t.task == task; });
    if (!known) tasks.push_back({task, file, line});
}

}  // namespace

void unfinished(const char* task, const char* file, unsigned line) {
    // A starter asks for millions of rays: only the first of a run of equal tasks on a thread takes the lock.
    thread_local std::vector<const char*> seen;
    if (std::find(seen.begin(), seen.end(), task) == seen.end()) {
        seen.push_back(task);
        remember(task, file, line);
    }
    if (!first_asked) first_asked = task;
}

std::vector<UnfinishedTask> unfinished_tasks() {
    const std::lock_guard lock(mutex);
    auto result = tasks;
    std::sort(result.begin(), result.end(),
              [](const auto& a, const auto& b) { return task_order(a.task) < task_order(b.task); });
    return result;
}

const char* take_unfinished_task() { return std::exchange(first_asked, nullptr); }

}  // namespace rays
