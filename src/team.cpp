#include "team.h"

#include <algorithm>
#include <future>
#include <limits>
#include <mutex>

#include "error.h"
#include "shortcomings.h"
#include "tiling.h"

namespace gnomon {

namespace {

/// Where several write parts of one film it is only safe to let a driver have it if that works in the host's memory
/// itself, as PoCL does on a CPU: another may copy all of a plane back over what the others wrote.
DeviceLimits limits_of(const DeviceInfo& device, bool alone) {
    DeviceLimits limits(device);
    if (!alone && !device.is_pocl()) limits.shares_memory = false;
    return limits;
}

/// Tiles that all plans have room for, smaller to the end. A core that goes through all passes of a tile does so in its
/// cache, with one set of buffers.
void share_tiles(std::vector<Plan>& plans, const std::vector<DeviceLimits>& limits) {
    int workers = 0;
    int64_t rays = std::numeric_limits<int>::max();
    for (size_t i = 0; i < plans.size(); ++i) {
        Plan& plan = plans[i];
        plan.shares_tiles = true;
        workers += plan.workers;
        rays = std::min(rays, int64_t{plan.tile_blocks} * BLOCK_RAYS);
        if (!deals_tiles(plan)) continue;
        rays = std::min(rays, core_tile_rays(real_bytes(plan.accuracy), limits[i]));
        plan.tile_sets = plan.workers;
    }
    const Tiling tiling = for_team(plans.front().image, workers, static_cast<int>(rays));
    for (Plan& plan : plans) {
        plan.tiles = tiling.tiles;
        plan.tile_blocks = tiling.largest();
    }
}

std::string name_of(const DeviceInfo& device) { return device.number() + " " + device.name; }

/// What a member did, added to what others did at the same time.
void add(const RenderStats& member, RenderStats& all) {
    all.planned_bytes += member.planned_bytes;
    all.peak_bytes += member.peak_bytes;
    all.pixels += member.pixels;
    all.hits += member.hits;
    all.rays += member.rays;
    all.undecided += member.undecided;
    all.decided_exactly += member.decided_exactly;
    all.chunks = std::max(all.chunks, member.chunks);
    for (double RenderStats::*seconds :
         {&RenderStats::prepare_seconds, &RenderStats::build_seconds, &RenderStats::trace_seconds,
          &RenderStats::decide_seconds, &RenderStats::longest_launch})
        all.*seconds = std::max(all.*seconds, member.*seconds);
    all.kernels.insert(all.kernels.end(), member.kernels.begin(), member.kernels.end());
    all.warnings.insert(all.warnings.end(), member.warnings.begin(), member.warnings.end());
    all.shares.insert(all.shares.end(), member.shares.begin(), member.shares.end());
}

/// All results; throws the first error if there is one, for others may have stopped because of it.
std::vector<RenderStats> results_of(std::vector<std::future<RenderStats>>& running) {
    std::vector<RenderStats> results;
    std::exception_ptr failure, stop;
    for (std::future<RenderStats>& member : running) {
        try {
            results.push_back(member.get());
        } catch (const Stopped&) {
            stop = std::current_exception();
        } catch (...) {
            if (!failure) failure = std::current_exception();
        }
    }
    if (failure) std::rethrow_exception(failure);
    if (stop) std::rethrow_exception(stop);
    return results;
}

}  // namespace

Team::Team(const std::vector<DeviceInfo>& devices) {
    if (devices.empty()) throw Error(Blame::run, "no device to render on");
    for (const DeviceInfo& device : with_cores_joined(devices)) {
        check_usable(device);
        try {
            members_.push_back(std::make_unique<DeviceRenderer>(device));
        } catch (const cl::Error& error) {
            throw Error(Blame::run, describe(error), name_of(device));
        }
    }
}

void Team::check_accuracy(Accuracy accuracy) const {
    for (const auto& member : members_) gnomon::check_accuracy(accuracy, member->info());
}

std::vector<Plan> Team::make_plans(const Scene& scene, const Survey& survey, const RenderOptions& options) const {
    std::vector<Plan> plans;
    for (const auto& member : members_) check_spheres(survey.count, member->info());
    std::vector<DeviceLimits> limits;
    for (const auto& member : members_) {
        limits.push_back(limits_of(member->info(), !has_several()));
        plans.push_back(make_plan(scene, survey, options, limits.back()));
    }
    if (has_several()) share_tiles(plans, limits);
    return plans;
}

RenderStats Team::render(const Scene& scene, const Survey& survey, const Frame& frame, const std::vector<Plan>& plans,
                         const RenderOptions& options, Film& film) {
    TileQueue queue(plans.front().tiles.size());
    if (!has_several()) return members_.front()->render({scene, survey, frame, plans.front(), options}, queue, film);
    const auto job = [&](size_t i, const RenderOptions& its) { return Job{scene, survey, frame, plans[i], its}; };
    const std::vector<RenderStats> results = render_at_once(job, options, queue, film);
    RenderStats all = results.front();
    for (size_t i = 1; i < results.size(); ++i) add(results[i], all);
    return all;
}

/// Each member in a thread of its own.
std::vector<RenderStats> Team::render_at_once(const MakeJob& make_job, const RenderOptions& options, TileQueue& queue,
                                              Film& film) {
    RenderOptions shared = options;
    std::mutex telling;
    if (options.progress)
        shared.progress = [&](double done) {
            const std::lock_guard<std::mutex> lock(telling);
            options.progress(done);
        };
    std::vector<std::future<RenderStats>> running;
    for (size_t i = 0; i < members_.size(); ++i)
        running.push_back(std::async(std::launch::async, [&, i] {
            try {
                return members_[i]->render(make_job(i, shared), queue, film);
            } catch (...) {
                queue.close();
                throw;
            }
        }));
    return results_of(running);
}

}  // namespace gnomon
