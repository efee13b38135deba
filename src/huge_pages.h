// Memory in huge pages, if the system has them: walks that go to another page with almost each step then find it.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace gnomon {

/// A huge page, in bytes: less is not worth one.
constexpr std::size_t huge_page = std::size_t{2} << 20;

/// At least so many bytes, not cleared, from the start of a huge page on. Throws std::bad_alloc. Given back by
/// std::free().
void* allocate_huge(std::size_t bytes);

/// For large vectors.
template <class T>
struct HugeAllocator {
    using value_type = T;

    HugeAllocator() = default;
    template <class U>
    HugeAllocator(const HugeAllocator<U>&) {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        return static_cast<T*>(bytes < huge_page ? ::operator new(bytes) : allocate_huge(bytes));
    }
    void deallocate(T* memory, std::size_t count) {
        if (count * sizeof(T) < huge_page)
            ::operator delete(memory);
        else
            std::free(memory);
    }

    bool operator==(const HugeAllocator&) const { return true; }
    bool operator!=(const HugeAllocator&) const { return false; }
};
template <class T>
using HugeVector = std::vector<T, HugeAllocator<T>>;

}  // namespace gnomon
