// The oracle against what is known without it: triangles of whole numbers, lines that touch, and the reference on
// scenes where double is enough.
#include <algorithm>
#include <cmath>

#include "catch.h"
#include "oracle.h"
#include "reference.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;
using oracle::Hit;
using oracle::Oracle;
using oracle::Pixel;

namespace {

// What oracle.h promises, 2^-52, and as much for the expected value's own roundings.
constexpr double exactly = 0x1p-51;

void check_vector(const Vec3& v, const Vec3& expected) { CHECK(length(v - expected) <= exactly * 2); }
void check_hit(const Hit& hit, double t, const Vec3& normal) {
    REQUIRE(hit);
    CHECK(std::fabs(hit.t - t) <= exactly * t);
    check_vector(hit.normal, normal);
}

/// The reference's own error, with u = 2^-53, c = |n . dir| and |f| <= t + r: half of b is off by 5 u |f| (its dot
/// product, f, dir), D / 4 by no more than 16 u |f|^2, its root by that / (2 r c), so t by less than 16 u (t + r)^2 /
/// (r c); the normal by that / r and, what p, f and the quotient add, 8 u (t + r) / r; the radiance relative to its
/// greatest value by the normal's error and as much of the place's relative to the light's distance, here > r.
void check_as_reference(const Scene& scene, const Pixel& pixel, const reference::Ray& ray, const reference::Hit& hit) {
    const double r = sphere_of(scene, hit.id).radius, reach = hit.t + r, cosine = std::fabs(dot(hit.normal, ray.dir));
    const double t_error = 16 * 0x1p-53 * reach * reach / (r * cosine), n_error = t_error / r + 8 * 0x1p-53 * reach / r;
    CHECK(std::fabs(pixel.hit.t - hit.t) <= t_error);
    CHECK(length(pixel.hit.normal - hit.normal) <= n_error);
    for (size_t i = 0; i < scene.lights.size(); ++i) {
        const bool lit =
            reference::cosine(hit, scene.lights[i]) > 0 && !reference::in_between(scene, hit, scene.lights[i]);
        CHECK(pixel.lit[i] == lit);
        const double term = reference::lambert(scene, hit, scene.lights[i]).g;
        if (lit)
            CHECK(std::fabs(pixel.reflected[i].g - term) <=
                  4 * n_error / reference::cosine(hit, scene.lights[i]) * term);
    }
}

/// A grazing ray along x, at height `radius` over the centre of a sphere, and how its line lies to spheres of nearly
/// that radius.
int side(double radius, double change) {
    return oracle::position({{-7, radius, 0}, {3, 0, 0}}, {{5, 0, 0}, change}).discriminant;
}

}  // namespace

TEST_CASE("oracle: whole numbers", "[oracle]") {
    check_hit(oracle::meet({{0, 0, 0}, {0, 0, 7}}, {{0, 0, 10}, 2}), 8, {0, 0, -1});
    // Sides 3, 4, 5: the line passes the centre at 3, and its roots are 4 before and behind the foot, at 12.
    check_hit(oracle::meet({{0, 0, 0}, {0, 0, 1}}, {{3, 0, 12}, 5}), 8, {-0.6, 0, -0.8});
    check_hit(oracle::meet({{0, 0, 0}, {2, 3, 6}}, {{4, 6, 12}, 7}), 7, {-2. / 7, -3. / 7, -6. / 7});
    check_hit(oracle::meet({{3, 0, 12}, {0, 1, 0}}, {{0, 0, 12}, 5}), 4, {0.6, 0.8, 0});  // from inside
    CHECK_FALSE(oracle::meet({{0, 0, 0}, {0, 0, -1}}, {{3, 0, 12}, 5}));                  // behind
    CHECK_FALSE(oracle::meet({{0, 0, 0}, {0, 0, 1}}, {{6, 0, 12}, 5}));                   // beside
}

TEST_CASE("oracle: on the surface the far side is seen, or nothing", "[oracle]") {
    const Sphere sphere{{0, 3, 4}, 5};
    check_hit(oracle::meet({{0, 0, 0}, {0, 0, 1}}, sphere), 8, {0, -0.6, 0.8});
    check_hit(oracle::meet({{0, 0, 0}, {0, 1, 0}}, sphere), 6, {0, 0.6, -0.8});
    CHECK_FALSE(oracle::meet({{0, 0, 0}, {0, 0, -1}}, sphere));
    CHECK_FALSE(oracle::meet({{0, 0, 0}, {0, 4, -3}}, sphere));  // along the surface: touches at t = 0
    CHECK(oracle::position({{0, 0, 0}, {0, 0, 1}}, sphere).power == 0);
    const double step = 0x1p-1074;  // the smallest double
    CHECK(oracle::position({{0, 0, -step}, {0, 0, 1}}, sphere).power == 1);
    CHECK(oracle::position({{0, 0, step}, {0, 0, 1}}, sphere).power == -1);
    check_hit(oracle::meet({{0, 0, -step}, {0, 0, 1}}, sphere), step * 1, {0, -0.6, -0.8});
}

