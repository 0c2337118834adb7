// Memory for large arrays.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace rays {

/// For std::vector: asks the system for pages of 2 MiB. A film of 512 x 512 pixels then costs two page faults, not a
/// thousand, which took longer than many a picture's sky.
template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class Other>
    LargePages(const LargePages<Other>&) {}  // NOLINT: allocators convert

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        const std::size_t size = (bytes + kPage - 1) / kPage * kPage;
        if (count > kMost) throw std::bad_array_new_length();
        if (bytes < kPage) return static_cast<T*>(::operator new(bytes, std::align_val_t(alignof(T))));
        void* memory = std::aligned_alloc(kPage, size);
        if (!memory) throw std::bad_alloc();
        madvise(memory, size, MADV_HUGEPAGE);  // a wish: without it everything works as well
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) {
        if (count * sizeof(T) < kPage) return ::operator delete(memory, std::align_val_t(alignof(T)));
        std::free(memory);
    }
    friend bool operator==(const LargePages&, const LargePages&) { return true; }

private:
    static constexpr std::size_t kPage = std::size_t(2) << 20;
    static constexpr std::size_t kMost = (~std::size_t(0) - kPage) / sizeof(T);
};

/// What rays jump about in, among millions: each page that the processor has to look up is waited for.
template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace rays
