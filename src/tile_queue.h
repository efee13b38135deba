// Hands out tiles to whoever is free.
#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <mutex>
#include <optional>

namespace gnomon {

/// Tiles 0, 1, ..., each once, and how much of them all is done. For use by several threads.
class TileQueue {
  public:
    explicit TileQueue(size_t tiles) : tiles_(tiles) {}

    /// The next tile; none when all are taken.
    std::optional<size_t> take() {
        const size_t tile = next_++;
        return tile < tiles_ ? std::optional<size_t>(tile) : std::nullopt;
    }
    /// From now on there are none.
    void close() { next_ = tiles_; }

    /// So much of all tiles, 0 to 1, has been done by one of those who take them; returns what all have done.
    double done(const void* who, double share) {
        const std::lock_guard<std::mutex> lock(mutex_);
        shares_[who] = share;
        double all = 0;
        for (const auto& [taker, part] : shares_) all += part;
        return all;
    }

  private:
    size_t tiles_;
    std::atomic<size_t> next_{0};
    std::mutex mutex_;                      // of shares_
    std::map<const void*, double> shares_;  // that have been done
};

}  // namespace gnomon
