// Threads that stay, and take parts of a work from a counter.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace bench {

class Workers {
  public:
    /// So many threads, the caller's among them.
    explicit Workers(int threads) {
        for (int i = 1; i < threads; ++i) threads_.emplace_back([this] { wait_and_work(); });
    }
    ~Workers() {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            stop_ = true;
        }
        started_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    /// Calls work(part) for each 0 <= part < parts.
    void run(int parts, const std::function<void(int)>& work) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            work_ = &work;
            parts_ = parts;
            next_ = 0;
            busy_ = threads_.size();
            ++round_;
        }
        started_.notify_all();
        take_parts();
        std::unique_lock<std::mutex> lock(mutex_);
        done_.wait(lock, [this] { return busy_ == 0; });
    }

  private:
    void take_parts() {
        for (int part = next_++; part < parts_; part = next_++) (*work_)(part);
    }

    void wait_and_work() {
        std::unique_lock<std::mutex> lock(mutex_);
        for (uint64_t seen = 0;;) {
            started_.wait(lock, [&] { return stop_ || round_ != seen; });
            if (stop_) return;
            seen = round_;
            lock.unlock();
            take_parts();
            lock.lock();
            if (--busy_ == 0) done_.notify_one();
        }
    }

    std::mutex mutex_;
    std::condition_variable started_, done_;
    const std::function<void(int)>* work_ = nullptr;
    std::atomic<int> next_{0};
    int parts_ = 0;
    size_t busy_ = 0;
    uint64_t round_ = 0;
    bool stop_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace bench
