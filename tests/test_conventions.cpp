// Which way is up, what counts as a hit: scenes whose pictures are known without a computer. The numbers are such that
// float arithmetic is exact, so most comparisons are for equality.
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// Distance, id and normal of one pixel.
void check_hit(const Film& film, size_t p, int id, float distance, Vec3 normal) {
    CHECK(film.id[p] == id);
    CHECK(film.distance[p] == distance);
    CHECK(film.normal[0][p] == static_cast<float>(normal.x));
    CHECK(film.normal[1][p] == static_cast<float>(normal.y));
    CHECK(film.normal[2][p] == static_cast<float>(normal.z));
}

void check_miss(const Film& film, size_t p) {
    check_hit(film, p, -1, INFINITY, {INFINITY, INFINITY, INFINITY});
    for (const auto& plane : film.radiance) CHECK(plane[p] == 0);
}

/// The scene that `looking_ahead` sees, turned: x, y and z become these vectors.
Vec3 turned(const Vec3& v, const Vec3& x, const Vec3& y, const Vec3& z) { return x * v.x + y * v.y + z * v.z; }

}  // namespace

TEST_CASE("the centre pixel of an odd image looks along the axis", "[conventions]") {
    on_every_device([](Renderer& renderer) {
        const Vec3 axes[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
        for (const Vec3& axis : axes) {
            Scene scene = looking_ahead(7, 5);
            scene.camera.eye = {3, -2, 5};
            scene.camera.at = scene.camera.eye + axis * 0.5;
            scene.camera.up = axis.y != 0 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
            scene.spheres = {{scene.camera.eye + axis * 10, 2, {1, 1, 1}}};
            const Film film = render(renderer, scene);
            check_hit(film, centre(film), 0, 8, axis * -1);
            check_miss(film, 0);
        }
    });
}

TEST_CASE("row 0 is up, and x_c = up x z_c points right", "[conventions]") {
    on_every_device([](Renderer& renderer) {
        const Vec3 bases[][3] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},    // right, up, ahead: up x ahead = right
                                 {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},   // lying on the left side
                                 {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}},  // the other way
                                 {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};  // looking up
        // The up vector need be neither upright nor a unit vector.
        for (const double tilt : {0.0, 1.0})
            for (const auto& basis : bases) {
                Scene scene = looking_ahead(4, 4);
                scene.camera.at = basis[2];
                scene.camera.up = basis[1] * 3 + basis[2] * tilt;
                // Pixel centres look along (+-1/4 or +-3/4, same, 1): each corner pixel at the centre of its sphere.
                const Vec3 corners[] = {{-7.5, 7.5, 10}, {7.5, 7.5, 10}, {-7.5, -7.5, 10}, {7.5, -7.5, 10}};
                for (const Vec3& corner : corners)
                    scene.spheres.push_back({turned(corner, basis[0], basis[1], basis[2]), 2, {1, 1, 1}});
                const Film film = render(renderer, scene);
                CHECK(film.id[pixel(film, 0, 0)] == 0);
                CHECK(film.id[pixel(film, 3, 0)] == 1);
                CHECK(film.id[pixel(film, 0, 3)] == 2);
                CHECK(film.id[pixel(film, 3, 3)] == 3);
                check_miss(film, pixel(film, 1, 1));
                check_miss(film, pixel(film, 2, 1));
            }
    });
}

TEST_CASE("fov is vertical and pixels are square", "[conventions]") {
    on_every_device([](Renderer& renderer) {
        Scene scene = looking_ahead(9, 3);  // 2/3 a pixel: columns look along x / z = -8/3 .. 8/3, rows 2/3, 0, -2/3
        scene.spheres = {{{8, 0, 3}, 0.5, {1, 1, 1}}, {{0, 2, 3}, 0.5, {1, 1, 1}}};
        const Film film = render(renderer, scene);
        for (size_t p = 0; p < film.pixels(); ++p)
            CHECK(film.id[p] == (p == pixel(film, 8, 1) ? 0 : p == pixel(film, 4, 0) ? 1 : -1));
        // |f| - r: 64 u relative where the ray meets the surface upright (see test_pictures.cpp).
        const double expected = std::sqrt(73.0) - 0.5;
        CHECK(std::fabs(film.distance[pixel(film, 8, 1)] - expected) <= 64 * u * expected);
    });
}

