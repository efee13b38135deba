#include "huge_pages.h"

#include <sys/mman.h>

namespace gnomon {

void* allocate_huge(std::size_t bytes) {
    const std::size_t whole = (bytes + huge_page - 1) / huge_page * huge_page;
    void* memory = std::aligned_alloc(huge_page, whole);
    if (!memory) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    madvise(memory, whole, MADV_HUGEPAGE);  // a wish: without, the pages are small
#endif
    return memory;
}

}  // namespace gnomon
