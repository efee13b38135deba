// The pictures that are known: the two examples, pixel by pixel against the reference, and by their counts and sums.
#include <cmath>
#include <map>

#include "catch.h"
#include "reference.h"
#include "scenes.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

const double pi = std::acos(-1.0);

/// How far the float chain may be off, to first order in u.
struct Bounds {
    double distance, normal, radiance[3];
};

/// Of a ray that meets its sphere, of radius r and centre f from the eye, at distance t, with c = |n . dir|:
///
/// Ray. The basis is rounded once (u), fma rounds its two steps (2 u): the direction is off by 3 u across. Its length
/// is off by 4.5 u: half the dot product's 3 u, and square root, quotient and product 1 u each.
///
/// b = f . dir is off by 9.5 u |f|: f's rounding 1, the dot product 3, the direction's 3 and its length's 4.5, less
/// what the first two share. sqrt(D) = r c. |sqrt(D + e) - sqrt(D)| <= e / sqrt(D) for every e, also next to the limb.
///   Spheres apart, r^2 < 4/5 |f|^2, D = r^2 - |f - b dir|^2: the vector is off by 5 u |f|, so D by 10 u r |f| + 4 u
///   r^2 < 14 u r |f|, its root by 14 u |f| / c. t = C / (b + sqrt(D)), whose divisor is >= b >= sqrt(C) >= |f| /
///   sqrt(5): relative (9.5 + 14 / c) sqrt(5) u + 3 u < 56 u / c.
///   Others, |f| <= 1.12 r, D = b^2 - C: off by 19 u b |f| + 2 u b^2; the divisor b + sqrt(D) is >= r c and >= b:
///   relative (9.5 + 19 + 2) u |f| / (r c) + 3 u < 38 u / c.
/// Both are below 64 u / c.
///
/// Position p = t dir: off by that, by 3 u t across and u t for the product: < 68 u t / c. Normal (p - f) / |p - f|:
/// the position's error, f's u |f| <= u (t + r) and one rounding, seen across r, and 5 u for the normalisation:
/// < 72 u (t / (r c) + 1).
double distance_bound(double t, double c) { return 64 * u * t / c; }
double normal_bound(double t, double c, double r) { return 72 * u * (t / (r * c) + 1); }

/// The geometry of a light's term: n . l, or n . l / d^2. Off by the normal's error and, relative to its greatest value
/// for the light's place, by < 32 u: n's length 5, l 1, dot products 3 + 3, quotients and root 4.5, factors 4 (albedo
/// and phi rounded, two products), a sum over at most 4 lights 4, the rounding of the way 4. A point light adds the
/// position's error: the derivative of (n . w) / |w|^3 by w is at most 2 / |w|^3 long. That the light's place itself is
/// rounded (u |o| <= u (t + d)) is in 70 instead of 68 and in 32.
double geometry_bound(const reference::Hit& hit, const Light& light, double c, double normal) {
    const auto* point = std::get_if<PointLight>(&light);
    if (!point) return normal + 32 * u;
    const double d = length(point->position - hit.position);
    return (normal + 32 * u + 2 * 70 * u * hit.t / c / d) / (d * d);
}

Rgb factor_of(const Light& light) {
    const auto* point = std::get_if<PointLight>(&light);
    const Rgb phi = point ? point->power : std::get<DirectionalLight>(light).irradiance;
    const double scale = point ? 1 / (4 * pi * pi) : 1 / pi;
    return {phi.r * scale, phi.g * scale, phi.b * scale};
}

Bounds bounds(const Scene& scene, const reference::Ray& ray, const reference::Hit& hit) {
    const Sphere& sphere = scene.spheres[static_cast<size_t>(hit.id)];
    const double c = std::fabs(dot(hit.normal, ray.dir));
    Bounds result{distance_bound(hit.t, c), normal_bound(hit.t, c, sphere.radius), {0, 0, 0}};
    for (const Light& light : scene.lights) {
        const double geometry = geometry_bound(hit, light, c, result.normal);
        const Rgb phi = factor_of(light);
        result.radiance[0] += sphere.albedo.r * phi.r * geometry;
        result.radiance[1] += sphere.albedo.g * phi.g * geometry;
        result.radiance[2] += sphere.albedo.b * phi.b * geometry;
    }
    return result;
}

/// Pixels of a film that are not what the reference says.
struct Wrong {
    int64_t ids = 0, misses = 0, distances = 0, normals = 0, lengths = 0, flips = 0;
    double sums[3] = {0, 0, 0};  ///< the reference's radiance, over the image
};

bool is_miss(const Film& film, size_t p) {
    bool miss = film.id[p] == -1 && film.distance[p] == INFINITY;
    for (int c = 0; c < 3; ++c) miss = miss && film.normal[c][p] == INFINITY && film.radiance[c][p] == 0;
    return miss;
}