TEST_CASE("oracle: lines that touch, and those that nearly do", "[oracle]") {
    check_hit(oracle::meet({{0, 0, 0}, {0, 0, 1}}, {{3, 0, 4}, 3}), 4, {-1, 0, 0});
    // (2, 3, 6) has length 7, and (6, 2, -3), as long, is across: twice the one and thrice the other.
    check_hit(oracle::meet({{1, 1, 1}, {2, 3, 6}}, {{1 + 4 + 18, 1 + 6 + 6, 1 + 12 - 9}, 21}), 14,
              {-6. / 7, -2. / 7, 3. / 7});
    for (const double radius : {1.0, 3.0, 1e7, 1e-300}) {
        CHECK(side(radius, radius) == 0);
        for (const double change : {0x1p-52, 1e-15, 1e-12, 1e-7}) {
            CHECK(side(radius, radius * (1 + change)) == 1);
            CHECK(side(radius, radius * (1 - change)) == -1);
        }
    }
    // Lengths that are irrational: the line along (1, 1, 1) passes the origin at a distance of sqrt(2), which no double
    // is; that along (-1, 0, 1) touches a sphere of radius 3 at the middle of two whole points.
    const double above = std::sqrt(2.0);  // rounded up
    CHECK(oracle::position({{1, 0, -1}, {1, 1, 1}}, {{0, 0, 0}, above}).discriminant == 1);
    CHECK(oracle::position({{1, 0, -1}, {1, 1, 1}}, {{0, 0, 0}, std::nextafter(above, 0)}).discriminant == -1);
    CHECK(oracle::position({{2, 2, -1}, {-1, 0, 1}}, {{0.5 + 2, 2 + 1, 0.5 + 2}, 3}).discriminant == 0);
}

TEST_CASE("oracle: condition numbers", "[oracle]") {
    // (r + |f| + t sin) / (t cos)
    CHECK(oracle::meet({{0, 0, 0}, {0, 0, 7}}, {{0, 0, 10}, 2}).condition == Approx((2 + 10) / 8.0));
    CHECK(oracle::meet({{0, 0, 0}, {0, 0, 1}}, {{3, 0, 12}, 5}).condition ==
          Approx((5 + std::sqrt(153.0) + 8 * 0.6) / (8 * 0.8)));
    CHECK(std::isinf(oracle::meet({{0, 0, 0}, {0, 0, 1}}, {{3, 0, 4}, 3}).condition));
}

TEST_CASE("oracle: equal distances, coincident spheres", "[oracle]") {
    Scene scene = looking_ahead(3, 3);
    scene.spheres = {{{0, 0, 11}, 1}, {{0, 0, 12}, 4}, {{0, 0, 10}, 2}, {{0, 0, 10}, 2}};
    CHECK(Oracle(scene).look(1, 1).hit.id == 1);
    CHECK(Oracle(scene).look({{0, 0, 0}, {1e-9, 0, 1}}).hit.id == 1);
    scene.spheres[1].radius = std::nextafter(4.0, 0);
    CHECK(Oracle(scene).look(1, 1).hit.id == 2);
    // All met at (6, 6, 6), at an irrational distance whose intervals differ in their ends.
    const auto beyond = [](Vec3 way, double times) { return Sphere{Vec3{6, 6, 6} + way * times, 7 * times}; };
    scene.spheres = {beyond({2, 3, 6}, 1), beyond({6, 3, 2}, 3), beyond({3, 6, 2}, 0.1875), beyond({3, 2, 6}, 11)};
    for (size_t i = 0; i < scene.spheres.size(); ++i) {
        std::rotate(scene.spheres.begin(), scene.spheres.begin() + 1, scene.spheres.end());
        CHECK(Oracle(scene).look({{0, 0, 0}, {1, 1, 1}}).hit.id == 0);
    }
}