TEST_CASE("from inside a sphere the far root counts, and the normal points outward", "[conventions]") {
    on_every_device([](Renderer& renderer) {
        Scene scene = looking_ahead(9, 9);
        scene.spheres = {{{0, 0, 1}, 2, {1, 1, 1}}};
        Film film = render(renderer, scene);
        CHECK(std::count(film.id.begin(), film.id.end(), 0) == 81);
        check_hit(film, centre(film), 0, 3, {0, 0, 1});
        scene.spheres[0].center.z = -1;  // most of it behind the eye
        film = render(renderer, scene);
        check_hit(film, centre(film), 0, 1, {0, 0, 1});
        scene.spheres[0].center.z = 0;  // the eye in the centre
        film = render(renderer, scene);
        check_hit(film, centre(film), 0, 2, {0, 0, 1});
        scene.spheres[0].center.z = 2;  // the eye on the surface: t = 0 is no hit, the far side is one
        film = render(renderer, scene);
        check_hit(film, centre(film), 0, 4, {0, 0, 1});
        scene.spheres[0].center.z = -2;
        check_miss(render(renderer, scene), 40);
        scene.spheres[0].center.z = -3;  // all behind
        check_miss(render(renderer, scene), 40);
    });
}

TEST_CASE("a ray that touches a sphere hits it, one that just passes does not", "[conventions]") {
    on_every_device([](Renderer& renderer) {
        Scene scene = looking_ahead(1, 1);
        scene.spheres = {{{3, 0, 4}, 3, {1, 1, 1}}};  // looks small: 9 < (9 + 16) / 2
        check_hit(render(renderer, scene), 0, 0, 4, {-1, 0, 0});
        scene.spheres[0].radius = 3 - 0x1p-20;
        check_miss(render(renderer, scene), 0);
        scene.spheres = {{{0, -4, 3}, 4, {1, 1, 1}}};  // looks large: 16 > 12.5
        check_hit(render(renderer, scene), 0, 0, 3, {0, 1, 0});
        scene.spheres[0].radius = 4 - 0x1p-19;
        check_miss(render(renderer, scene), 0);
    });
}

TEST_CASE("of equal distances the lowest id counts", "[conventions]") {
    on_every_device([](Renderer& renderer) {
        const Sphere small{{0, 0, 10}, 2, {1, 1, 1}}, big{{0, 0, 12}, 4, {1, 1, 1}};  // both met at 8
        Scene scene = looking_ahead(3, 3);
        scene.spheres = {small, big};
        Film film = render(renderer, scene);
        check_hit(film, centre(film), 0, 8, {0, 0, -1});
        scene.spheres = {big, small};
        film = render(renderer, scene);
        check_hit(film, centre(film), 0, 8, {0, 0, -1});
    });
}

TEST_CASE("coincident spheres count as one, the lowest id stands for all", "[conventions]") {
    on_every_device([](Renderer& renderer) {
        Scene scene = looking_ahead(31, 31);
        scene.lights = {DirectionalLight{{1, 2, -3}, {2, 3, 4}}, PointLight{{3, 3, 4}, {500, 600, 700}}};
        scene.spheres = {{{0, 0, 10}, 2, {0.5, 0.25, 0.125}}, {{1, 0, 6}, 1, {1, 1, 1}}};
        const Film one = render(renderer, scene);
        scene.spheres.push_back({{-0.0, 0, 10}, 2, {1, 0, 1}});  // -0 and 0 are the same place
        scene.spheres.push_back({{1, 0, 6}, 1, {0, 1, 0}});
        CHECK(same_bits(render(renderer, scene), one));
        CHECK_FALSE(black(one));
    });
}
