#include "measure_roots.h"

#include <algorithm>

#include "error.h"
#include "launcher.h"

namespace gnomon::report {

namespace {

// Rays a launch that is timed. On a CPU what it writes, 16 bytes each, should stay in the caches; a GPU wants to be
// busy for longer than a launch takes to begin.
constexpr int64_t cpu_rays = 1 << 18, gpu_rays = 1 << 22;

Plan plan_for(const DeviceInfo& info) {
    Scene scene;
    scene.spheres = {{{0, 0, 2}, 1, {1, 1, 1}}};
    return make_plan(scene, survey(scene), {}, DeviceLimits(info));
}

std::vector<float> block_ordered(const std::vector<Float3>& dirs) {
    std::vector<float> values(3 * dirs.size());
    for (size_t i = 0; i < dirs.size(); ++i) {
        values[in_block_order(i, 0, 3)] = dirs[i].x;
        values[in_block_order(i, 1, 3)] = dirs[i].y;
        values[in_block_order(i, 2, 3)] = dirs[i].z;
    }
    return values;
}

template <class T>
cl::Buffer copy(const cl::Context& context, std::vector<T> values) {
    return {context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, values.size() * sizeof(T), values.data()};
}

}  // namespace

/// A case on the device, and room for what a launch of `rays` rays finds.
struct RootsBench::Buffers {
    cl::Buffer dirs, spheres, ts, normals;

    Buffers(const cl::Context& context, const RootCase& of, size_t rays)
        : dirs(copy(context, block_ordered(of.dirs))),
          spheres(copy(context, of.spheres)),
          ts(context, CL_MEM_WRITE_ONLY, rays * sizeof(float)),
          normals(context, CL_MEM_WRITE_ONLY, 3 * rays * sizeof(float)) {}
};

RootsBench::RootsBench(const DeviceInfo& device) try
    : info_(device),
      plan_(plan_for(device)),
      device_(open_device(device)),
      context_(device_),
      queue_(context_, device_, CL_QUEUE_PROFILING_ENABLE),
      programs_(context_, {device_}, device) {
} catch (const cl::Error& error) {
    throw Error(Blame::run, describe(error), device.name);
}

cl::Kernel RootsBench::kernel(const Formula& formula) {
    const Variant variant{Kernel::measure_roots,
                          {"LANES=" + std::to_string(plan_.lanes), "PACKETS=" + std::to_string(plan_.packets),
                           "FORMULA=" + formula.name}};
    return programs_.get(variant).kernel;
}

double RootsBench::nanoseconds_per_ray(const cl::Kernel& kernel, int64_t rays) {
    const auto items = static_cast<size_t>(rays / plan_.rays_per_item()), local = static_cast<size_t>(plan_.local_size);
    cl::Event done;
    queue_.enqueueNDRangeKernel(kernel, cl::NullRange, (items + local - 1) / local * local, local, nullptr, &done);
    done.wait();
    return 1e9 * seconds_of(done) / static_cast<double>(rays);
}

/// What a launch has just found for the rays of the case, the first that it wrote.
Roots RootsBench::read(const Buffers& buffers, size_t rays) {
    Roots roots{std::vector<float>(rays), std::vector<float>(3 * rays), {}};
    queue_.enqueueReadBuffer(buffers.ts, CL_TRUE, 0, rays * sizeof(float), roots.ts.data());
    queue_.enqueueReadBuffer(buffers.normals, CL_TRUE, 0, 3 * rays * sizeof(float), roots.normals.data());
    return roots;
}

std::vector<Roots> RootsBench::measure(const RootCase& of, const std::vector<Formula>& formulas, int rounds) try {
    const auto rays = static_cast<int64_t>(of.dirs.size());
    const int64_t timed = std::max(rays, info_.type == DeviceType::cpu ? cpu_rays : gpu_rays);
    const Buffers buffers(context_, of, static_cast<size_t>(timed));
    std::vector<cl::Kernel> kernels;
    std::vector<Roots> results;
    for (const Formula& formula : formulas) {
        kernels.push_back(kernel(formula));
        Arguments(kernels.back())
            .add(buffers.dirs, buffers.spheres, static_cast<int>(rays / plan_.rays_per_item()),
                 static_cast<int>(timed / plan_.rays_per_item()), buffers.ts, buffers.normals, 0);
        nanoseconds_per_ray(kernels.back(), timed);  // the first launch is never the quickest
        results.push_back(read(buffers, of.dirs.size()));
    }
    std::vector<std::vector<double>> times(formulas.size());
    for (int round = 0; round < rounds; ++round)
        for (size_t i = 0; i < kernels.size(); ++i) times[i].push_back(nanoseconds_per_ray(kernels[i], timed));
    for (size_t i = 0; i < kernels.size(); ++i) results[i].ns_per_ray = series(times[i]);
    return results;
} catch (const cl::Error& error) {
    throw Error(Blame::run, describe(error), info_.name);
}

}  // namespace gnomon::report