TEST_CASE("oracle: a light at, in, on and behind things", "[oracle]") {
    Scene scene = looking_ahead(9, 9);
    scene.spheres = {{{0, 0, 10}, 2, {0.5, 0.25, 0.125}}};
    const auto lit = [&](const Light& light) {
        scene.lights = {light};
        const Pixel pixel = Oracle(scene).look(4, 4);
        CHECK(pixel.lit[0] == (pixel.radiance.r > 0));
        return static_cast<bool>(pixel.lit[0]);
    };
    const auto lamp = [](double x, double y, double z) { return PointLight{{x, y, z}, {1, 1, 1}}; };
    CHECK_FALSE(lit(lamp(0, 0, 8)));                            // at distance 0
    CHECK_FALSE(lit(lamp(0, 0, 9)));                            // inside
    CHECK_FALSE(lit(lamp(4, 0, 8)));                            // n . l = 0
    CHECK_FALSE(lit(DirectionalLight{{-3, 5, 0}, {1, 1, 1}}));  // n . l = 0
    CHECK(lit(lamp(4, 0, 8 - 0x1p-50)));
    CHECK(lit(DirectionalLight{{-3, 5, -1e-300}, {1, 1, 1}}));
    scene.spheres.push_back({{0, 4, 4}, 1});  // between (0, 0, 8) and the line's point (0, 8, 0)
    CHECK_FALSE(lit(lamp(0, 8, 0)));
    CHECK_FALSE(lit(lamp(0, 4, 4)));
    CHECK(lit(lamp(0, 2, 6)));
    scene.spheres[1] = {{0, 8, 1}, 5};    // the way enters it at (0, 4, 4)
    CHECK(lit(lamp(0, 4, 4)));            // on its surface, outside
    CHECK_FALSE(lit(lamp(0, 4.5, 3.5)));  // just inside
    scene.spheres[1] = {{0, 0, 3}, 5};    // the receiver lies on it too, and the way leads inward
    CHECK_FALSE(lit(lamp(0, 6, -3)));
    scene.spheres[1] = {{5, 4, 4}, 5};  // its disc is touched by the way: (0, 1, -1) is across (1, 0, 0)
    CHECK_FALSE(lit(lamp(0, 8, 0)));
    CHECK_FALSE(lit(DirectionalLight{{0, 1, -1}, {1, 1, 1}}));
    CHECK(lit(lamp(0, 4, 4)));  // where it is touched: not before the light
    scene.spheres[1].radius = std::nextafter(5, 0);
    CHECK(lit(lamp(0, 8, 0)));
    CHECK(lit(DirectionalLight{{0, 1, -1}, {1, 1, 1}}));
}

TEST_CASE("oracle: radiance", "[oracle]") {
    const double pi = std::acos(-1.0);
    Scene scene = looking_ahead(1, 1);
    scene.spheres = {{{0, 0, 10}, 2, {0.5, 0.25, 0.125}}};
    scene.lights = {DirectionalLight{{0, 4, -3}, {2, 3, 4}}, PointLight{{3, 0, 4}, {100, 200, 300}}};
    const Pixel pixel = Oracle(scene).look(0, 0);
    CHECK(pixel.reflected[0].r == Approx(0.5 * 2 * 0.6 / pi).epsilon(4 * exactly));
    CHECK(pixel.reflected[1].b == Approx(0.125 * 300 * 0.8 / (4 * pi * pi * 25)).epsilon(4 * exactly));
    CHECK(pixel.radiance.g == Approx(pixel.reflected[0].g + pixel.reflected[1].g).epsilon(exactly));
}

TEST_CASE("oracle: ordinary scenes are as the reference sees them", "[oracle]") {
    for (const Scene& scene : {mixed(31, 23), scattered(300, 24, 20)}) {
        const Oracle oracle(scene);
        int hits = 0;
        for (int j = 0; j < scene.image.height; ++j)
            for (int i = 0; i < scene.image.width; ++i) {
                const auto ray = reference::eye_ray(scene, i, j);
                const auto hit = reference::closest_hit(scene, ray);
                const Pixel pixel = oracle.look(i, j);
                REQUIRE(pixel.hit.id == hit.id);
                if (hit.id >= 0) check_as_reference(scene, pixel, ray, hit);
                hits += hit.id >= 0;
            }
        CHECK(hits > 100);
    }
}

TEST_CASE("oracle: an eye at whole numbers of nineteen digits", "[oracle]") {
    Scene scene = looking_ahead(1, 1);
    scene.camera.eye = {0, 0, 2529175010755087872};
    scene.camera.at = {0, 0, 2e19};
    scene.spheres = {{{0, 0, 2e19}, 1e18}};
    CHECK(Oracle(scene).look(0, 0).hit.id == 0);
}

TEST_CASE("oracle: ten thousand spheres", "[oracle]") {
    const Scene scene = scattered(10000, 24, 20);
    const Oracle oracle(scene);
    for (int j = 0; j < 20; j += 4)
        for (int i = 0; i < 24; i += 4) {
            const auto ray = reference::eye_ray(scene, i, j);
            CHECK(oracle.look(i, j).hit.id == reference::closest_hit(scene, ray).id);
            CHECK(oracle.look({ray.origin, ray.dir}).hit.id == oracle.look(i, j).hit.id);
        }
}
