// Buffers on a device, and how many bytes of it they take.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "block_pool.h"
#include "opencl.h"

namespace gnomon {

/// Allocates buffers and keeps count of what is alive, and of the most that ever was, with what is kept for buffers to
/// come. Host memory that a device reads in place does not count.
class DeviceMemory {
  public:
    /// `shared`: the device works on host memory itself.
    DeviceMemory(const cl::Context& context, bool shared);

    /// Room for some values; never empty, for kernels must be given a buffer even where they use none.
    template <class T>
    cl::Buffer room(int64_t values) const {
        return allocate(CL_MEM_READ_WRITE, sizeof(T) * static_cast<size_t>(values > 0 ? values : 1), nullptr);
    }
    /// A copy of some values.
    template <class T>
    cl::Buffer copy(const T* values, int64_t count) const {
        return allocate(CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, sizeof(T) * static_cast<size_t>(count), values);
    }
    /// The values themselves where the device shares the host's memory, else a copy. They must outlive the buffer.
    template <class T>
    cl::Buffer over(const T* values, int64_t count) const {
        if (!shared_) return copy(values, count);
        return cl::Buffer(context_, CL_MEM_READ_ONLY | CL_MEM_USE_HOST_PTR, sizeof(T) * static_cast<size_t>(count),
                          const_cast<T*>(values));  // the binding takes what it reads from as not const
    }

    /// The most that was alive at once since expect().
    int64_t peak() const { return meter_->peak; }
    /// No more than this should be alive at once from now on. Drivers give a buffer back a moment after the last
    /// command that uses it: what would go beyond waits for that if memory is `scarce`.
    void expect(int64_t bytes, bool scarce);

  private:
    struct Meter {
        std::atomic<int64_t> now{0}, peak{0}, expected{0};
        std::atomic<bool> scarce{false};
        std::atomic<int64_t> small{0};  // of now, what lies in no block of the pool
        BlockPool pool;
    };
    cl::Buffer allocate(cl_mem_flags flags, size_t bytes, const void* values) const;
    struct Charge;
    void await_room(int64_t bytes) const;
    int64_t room_for_blocks() const;
    static void CL_CALLBACK give_back(cl_mem buffer, void* charge);

    cl::Context context_;
    bool shared_;
    std::shared_ptr<Meter> meter_;
};

}  // namespace gnomon
