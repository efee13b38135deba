// What `gnomon verify` has recorded: that fingerprints tell where pictures differ, and that the certified pictures are
// right by the exact oracle, whose arithmetic and formulas are others.

#include "kernel_harness.h"
#include "quick_oracle.h"
#include "verify/verify.h"

using namespace gnomon;
using namespace gnomon::test;
using namespace gnomon::verify;

namespace {

Film grey(int width, int height) {
    Film film(width, height, {true, true, true, true});
    for (auto& plane : film.radiance) std::fill(plane.begin(), plane.end(), 0.5f);
    for (auto& plane : film.normal) std::fill(plane.begin(), plane.end(), 0.25f);
    std::fill(film.distance.begin(), film.distance.end(), 3.0f);
    std::fill(film.id.begin(), film.id.end(), 7);
    return film;
}

bool holds(const std::vector<Place>& places, size_t pixel, int width) {
    const auto at = static_cast<int>(pixel);
    return std::any_of(places.begin(), places.end(),
                       [&](const Place& p) { return p.x == at % width && p.y == at / width; });
}

/// Pixels whose ids are not the oracle's, or that a light does not reach as it says.
int wrong_decisions(Renderer& renderer, const Case& of, const Mode& mode) {
    const Print& expected = recorded().at(picture_name(of, mode));
    Film film;
    render(renderer, of, mode, film);
    CHECK(fingerprint(film).sha1 == expected.picture.sha1);
    const oracle::QuickOracle truth(of.scene);
    std::vector<Film> alone(of.scene.lights.size());
    for (size_t light = 0; light < alone.size(); ++light) {
        render_light(renderer, of, mode, light, true, alone[light]);
        CHECK(radiance_sha1(alone[light]) == expected.lights.at(light).shadowed);
    }
    int wrong = 0;
    for (size_t p = 0; p < film.pixels(); ++p) {
        const auto at = static_cast<int>(p);
        const oracle::Decisions right = truth.decide(at % film.width, at / film.width).decisions;
        wrong += film.id[p] != right.id;
        for (size_t light = 0; light < alone.size(); ++light) {
            const auto& radiance = alone[light].radiance;
            wrong += (radiance[0][p] > 0 || radiance[1][p] > 0 || radiance[2][p] > 0) != right.lit[light];
        }
    }
    return wrong;
}

void check_decisions(bool quick) {
    for (const DeviceInfo& device : list_devices()) DYNAMIC_SECTION(device.number() << " " << device.name) {
            Renderer renderer(device);
            for (const Case& of : cases(quick)) {
                if (!of.has(Accuracy::certified)) continue;
                INFO(of.name);
                CHECK(wrong_decisions(renderer, of, {Accuracy::certified, device.fp64}) == 0);
            }
        }
}

}  // namespace

TEST_CASE("verify's record: the first pixel that differs is found, however many do", "[verify]") {
    Random random(3);
    for (const ImageSize& size : {ImageSize{40, 30}, ImageSize{17, 64}, ImageSize{1, 9}, ImageSize{320, 240}})
        for (const size_t count : {1, 2, 8, 300}) {
            INFO(size.width << "x" << size.height << ", " << count);
            const Film film = grey(size.width, size.height);
            Film other = grey(size.width, size.height);
            size_t first = film.pixels(), changed = 0;
            for (; changed < count && changed < film.pixels(); ++changed) {
                const size_t at = random.word() % film.pixels();
                other.normal[1][at] = std::nextafter(film.normal[1][at], 1.0f);
                first = std::min(first, at);
            }
            const auto places = first_differing(fingerprint(other), fingerprint(film));
            CHECK(holds(places, first, size.width));
            if (count == 1) CHECK(places.size() == 1);
            const auto pixel = first_pixel(other, film);
            REQUIRE(pixel);
            CHECK(pixel->y * size.width + pixel->x == static_cast<int>(first));
            CHECK(pixel->channel == "N.Y");
            CHECK(pixel->expected == 0.25);
        }
    CHECK(first_differing(fingerprint(grey(8, 8)), fingerprint(grey(8, 8))).empty());
    CHECK_FALSE(first_pixel(grey(8, 8), grey(8, 8)));
}

TEST_CASE("verify's record: certified pictures have the oracle's ids and shadows", "[verify]") {
    check_decisions(true);
}

TEST_CASE("verify's record: the large certified pictures have the oracle's ids and shadows", "[.long]") {
    check_decisions(false);
}
