// Host memory for buffers of devices that work in it: large blocks, kept for those that come after.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>

#include "huge_pages.h"

namespace gnomon {

/// A page that is new must be cleared, which for what is allocated once a pencil costs more than the kernels that fill
/// it; and a walk through a hierarchy goes to another page with almost each step. So blocks are used again, and lie in
/// huge pages if the system has them. Safe for use by several threads.
class BlockPool {
  public:
    struct Free {
        void operator()(void* memory) const { std::free(memory); }
    };
    struct Block {
        std::unique_ptr<void, Free> memory;
        size_t bytes = 0;
    };

    /// The least that is worth a block.
    static constexpr size_t least = huge_page;

    /// At least so many bytes, not cleared. No more than `most` are held in all, idle ones included, as far as those
    /// can be let go. Throws std::bad_alloc.
    Block take(size_t bytes, size_t most);
    void give_back(Block block);
    /// Lets go of idle ones until no more than `most` bytes are held in all, as far as that goes.
    void shrink_to(size_t most);

    /// Taken and idle ones.
    size_t held() const;

  private:
    void free_idle(size_t most);  // under the lock

    mutable std::mutex mutex_;
    std::multimap<size_t, Block> idle_;  // by bytes
    size_t held_ = 0;
};

}  // namespace gnomon
