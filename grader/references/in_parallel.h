// Several things at once.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace rays {

/// Calls work(0) ... work(count - 1) from `workers` threads. `work` must not throw.
template <class Work>
void in_parallel(std::size_t count, int workers, const Work& work) {
    std::atomic<std::size_t> next{0};
    std::vector<std::jthread> threads;
    for (int i = 0; i < workers; ++i) {
        threads.emplace_back([&] {
            for (std::size_t item = next++; item < count; item = next++) work(item);
        });
    }
}

}  // namespace rays
