// The fat ray that intersect_closest makes of a block's corner pixels passes over nothing that one of its rays meets.
#include "bundles.h"
#include "intersect_harness.h"
#include "random_camera.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// For each block a sphere that the ray of one of its corner pixels touches, on the side away from the block's middle.
void add_touching(Scene& scene, const Tile& tile, Random& random) {
    const auto dir = [&](int i, int j) { return to_float(reference::eye_ray(scene, i, j).dir); };
    std::vector<Sphere> spheres;
    for (int block = 0; block < tile.blocks; ++block) {
        const int x = block % tile.blocks_x * BLOCK_SIDE, y = block / tile.blocks_x * BLOCK_SIDE, last = BLOCK_SIDE - 1;
        const bool right = random.uniform(0, 1) < 0.5, low = random.uniform(0, 1) < 0.5;
        const std::vector<Float3> rays{dir(x + right * last, y + low * last), dir(x + !right * last, y + !low * last)};
        const double distance = random.scale(1e-2, 1e6);
        Sphere sphere = touching(rays, distance, distance * random.scale(1e-6, 2e-3), random.uniform(-3, 3));
        sphere.center = sphere.center + scene.camera.eye;
        spheres.push_back(sphere);
    }
    scene.spheres = spheres;
}

/// How many blocks' own spheres were met; all walks and widths are compared with rays that are read, and met by every
/// sphere.
int64_t met(Bench& bench, const Scene& scene, const Tile& tile) {
    const PencilSpheres spheres = seen_from_eye(bench, scene);
    const std::vector<float> dirs = generated_rays(bench, widths[0], scene, tile);
    const Hits expected = closest(bench, widths[0], scene.camera, brute(spheres), dirs);
    for (const Width& w : widths) {
        INFO(w);
        CHECK(same_bits(closest_of_pixels(bench, w, scene, tile, spheres), expected));
        CHECK(same_bits(closest_of_pixels(bench, w, scene, tile, brute(spheres)), expected));
    }
    return std::count_if(expected.ids.begin(), expected.ids.end(), [](int id) { return id >= 0; });
}

}  // namespace

TEST_CASE("culling: pixels' rays that barely touch spheres", "[culling][eye]") {
    on_every_bench([](Bench& bench) {
        Random random(61);
        int64_t spheres = 0, hits = 0;
        for (const double fov : {1e-2, 1.0, 40.0, 90.0, 150.0, 175.0})
            for (const ImageSize& size : {ImageSize{61, 43}, {320, 8}, {128, 96}}) {
                INFO("fov " << fov);
                Scene scene = random_camera(random, fov, size.width, size.height);
                scene.camera.eye = {0, 0, 0};
                scene.camera.at = random.direction();
                const Tile tile = whole(size);
                add_touching(scene, tile, random);
                hits += met(bench, scene, tile);
                spheres += static_cast<int64_t>(scene.spheres.size());
            }
        CHECK(hits > spheres / 5);  // and not all: the rest was touched from outside
    });
}
