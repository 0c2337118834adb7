// A loop shared by all cores. What it computes must not depend on how it is shared.
#pragma once

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace rays {

/// Below this many iterations a thread costs more than it saves.
inline constexpr std::size_t kParallelFrom = 16384;

/// Calls what(part, begin, end) for `parts` pieces of 0..count, at most one a core, and returns how many parts there
/// were. Where no thread is to be had, the caller does the work.
template <class What>
std::size_t in_parallel_parts(std::size_t count, std::size_t parallel_from, What what) {
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t parts = count < parallel_from ? 1 : std::min(cores, count);
    const auto begin = [&](std::size_t part) { return count * part / parts; };
    std::vector<std::jthread> helpers;
    for (std::size_t part = 1; part < parts; ++part) {
        try {
            helpers.emplace_back([&, part] { what(part, begin(part), begin(part + 1)); });
        } catch (const std::system_error&) {
            what(part, begin(part), begin(part + 1));
        }
    }
    what(0, begin(0), begin(1));
    return parts;
}

/// Calls what(i) for every i of 0..count.
template <class What>
void in_parallel_each(std::size_t count, What what) {
    in_parallel_parts(count, kParallelFrom, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) what(i);
    });
}

}  // namespace rays
