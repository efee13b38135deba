// Embree the way it is fastest on these scenes: point spheres, packets of 4 x 4 pixels (of 4 x 2 without AVX-512) from
// the eye's ray to the film without a buffer between, no shadow ray where a light is behind the surface, denormals
// flushed.
#if GNOMON_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif
#ifdef __SSE__
#include <pmmintrin.h>
#endif

#include <algorithm>

#include "clock.h"
#include "error.h"
#include "packet.h"
#include "peer.h"
#include "workers.h"

namespace bench {

namespace {

using namespace gnomon;

/// Flushes denormals in this thread for as long as it lives, as Embree's manual asks for.
class FlushDenormals {
  public:
#ifdef __SSE__
    FlushDenormals() { _mm_setcsr(before_ | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON); }
    ~FlushDenormals() { _mm_setcsr(before_); }

  private:
    unsigned before_ = _mm_getcsr();
#else
    FlushDenormals() {}
#endif
};

using RayHits = OF_PACKET(RTCRayHit);
using Rays = OF_PACKET(RTCRay);
using Hits = OF_PACKET(RTCHit);

#if GNOMON_EMBREE == 4
/// What a thread hands over with each query.
struct Queries {
    RTCIntersectArguments closest;
    RTCOccludedArguments any;
    explicit Queries(bool coherent) {
        rtcInitIntersectArguments(&closest);
        rtcInitOccludedArguments(&any);
        closest.flags = any.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
    }
    void intersect(RTCScene s, const Mask& valid, RayHits& p) { OF_PACKET(rtcIntersect)(valid.v, s, &p, &closest); }
    void occluded(RTCScene s, const Mask& valid, Rays& p) { OF_PACKET(rtcOccluded)(valid.v, s, &p, &any); }
};
#else
struct Queries {
    RTCIntersectContext context;
    explicit Queries(bool coherent) {
        rtcInitIntersectContext(&context);
        context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    }
    void intersect(RTCScene s, const Mask& valid, RayHits& p) { OF_PACKET(rtcIntersect)(valid.v, s, &context, &p); }
    void occluded(RTCScene s, const Mask& valid, Rays& p) { OF_PACKET(rtcOccluded)(valid.v, s, &context, &p); }
};
#endif

/// Pixels that a thread takes at a time.
constexpr int block_width = 64, block_height = 40;

class Embree : public Peer {
  public:
    Embree(const Scene& scene, int threads);
    ~Embree() override {
        if (scene_) rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    std::vector<std::string> modes() const override {
        return {"medium coherent", "medium incoherent", "low coherent", "low incoherent"};
    }
    void build(const std::string& mode) override;
    bool frame(Film& film, double limit) override { return render<false>(film, nullptr, limit); }
    bool picture(Film& film, Arrivals& arrivals, double limit) override {
        arrivals.words = (lights_.size() + 63) / 64;
        arrivals.bits.assign(film.pixels() * arrivals.words, 0);
        return render<true>(film, &arrivals, limit);
    }

  private:
    template <bool Whole>
    bool render(Film& film, Arrivals* arrivals, double limit);
    template <bool Whole>
    void render_packet(int i, int j, Queries& queries, Film& film, Arrivals* arrivals) const;
    template <bool Whole>
    void store(int i, int j, const Lanes3& light, const Hits& hit, Film& film) const;

    std::vector<float> spheres_, albedos_;
    size_t albedo_stride_ = 3;  ///< 0: all have one
    View view_;
    std::vector<PeerLight> lights_;
    RTCDevice device_;
    RTCScene scene_ = nullptr;
    bool coherent_ = true;
    Workers workers_;
};

/// All spheres take their albedo from one table.
bool has_one_albedo(const Scene& scene) {
    return scene.spheres.empty() && scene.tables.size() == 1 && scene.tables[0].columns == 4;
}

Embree::Embree(const Scene& scene, int threads)
    : albedo_stride_(has_one_albedo(scene) ? 0 : 3),
      view_(view_of(scene)),
      device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())),
      workers_(threads) {
    if (!device_) throw Error(Blame::run, "cannot make a device", "Embree");
    const auto count = static_cast<size_t>(sphere_count(scene));
    spheres_.resize(4 * count);
    albedos_.resize(albedo_stride_ > 0 ? 3 * count : 3);
    for_each_sphere(scene, [&](int64_t id, const Sphere& s) {
        const double row[] = {s.center.x, s.center.y, s.center.z, s.radius};
        std::copy(row, row + 4, &spheres_[4 * static_cast<size_t>(id)]);
        const double albedo[] = {s.albedo.r, s.albedo.g, s.albedo.b};
        std::copy(albedo, albedo + 3, &albedos_[albedo_stride_ * static_cast<size_t>(id)]);
    });
    for (const Light& light : scene.lights) lights_.push_back(light_of(light));
}

void Embree::build(const std::string& mode) {
    const FlushDenormals flush;
    if (scene_) rtcReleaseScene(scene_);
    coherent_ = mode.find(" coherent") != std::string::npos;
    const RTCBuildQuality quality = mode.rfind("low", 0) == 0 ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM;
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, quality);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, spheres_.data(), 0,
                               4 * sizeof(float), spheres_.size() / 4);
    rtcSetGeometryBuildQuality(geometry, quality);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    const RTCError error = rtcGetDeviceError(device_);
    if (error != RTC_ERROR_NONE) throw Error(Blame::run, "error " + std::to_string(error), "Embree");
}

