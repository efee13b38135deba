#include "device_memory.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>
#include <utility>

namespace gnomon {

/// What a buffer takes, kept until the driver lets go of it, which may be after its last handle here.
struct DeviceMemory::Charge {
    std::shared_ptr<Meter> meter;
    int64_t bytes;
    BlockPool::Block block;  // what the buffer lies in, if that is ours
};

DeviceMemory::DeviceMemory(const cl::Context& context, bool shared)
    : context_(context), shared_(shared), meter_(std::make_shared<Meter>()) {
    expect(std::numeric_limits<int64_t>::max(), false);
}

void CL_CALLBACK DeviceMemory::give_back(cl_mem, void* charge) {
    const std::unique_ptr<Charge> held(static_cast<Charge*>(charge));
    if (held->block.memory)
        held->meter->pool.give_back(std::move(held->block));
    else
        held->meter->small -= held->bytes;
    held->meter->now -= held->bytes;
}

void DeviceMemory::expect(int64_t bytes, bool scarce) {
    meter_->expected = bytes;
    meter_->scarce = scarce;
    await_room(0);
    meter_->pool.shrink_to(static_cast<size_t>(room_for_blocks()));
    meter_->peak = meter_->now.load();
}

int64_t DeviceMemory::room_for_blocks() const { return std::max<int64_t>(meter_->expected - meter_->small, 0); }

void DeviceMemory::await_room(int64_t bytes) const {
    using namespace std::chrono_literals;
    constexpr auto moment = 20us;
    constexpr int patience = 500;  // 10 ms: after that it is not the driver that is late
    for (int i = 0; meter_->scarce && i < patience && meter_->now + bytes > meter_->expected; ++i)
        std::this_thread::sleep_for(moment);
}

cl::Buffer DeviceMemory::allocate(cl_mem_flags flags, size_t bytes, const void* values) const {
    const auto size = static_cast<int64_t>(bytes);
    await_room(size);
    auto charge = std::make_unique<Charge>(Charge{meter_, size, {}});
    if (shared_ && !values && bytes >= BlockPool::least) {
        charge->block = meter_->pool.take(bytes, static_cast<size_t>(room_for_blocks()));
        flags |= CL_MEM_USE_HOST_PTR;
        values = charge->block.memory.get();
    } else {
        meter_->small += size;
    }
    cl::Buffer buffer(context_, flags, bytes, const_cast<void*>(values));
    buffer.setDestructorCallback(give_back, charge.get());
    charge.release();  // the driver has it
    meter_->now += size;
    meter_->peak = std::max<int64_t>(meter_->peak, meter_->small + static_cast<int64_t>(meter_->pool.held()));
    return buffer;
}

}  // namespace gnomon