// The comparisons are the negated ones so that a NaN counts as wrong.
void compare(const Film& film, size_t p, const Bounds& bound, const reference::Hit& hit, const Rgb& radiance,
             Wrong& wrong) {
    const Vec3 n{film.normal[0][p], film.normal[1][p], film.normal[2][p]};
    wrong.distances += !(std::fabs(film.distance[p] - hit.t) <= bound.distance);
    wrong.lengths += !(std::fabs(length(n) - 1) <= 5 * u);  // 4.5 u, as the ray's direction above
    wrong.normals += !(length(cross(n, hit.normal)) <= bound.normal && dot(n, hit.normal) > 0);
    const double expected[] = {radiance.r, radiance.g, radiance.b};
    bool flipped = false;
    for (int c = 0; c < 3; ++c) {
        wrong.sums[c] += expected[c];
        flipped = flipped || !(std::fabs(film.radiance[c][p] - expected[c]) <= bound.radiance[c]);
    }
    wrong.flips += flipped;
}

Wrong compare(const Film& film, const Scene& scene, bool shadows) {
    Wrong wrong;
    for (int j = 0; j < film.height; ++j)
        for (int i = 0; i < film.width; ++i) {
            const size_t p = pixel(film, i, j);
            const reference::Ray ray = reference::eye_ray(scene, i, j);
            const reference::Hit hit = reference::closest_hit(scene, ray);
            wrong.ids += film.id[p] != hit.id;
            if (hit.id < 0)
                wrong.misses += !is_miss(film, p);
            else
                compare(film, p, bounds(scene, ray, hit), hit, reference::radiance(scene, hit, shadows), wrong);
        }
    return wrong;
}

void check_right(const Film& film, const Scene& scene, bool shadows) {
    const Wrong wrong = compare(film, scene, shadows);
    CHECK(wrong.ids == 0);
    CHECK(wrong.misses == 0);
    CHECK(wrong.distances == 0);
    CHECK(wrong.lengths == 0);
    CHECK(wrong.normals == 0);
    CHECK(wrong.flips == 0);
    for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (const float v : film.radiance[c]) sum += static_cast<double>(v);
        // What all pixels share (pixel pitch, albedo, phi and l rounded, product and sum biased) is below 8 u < 5e-7;
        // their own roundings have both signs and cancel. One flipped pixel is about 1, and 1e-6 of a sum 0.1 to 0.2.
        CHECK(std::fabs(sum - wrong.sums[c]) <= 1e-6 * wrong.sums[c]);
    }
}

void check_counts(const Film& film, const RenderStats& stats) {
    std::map<int, int> pixels;
    for (const int id : film.id) ++pixels[id];
    CHECK(pixels == std::map<int, int>{{-1, 507846}, {0, 17545}, {1, 17479}, {2, 243562}});
    CHECK(stats.pixels == 1024 * 768);
    CHECK(stats.hits == 17545 + 17479 + 243562);
}

void check_sums(const Film& film, const double (&expected)[3]) {
    for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (const float v : film.radiance[c]) sum += static_cast<double>(v);
        CHECK(std::fabs(sum - expected[c]) <= 1e-6 * expected[c]);  // as in check_right
    }
}

}  // namespace

TEST_CASE("directional.json gives the known picture", "[pictures]") {
    on_every_device([](Renderer& renderer) {
        const Scene scene = example("directional.json");
        RenderOptions options = all_outputs();
        Film film;
        const RenderStats shadowed = renderer.render(scene, options, film);
        check_counts(film, shadowed);
        check_right(film, scene, true);
        check_sums(film, {182321.5727, 184275.2414, 106108.0149});
        options.shadows = false;
        const RenderStats open = renderer.render(scene, options, film);
        check_counts(film, open);
        check_right(film, scene, false);
        check_sums(film, {192458.5647, 194439.4706, 111198.3865});
    });
}

TEST_CASE("point.json gives the known picture", "[pictures]") {
    on_every_device([](Renderer& renderer) {
        const Scene scene = example("point.json");
        for (const bool shadows : {true, false}) {
            RenderOptions options = all_outputs();
            options.shadows = shadows;
            Film film;
            const RenderStats stats = renderer.render(scene, options, film);
            check_counts(film, stats);
            check_right(film, scene, shadows);
            CHECK(stats.rays == stats.pixels + (shadows ? 4 * stats.hits : 0));
        }
    });
}

TEST_CASE("spheres that overlap and coincide, lights of both kinds, odd sides: as the reference says", "[pictures]") {
    on_every_device([](Renderer& renderer) {
        const Scene scene = mixed(201, 131);
        check_right(render(renderer, scene), scene, true);
    });
}

TEST_CASE("few spheres and many: as the reference says", "[pictures]") {
    on_every_device([](Renderer& renderer) {
        for (const int count : {1, 2, 15, 16, 17, 33, 300}) {
            INFO(count << " spheres");
            const Scene scene = scattered(count, 90, 70);
            check_right(render(renderer, scene), scene, true);
        }
    });
}
