#include "stats_json.h"

#include "shortcomings.h"

#include <fmt/core.h>

#include <algorithm>

namespace gnomon {

using Json = nlohmann::ordered_json;

namespace {

double mrays_per_second(int64_t rays, double seconds) {
    return seconds > 0 ? 1e-6 * static_cast<double>(rays) / seconds : 0;
}

Json to_json(const DeviceShare& s) {
    Json json = to_json(s.device);
    json["tiles"] = s.tiles;
    json["rays"] = s.rays;
    json["trace_seconds"] = s.seconds;
    return json;
}

Json to_json(const KernelStats& k) {
    return {{"device", k.device},
            {"kernel", k.kernel},
            {"options", k.options},
            {"build_seconds", k.build_seconds},
            {"from_cache", k.from_cache},
            {"launches", k.launches},
            {"seconds", k.seconds},
            {"longest_launch_seconds", k.longest},
            {"rays", k.rays},
            {"mrays_per_second", mrays_per_second(k.rays, k.seconds)}};
}

Json to_json(const Check& c) {
    return {{"reference", "double precision, every sphere against every ray; maxima over the sampled pixels"},
            {"pixels", c.pixels},
            {"wrong_ids", c.wrong_ids},
            {"flips", c.flips},
            {"max_radiance_error", c.max_radiance},
            {"max_distance_error", c.max_distance}};
}

}  // namespace

Json to_json(const DeviceInfo& d) {
    Json lacks = Json::array();
    for (const Shortcoming& s : shortcomings(d))
        lacks.push_back({{"what", s.lack}, {"answer", s.answer}, {"usable", s.usable}});
    return {{"number", d.number()},
            {"type", to_string(d.type)},
            {"name", d.name},
            {"platform", d.platform_name},
            {"version", d.version},
            {"driver", d.driver},
            {"compute_units", d.compute_units},
            {"sub_devices", d.sub_devices},
            {"core_cache_bytes", d.core_cache_bytes},
            {"native_width_float", d.native_width_float},
            {"max_work_group", d.max_work_group},
            {"global_bytes", d.global_bytes},
            {"max_alloc_bytes", d.max_alloc_bytes},
            {"correctly_rounded", d.correctly_rounded},
            {"double", d.fp64},
            {"out_of_order", d.out_of_order},
            {"shares_memory", d.shares_memory},
            {"address_bits", d.address_bits},
            {"max_parameter_bytes", d.max_parameter_bytes},
            {"max_constant_bytes", d.max_constant_bytes},
            {"fast_fma", d.fast_fma},
            {"subnormals", d.subnormals},
            {"little_endian", d.little_endian},
            {"compiler", d.has_compiler},
            {"lacks", lacks}};
}

Json to_json(const RunStats& run, const Scene& scene, const std::vector<DeviceInfo>& devices) {
    const RenderStats& r = run.render;
    Json json;
    json["program"] = "gnomon " GNOMON_VERSION;
    json["device"] = to_json(devices.front());
    json["scene"] = {{"file", run.scene_path}, {"sha1", scene.sha1}, {"spheres", r.spheres}, {"lights", r.lights}};
    json["accuracy"] = to_string(r.accuracy);
    json["image"] = {{"width", scene.image.width}, {"height", scene.image.height}};
    json["plan"] = {
        {"lanes", r.lanes},     {"packets", r.packets}, {"tile_rays", r.tile_rays},        {"tiles", r.tiles},
        {"workers", r.workers}, {"chunks", r.chunks},   {"planned_bytes", r.planned_bytes}};
    json["seconds"] = {{"load", run.load_seconds},     {"device", run.device_seconds}, {"build", r.build_seconds},
                       {"prepare", r.prepare_seconds}, {"trace", r.trace_seconds},     {"write", run.write_seconds},
                       {"check", run.check_seconds}};
    json["longest_launch_seconds"] = r.longest_launch;
    json["peak_bytes"] = r.peak_bytes;
    json["rays"] = r.rays;
    json["hits"] = r.hits;
    json["mrays_per_second"] = mrays_per_second(r.rays, r.trace_seconds);
    json["error"] = to_json(run.check);
    json["devices"] = Json::array();
    for (const DeviceShare& share : r.shares) json["devices"].push_back(to_json(share));
    json["kernels"] = Json::array();
    for (const KernelStats& kernel : r.kernels) json["kernels"].push_back(to_json(kernel));
    return json;
}

std::string summary(const RunStats& run, const std::vector<DeviceInfo>& devices, const ImageSize& image) {
    const std::string others = devices.size() > 1 ? fmt::format(" and {} more", devices.size() - 1) : "";
    const RenderStats& r = run.render;
    const Check& c = run.check;
    return fmt::format(
        "{}{}: {}x{}, {} spheres, {} lights, {}; load {:.3f} s, device {:.3f}, build {:.3f}, prepare {:.3f}, trace "
        "{:.3f}, "
        "write {:.3f}; {:.0f} Mrays/s, of {} pixels {} wrong, else within {:.1e} of double",
        devices.front().name, others, image.width, image.height, r.spheres, r.lights, to_string(r.accuracy),
        run.load_seconds, run.device_seconds, r.build_seconds, r.prepare_seconds, r.trace_seconds, run.write_seconds,
        mrays_per_second(r.rays, r.trace_seconds), c.pixels, std::max(c.wrong_ids, c.flips),
        std::max(c.max_radiance, c.max_distance));
}

std::string shares(const RenderStats& stats) {
    std::string line;
    for (const DeviceShare& share : stats.shares)
        line += fmt::format("{}{}: {} tiles, {:.2f} Mrays in {:.3f} s", line.empty() ? "" : "; ", share.device.number(),
                            share.tiles, 1e-6 * static_cast<double>(share.rays), share.seconds);
    return line;
}

}  // namespace gnomon
