// intersect_closest alone, on random scenes and directions, against the reference in double.
#include "intersect_harness.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

struct Wrong {
    int64_t hits = 0, undecided = 0;  ///< undecided: the reference's sphere is another, and rounding may say so
    int64_t ids = 0, misses = 0, distances = 0, normals = 0, lengths = 0;
};

/// Whether some order of what lies within the bounds makes sphere `id` at distance t the first (-1: nothing is hit).
bool may_be(const std::vector<Sphere>& spheres, const Vec3& d, int id, double t) {
    for (size_t i = 0; i < spheres.size(); ++i) {
        const Sphere& s = spheres[i];
        const reference::Roots roots = reference::intersect({{}, d}, s);
        const Doubt e = doubt(s.center, s.radius, d);
        const double discriminant = roots.discriminant / 4;  // of t^2 - 2 b t + C
        const double middle = dot(s.center, d);
        const double first = !roots.real ? middle : roots.near > 0 ? roots.near : roots.far;
        if (static_cast<int>(i) == id) {
            if (!(discriminant >= -e.d_error && first > -e.t_error && std::fabs(first - t) <= e.t_error)) return false;
        } else if (discriminant > e.d_error && first > e.t_error && first + e.t_error < t) {
            return false;
        }
    }
    return true;
}

/// The position is off along the line by t's error and u t (the length of dir), and rounded: u r. Seen from the centre,
/// from which the line stays m or more away, that is an angle of at most the first over max(m, r - it), and 2 u for the
/// rounding and the last product's. The length: 4.5 u < 5 u, as in the test of generate_rays.
void compare_hit(const Sphere& s, const Vec3& d, const reference::Hit& hit, double t, const Vec3& n, Wrong& wrong) {
    const Doubt e = doubt(s.center, s.radius, d);
    const double along = e.t_error + 1.01 * u * hit.t, m = length(cross(s.center, d));
    wrong.distances += !(std::fabs(t - hit.t) <= e.t_error);
    wrong.lengths += !(std::fabs(length(n) - 1) <= 5 * u);
    wrong.normals += !(length(cross(n, hit.normal)) <= along / std::max(m, s.radius - along) + 2.02 * u &&
                       (dot(n, hit.normal) > 0 || along > s.radius / 2));
}

void compare(const Hits& hits, const Scene& scene, const std::vector<Float3>& dirs, Wrong& wrong) {
    for (size_t ray = 0; ray < dirs.size(); ++ray) {
        const Vec3 d = normalize(to_double(dirs[ray]));
        const reference::Hit hit = reference::closest_hit(scene, {{}, d});
        const double t = static_cast<double>(hits.ts[ray]);
        const int id = hits.ids[ray];
        wrong.hits += id >= 0;
        if (id < 0) wrong.misses += !is_miss(hits, ray);
        if (id != hit.id) {
            ++wrong.undecided;
            wrong.ids += !may_be(scene.spheres, d, id, t);
        } else if (id >= 0) {
            compare_hit(scene.spheres[static_cast<size_t>(id)], d, hit, t, to_double(unpacked(hits.normals, ray)),
                        wrong);
        }
    }
}

/// Blocks of rays: through a cone about one axis, of half angles from 1e-4 to all around.
std::vector<Float3> random_rays(Random& random, const Scene& scene, int blocks) {
    std::vector<Float3> dirs;
    for (int block = 0; block < blocks; ++block) {
        const Sphere& aim = scene.spheres[random.word() % scene.spheres.size()];
        const Vec3 at = aim.center + random.direction() * aim.radius;
        const Vec3 axis = block % 3 ? normalize(at) : random.direction();
        const double spread = random.scale(1e-4, 10);
        for (int i = 0; i < BLOCK_RAYS; ++i) {
            const Vec3 d = axis + random.direction() * spread;
            dirs.push_back(to_float(normalize(d)));
        }
    }
    return dirs;
}

/// As the kernel has it: a centre that is a float. The radius stays what it is.
Sphere placed(const Vec3& center, double radius) { return {to_double(to_float(center)), radius}; }

enum class Kind { strewn, clustered, nested, around };

Scene random_scene(Random& random, Kind kind, int count) {
    Scene scene;
    const Vec3 middle = random.direction() * random.scale(1, 100);
    for (int i = 0; i < count; ++i) {
        const double r = random.scale(1e-3, 3);
        switch (kind) {
            case Kind::strewn:  // over all directions, and four orders of magnitude of distance
                scene.spheres.push_back(placed(random.direction() * random.scale(1, 1e4), r));
                break;
            case Kind::clustered:  // overlapping, beside each other
                scene.spheres.push_back(placed(middle + random.direction() * random.uniform(0, 2), r / 3));
                break;
            case Kind::nested:  // one inside the other, the eye inside the larger ones
                scene.spheres.push_back(placed(middle + random.direction() * 0.01, random.scale(0.1, 300)));
                break;
            case Kind::around:  // large ones whose surface is near the eye
                scene.spheres.push_back(placed(random.direction() * (r * 1000 + random.uniform(-2, 5)), r * 1000));
                break;
        }
    }
    return scene;
}

void check_random(Bench& bench, Kind kind, uint64_t seed) {
    Random random(seed);
    Wrong wrong;
    int64_t rays = 0;
    for (const int count : {1, 5, 16, 17, 100, 1000}) {
        INFO(count << " spheres");
        const Scene scene = random_scene(random, kind, count);
        const std::vector<Float3> dirs = random_rays(random, scene, count < 1000 ? 48 : 16);
        compare(closest(bench, scene, dirs), scene, dirs, wrong);
        rays += static_cast<int64_t>(dirs.size());
    }
    CHECK(wrong.hits > rays / 10);  // else the test says little
    CHECK(wrong.undecided * 1000 < rays);
    CHECK(wrong.ids == 0);
    CHECK(wrong.misses == 0);
    CHECK(wrong.distances == 0);
    CHECK(wrong.normals == 0);
    CHECK(wrong.lengths == 0);
}

}  // namespace

TEST_CASE("intersect_closest: spheres strewn all around", "[intersect_closest]") {
    on_every_bench([](Bench& bench) { check_random(bench, Kind::strewn, 11); });
}
TEST_CASE("intersect_closest: spheres that overlap", "[intersect_closest]") {
    on_every_bench([](Bench& bench) { check_random(bench, Kind::clustered, 12); });
}
TEST_CASE("intersect_closest: spheres in spheres, some around the eye", "[intersect_closest]") {
    on_every_bench([](Bench& bench) { check_random(bench, Kind::nested, 13); });
}
TEST_CASE("intersect_closest: large spheres close to the eye", "[intersect_closest]") {
    on_every_bench([](Bench& bench) { check_random(bench, Kind::around, 14); });
}
