// generate_rays alone: directions against the reference's, by tiles, over the image's edges and beyond.
#include "intersect_harness.h"
#include "random_camera.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

std::vector<float> generate(Bench& bench, Width w, const EyePencil& eye, const Tile& tile) {
    INFO(w);
    GuardedBuffer<float> dirs(bench, static_cast<size_t>(tile.blocks) * BLOCK_RAYS * 3);
    const int items = tile.blocks * BLOCK_RAYS / w.rays();
    bench.launch(bench.programs.get({Kernel::generate_rays, w.defines()}).kernel, items, eye, tile, items,
                 dirs.buffer());
    return dirs.read();
}

/// Of one ray a work-item, after checking that the other widths, and intersect_closest, give the same bits.
std::vector<float> generate(Bench& bench, const Scene& scene, const Tile& tile) {
    const EyePencil eye = eye_pencil(scene.camera, scene.image);
    const std::vector<float> dirs = generate(bench, widths[0], eye, tile);
    for (const Width& w : widths) {
        INFO(w);
        CHECK(same_bits(generate(bench, w, eye, tile), dirs));
        CHECK(same_bits(generated_rays(bench, w, scene, tile), dirs));
    }
    return dirs;
}

Float3 at(const std::vector<float>& dirs, const Tile& tile, int i, int j) {
    const int block = j / BLOCK_SIDE * tile.blocks_x + i / BLOCK_SIDE;
    return unpacked(dirs, static_cast<size_t>(block * BLOCK_RAYS + j % BLOCK_SIDE * BLOCK_SIDE + i % BLOCK_SIDE));
}

struct Wrong {
    int directions = 0, lengths = 0, outside = 0, inside = 0;
};

/// Before it is normalised, a direction is forward + x right + y up with three orthogonal terms, so the sum of their
/// lengths is at most sqrt(3) times its own. The basis is rounded once: sqrt(3) u; two fma: 2 u; the last product: 1 u.
/// Across, that is 4.74 u < 5 u. Its length is off by 4.5 u < 5 u: half of the dot product's 3 u, and 1 u each for
/// root, quotient and product.
Wrong compare(const std::vector<float>& dirs, const Scene& scene, const Tile& tile) {
    Wrong wrong;
    for (size_t ray = 0; ray < dirs.size() / 3; ++ray) {
        const Float3 f = unpacked(dirs, ray);
        const Pixel p = pixel_of(tile, ray);
        if (p.i >= scene.image.width || p.j >= scene.image.height) {
            wrong.outside += !(std::isnan(f.x) && std::isnan(f.y) && std::isnan(f.z));
            continue;
        }
        ++wrong.inside;
        const Vec3 dir = to_double(f), expected = reference::eye_ray(scene, p.i, p.j).dir;
        wrong.lengths += !(std::fabs(length(dir) - 1) <= 5 * u);
        wrong.directions += !(length(cross(dir, expected)) <= 5 * u && dot(dir, expected) > 0);
    }
    return wrong;
}

void check_right(Bench& bench, const Scene& scene, const Tile& tile, int inside) {
    INFO(scene.image.width << " x " << scene.image.height << ", fov " << scene.camera.fov);
    const Wrong wrong = compare(generate(bench, scene, tile), scene, tile);
    CHECK(wrong.inside == inside);
    CHECK(wrong.directions == 0);
    CHECK(wrong.lengths == 0);
    CHECK(wrong.outside == 0);
}

}  // namespace

TEST_CASE("generate_rays: random cameras look where the reference looks", "[generate_rays]") {
    on_every_bench([](Bench& bench) {
        Random random(1);
        for (const double fov : {1.0, 10.0, 60.0, 90.0, 120.0, 150.0})
            for (const ImageSize& size : {ImageSize{1, 1}, {7, 5}, {33, 17}, {64, 24}, {101, 3}}) {
                const Scene scene = random_camera(random, fov, size.width, size.height);
                check_right(bench, scene, whole(size), size.width * size.height);
            }
    });
}

TEST_CASE("generate_rays: tiles anywhere in the image, and over its edges", "[generate_rays]") {
    on_every_bench([](Bench& bench) {
        Random random(2);
        const Scene scene = random_camera(random, 75, 61, 43);
        check_right(bench, scene, {16, 8, 3, 6}, 24 * 16);
        check_right(bench, scene, {40, 32, 4, 8}, 21 * 11);
        check_right(bench, scene, {56, 0, 1, 6}, 5 * 43);
        check_right(bench, scene, {8, 40, 5, 5}, 40 * 3);
    });
}

TEST_CASE("generate_rays: the centre pixel of odd sides is the axis, and pixels mirror", "[generate_rays]") {
    on_every_bench([](Bench& bench) {
        for (const ImageSize& size : {ImageSize{1, 1}, {9, 7}, {65, 31}}) {
            const Scene scene = looking_ahead(size.width, size.height);
            const Tile tile = whole(size);
            const std::vector<float> dirs = generate(bench, scene, tile);
            const Float3 axis = at(dirs, tile, size.width / 2, size.height / 2);
            CHECK(axis.x == 0);
            CHECK(axis.y == 0);
            CHECK(axis.z == 1);
            int wrong = 0;
            for (int j = 0; j < size.height; ++j)
                for (int i = 0; i < size.width; ++i) {
                    const Float3 a = at(dirs, tile, i, j), b = at(dirs, tile, size.width - 1 - i, j),
                                 c = at(dirs, tile, i, size.height - 1 - j);
                    wrong += !(a.x == -b.x && a.y == b.y && a.z == b.z);
                    wrong += !(a.x == c.x && a.y == -c.y && a.z == c.z);
                    wrong += !(i <= size.width / 2 || a.x > 0) + !(j >= size.height / 2 || a.y > 0);  // right and up
                }
            CHECK(wrong == 0);
        }
    });
}
