#include "block_pool.h"

#include <utility>

#include "huge_pages.h"

namespace gnomon {

BlockPool::Block BlockPool::take(size_t bytes, size_t most) {
    const size_t whole = (bytes + least - 1) / least * least;
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = idle_.lower_bound(whole);
    if (found != idle_.end() && found->first <= whole + whole / 4) {
        Block block = std::move(found->second);
        idle_.erase(found);
        return block;
    }
    free_idle(most > whole ? most - whole : 0);
    Block block{std::unique_ptr<void, Free>(allocate_huge(whole)), whole};
    held_ += whole;
    return block;
}

void BlockPool::give_back(Block block) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const size_t bytes = block.bytes;
    idle_.emplace(bytes, std::move(block));
}

void BlockPool::shrink_to(size_t most) {
    const std::lock_guard<std::mutex> lock(mutex_);
    free_idle(most);
}

void BlockPool::free_idle(size_t most) {
    while (!idle_.empty() && held_ > most) {
        held_ -= idle_.begin()->first;
        idle_.erase(idle_.begin());
    }
}

size_t BlockPool::held() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return held_;
}

}  // namespace gnomon