template <bool Whole>
bool Embree::render(Film& film, Arrivals* arrivals, double limit) {
    const double deadline = now() + limit;
    const int columns = (film.width + block_width - 1) / block_width;
    const int rows = (film.height + block_height - 1) / block_height;
    std::atomic<bool> late{false};
    workers_.run(columns * rows, [&](int block) {
        if (late || now() > deadline) {
            late = true;
            return;
        }
        const FlushDenormals flush;
        Queries queries(coherent_);
        const int left = block % columns * block_width, top = block / columns * block_height;
        for (int j = top; j < std::min(top + block_height, film.height); j += packet_rows)
            for (int i = left; i < std::min(left + block_width, film.width); i += packet_columns)
                render_packet<Whole>(i, j, queries, film, arrivals);
    });
    return !late;
}

/// Notes that these of a packet's pixels see the light.
void note(Arrivals& arrivals, const Film& film, int i, int j, size_t light, const Lanes& share) {
    for (int k = 0; k < packet_rays; ++k) {
        const int x = i + k % packet_columns, y = j + k / packet_columns;
        if (share[k] <= 0 || x >= film.width || y >= film.height) continue;
        const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(film.width) + static_cast<size_t>(x);
        arrivals.bits[pixel * arrivals.words + light / 64] |= uint64_t{1} << light % 64;
    }
}

/// A packet that asks for the closest hits of all its rays.
void clear(Hits& hit, Mask& valid) {
    for (int k = 0; k < packet_rays; ++k) {
        valid.v[k] = -1;
        hit.geomID[k] = hit.primID[k] = hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    }
}

/// What arrives of one light, added to the sum. Embree has set tfar of an occluded ray to minus infinity.
void add(const Float3& phi, const Mask& valid, const Rays& shadow, Lanes& share, Lanes3& sum) {
    for (int k = 0; k < packet_rays; ++k) {
        share[k] = valid.v[k] != 0 && shadow.tfar[k] >= 0 ? share[k] : 0;
        sum.x[k] += share[k] * phi.x, sum.y[k] += share[k] * phi.y, sum.z[k] += share[k] * phi.z;
    }
}

template <bool Whole>
void Embree::render_packet(int i, int j, Queries& queries, Film& film, Arrivals* arrivals) const {
    alignas(64) RayHits packet;
    alignas(64) Rays shadow;
    Mask valid;
    Surface surface;
    Lanes share;
    Lanes3 sum{};
    clear(packet.hit, valid);
    aim(view_, i, j, packet.ray);
    queries.intersect(scene_, valid, packet);
    land(packet, RTC_INVALID_GEOMETRY_ID, surface);
    for (size_t l = 0; l < lights_.size(); ++l) {
        if (!aim_at(lights_[l], surface, shadow, valid, share)) continue;
        queries.occluded(scene_, valid, shadow);
        add(lights_[l].phi, valid, shadow, share, sum);
        if (Whole) note(*arrivals, film, i, j, l, share);
    }
    store<Whole>(i, j, sum, packet.hit, film);
}

template <bool Whole>
void Embree::store(int i, int j, const Lanes3& light, const Hits& hit, Film& film) const {
    Lanes3 albedo;
    for (int k = 0; k < packet_rays; ++k) {
        const bool is_hit = hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
        const float* rgb = &albedos_[is_hit ? albedo_stride_ * hit.primID[k] : 0];
        albedo.x[k] = rgb[0], albedo.y[k] = rgb[1], albedo.z[k] = rgb[2];
    }
    const int columns = std::min(packet_columns, film.width - i), rows = std::min(packet_rows, film.height - j);
    for (int row = 0; row < rows; ++row) {
        const size_t first = static_cast<size_t>(j + row) * static_cast<size_t>(film.width) + static_cast<size_t>(i);
        for (int column = 0; column < columns; ++column) {
            const int k = row * packet_columns + column;
            const size_t pixel = first + static_cast<size_t>(column);
            film.radiance[0][pixel] = light.x[k] * albedo.x[k];
            film.radiance[1][pixel] = light.y[k] * albedo.y[k];
            film.radiance[2][pixel] = light.z[k] * albedo.z[k];
            if (Whole) film.id[pixel] = static_cast<int32_t>(hit.primID[k]);
        }
    }
}

}  // namespace

std::string peer_name() { return "Embree " RTC_VERSION_STRING; }

std::unique_ptr<Peer> make_peer(const Scene& scene, int threads) { return std::make_unique<Embree>(scene, threads); }

}  // namespace bench
