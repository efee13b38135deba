#include "report.h"

#include <ctime>
#include <fstream>

#include "stats_json.h"

namespace bench {

using namespace gnomon;
using Json = nlohmann::ordered_json;

namespace {

Json to_json(const Series& s) {
    return {{"median", s.median()}, {"least", s.least()}, {"most", s.most()}, {"all", s.seconds}};
}

Json to_json(const Check& c) {
    return {{"pixels", c.pixels},
            {"wrong_ids", c.wrong_ids},
            {"flips", c.flips},
            {"max_radiance_error", c.max_radiance},
            {"max_distance_error", c.max_distance}};
}

Json kernels(const OwnTimes& own) {
    Json json = Json::array();
    for (size_t k = 0; k < own.kernels.size(); ++k) {
        const KernelStats& kernel = own.stats.kernels[k];
        json.push_back({{"kernel", kernel.kernel},
                        {"options", kernel.options},
                        {"launches", kernel.launches},
                        {"longest_launch_seconds", kernel.longest},
                        {"rays", kernel.rays},
                        {"seconds", to_json(own.kernels[k])}});
    }
    return json;
}

Json to_json(const OwnTimes& own) {
    return {{"accuracy", to_string(own.stats.accuracy)},
            {"lanes", own.stats.lanes},
            {"tile_rays", own.stats.tile_rays},
            {"tiles", own.stats.tiles},
            {"chunks", own.stats.chunks},
            {"planned_bytes", own.stats.planned_bytes},
            {"peak_bytes", own.stats.peak_bytes},
            {"rays", own.stats.rays},
            {"hits", own.stats.hits},
            {"undecided", own.stats.undecided},
            {"decided_exactly", own.stats.decided_exactly},
            {"decide_seconds", own.stats.decide_seconds},
            {"frame_seconds", to_json(own.frame)},
            {"prepare_seconds", to_json(own.prepare)},
            {"trace_seconds", to_json(own.trace)},
            {"longest_launch_seconds", own.longest_launch},
            {"kernels", kernels(own)},
            {"error", to_json(own.check)}};
}

Json to_json(const PeerTimes& peer) {
    if (peer.late) return {{"given_up", true}};
    return {{"given_up", false},
            {"mode", peer.mode},
            {"build_seconds", to_json(peer.build)},
            {"frame_seconds", to_json(peer.frame)},
            {"total_seconds", to_json(peer.total)},
            {"error", to_json(peer.check)},
            {"difference",
             {{"pixels", peer.difference.pixels},
              {"other_id", peer.difference.other_id},
              {"other_lights", peer.difference.other_lights}}}};
}

}  // namespace

Json to_json(const SceneTimes& times) {
    Json json = {{"scene", times.name}, {"about", times.about}};
    json["spheres"] = times.own.stats.spheres;
    json["lights"] = times.own.stats.lights;
    json["image"] = {{"width", times.image.width}, {"height", times.image.height}};
    if (times.load_seconds) json["load_seconds"] = *times.load_seconds;
    json["gnomon"] = to_json(times.own);
    if (!times.peer) return json;
    json["peer"] = to_json(*times.peer);
    if (!times.peer->late) json["peer_over_gnomon"] = times.peer->total.median() / times.own.frame.median();
    return json;
}

Json to_json(const ProcessTimes& times) {
    return {{"scene", times.name},
            {"first_seconds", to_json(times.first)},
            {"wall_seconds", to_json(times.wall)},
            {"stats", times.stats}};
}

Json circumstances(const DeviceInfo& device, int cores, const std::string& peer) {
    return {
        {"program", "gnomon " GNOMON_VERSION}, {"date", date()}, {"cpu", cpu_name()}, {"cores", cores}, {"peer", peer},
        {"device", gnomon::to_json(device)}};
}

std::string cpu_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string text; std::getline(file, text);)
        if (text.rfind("model name", 0) == 0) return text.substr(text.find(':') + 2);
    return "unknown";
}

std::string date() {
    const std::time_t time = std::time(nullptr);
    char text[sizeof "2000-01-01T00:00:00Z"];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&time));
    return text;
}

}  // namespace bench
