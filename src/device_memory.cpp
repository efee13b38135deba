#include "device_memory.h"

#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <new>
#include <thread>
#include <utility>

namespace gnomon {

namespace {

constexpr size_t huge_page = size_t{2} << 20;

struct Free {
    void operator()(void* block) const { std::free(block); }
};
using Block = std::unique_ptr<void, Free>;

/// Host memory in huge pages, if the system has them: a walk through a hierarchy goes to a new page with almost each
/// step, and a page that is new must be cleared.
Block huge_block(size_t bytes) {
    Block block(std::aligned_alloc(huge_page, (bytes + huge_page - 1) / huge_page * huge_page));
    if (!block) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    madvise(block.get(), bytes, MADV_HUGEPAGE);  // a wish: without, the pages are small
#endif
    return block;
}

/// Kept until the driver lets go of the buffer, which may be after its last handle here.
template <class Meter>
struct Charge {
    std::shared_ptr<Meter> meter;
    int64_t bytes;
    Block block;  // what the buffer lies in, if that is ours
};

}  // namespace

DeviceMemory::DeviceMemory(const cl::Context& context, bool shared)
    : context_(context), shared_(shared), meter_(std::make_shared<Meter>()) {
    expect(std::numeric_limits<int64_t>::max());
}

void CL_CALLBACK DeviceMemory::give_back(cl_mem, void* charge) {
    const std::unique_ptr<Charge<Meter>> held(static_cast<Charge<Meter>*>(charge));
    held->meter->now -= held->bytes;
}

void DeviceMemory::expect(int64_t bytes) {
    meter_->expected = bytes;
    meter_->peak = meter_->now.load();
}

void DeviceMemory::await_room(int64_t bytes) const {
    using namespace std::chrono_literals;
    constexpr auto moment = 20us;
    constexpr int patience = 500;  // 10 ms: after that it is not the driver that is late
    for (int i = 0; i < patience && meter_->now + bytes > meter_->expected; ++i) std::this_thread::sleep_for(moment);
}

cl::Buffer DeviceMemory::allocate(cl_mem_flags flags, size_t bytes, const void* values) const {
    const auto size = static_cast<int64_t>(bytes);
    await_room(size);
    Block block;
    if (shared_ && !values && bytes >= huge_page) {
        block = huge_block(bytes);
        flags |= CL_MEM_USE_HOST_PTR;
        values = block.get();
    }
    cl::Buffer buffer(context_, flags, bytes, const_cast<void*>(values));
    auto charge = std::make_unique<Charge<Meter>>(Charge<Meter>{meter_, size, std::move(block)});
    buffer.setDestructorCallback(give_back, charge.get());
    charge.release();  // the driver has it
    meter_->now += size;
    meter_->peak = std::max<int64_t>(meter_->peak, meter_->now);
    return buffer;
}

}  // namespace gnomon
