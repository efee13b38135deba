#include "dealer.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace gnomon {

namespace {

class Dealer : public std::enable_shared_from_this<Dealer> {
  public:
    explicit Dealer(const Deal& what) : what_(what), playing_(what.workers) {
        for (size_t worker = 0; worker < what.workers; ++worker) turns_.push_back({worker, {}});
    }

    void run() {
        for (size_t worker = 0; worker < turns_.size(); ++worker) give_next(worker);
        std::unique_lock<std::mutex> lock(mutex_);
        size_t told = 0;
        const auto news = [&] { return what_.progress && !failure_ && ended_ != told; };
        while (playing_ > 0 || news()) {
            if (!changed_.wait_for(lock, std::chrono::seconds(1), [&] { return playing_ == 0 || news(); }))
                look_for_failures(lock);
            if (!news()) continue;
            told = ended_;
            tell(share_, lock);
        }
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    /// A worker, and the event that ends what it does; none if it does nothing.
    struct Turn {
        size_t worker;
        cl::Event end;
    };
    /// What the driver calls back for. It may do so after all is over, if look_for_failures was faster.
    struct Call {
        std::shared_ptr<Dealer> dealer;
        size_t worker;
    };

    void give_next(size_t worker) {
        cl::Event end = launch_next(worker);
        if (!end()) return;
        auto call = std::make_unique<Call>(Call{shared_from_this(), worker});
        try {
            end.setCallback(CL_COMPLETE, on_end, call.get());  // may call at once, on this thread
            call.release();                                    // on_end has it, or will have it
        } catch (const cl::Error&) {
            end_turn(worker, std::current_exception());
        }
    }

    /// If there is none the worker leaves.
    cl::Event launch_next(size_t worker) {
        const std::lock_guard<std::mutex> lock(mutex_);
        try {
            const cl::Event end = failure_ ? cl::Event() : what_.launch(worker);
            if (end()) return turns_[worker].end = end;
        } catch (...) {
            fail(std::current_exception());
        }
        --playing_;
        changed_.notify_all();
        return {};
    }

    static void CL_CALLBACK on_end(cl_event, cl_int, void* at) {
        const std::unique_ptr<Call> call(static_cast<Call*>(at));
        call->dealer->end_turn(call->worker);
    }

    void end_turn(size_t worker, const std::exception_ptr& failure = nullptr) {
        if (take_back(turns_[worker], failure)) give_next(worker);
    }

    static cl_int status_of(const cl::Event& event) { return event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>(); }

    /// False if that has been done before.
    bool take_back(Turn& turn, const std::exception_ptr& failure) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!turn.end()) return false;
        const cl::Event end = std::exchange(turn.end, {});
        try {
            if (failure) std::rethrow_exception(failure);
            // The event tells: PoCL calls back with CL_COMPLETE even for one that had failed before it was asked to.
            if (status_of(end) < 0) throw cl::Error(status_of(end), "a tile's launches");
            share_ = what_.ended(turn.worker);
            ++ended_;
        } catch (...) {
            fail(std::current_exception());
        }
        if (what_.progress) changed_.notify_all();
        return true;
    }

    /// Nothing is launched from now on. To be called under the lock.
    void fail(const std::exception_ptr& failure) {
        if (!failure_) failure_ = failure;
    }

    /// Not every driver calls back when a command fails: PoCL does not.
    void look_for_failures(std::unique_lock<std::mutex>& lock) {
        for (size_t worker = 0; worker < turns_.size(); ++worker) {
            if (!turns_[worker].end() || status_of(turns_[worker].end) >= 0) continue;
            lock.unlock();
            end_turn(worker);
            lock.lock();
        }
    }

    void tell(double share, std::unique_lock<std::mutex>& lock) {
        lock.unlock();
        std::exception_ptr failure;
        try {
            what_.progress(share);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (failure) fail(failure);
    }

    const Deal& what_;
    std::mutex mutex_;  // of all that follows
    std::condition_variable changed_;
    std::vector<Turn> turns_;
    size_t ended_ = 0;
    double share_ = 0;  // of all work, that is done
    size_t playing_;    // workers that may yet be given work
    std::exception_ptr failure_;
};

}  // namespace

void deal(const Deal& what) { std::make_shared<Dealer>(what)->run(); }

}  // namespace gnomon
