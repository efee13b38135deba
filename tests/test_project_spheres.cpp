// What a pencil sees of the spheres (project_spheres), and bounds over it (bound_clusters, bound_nodes).
#include "crowds.h"
#include "guarded_spheres.h"
#include "hierarchy.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

using Long = long double;  // 64 bits of mantissa: the reference is rounded far below float's and twice float's last bit

struct Expected {
    Long x, y, z, power, r2, distance;
};

/// A sphere as an apex sees it. What is lost when its numbers become two floats is not counted: 2^-48 of the way from
/// the frame's origin.
Expected expected(const Vec3& center, double radius, const Vec3& apex, const ParallelPencil* parallel) {
    const Long f[] = {Long{center.x} - apex.x, Long{center.y} - apex.y, Long{center.z} - apex.z};
    const Long f2 = f[0] * f[0] + f[1] * f[1] + f[2] * f[2], r2 = Long{radius} * radius;
    const auto along = [&](const Float3& a) { return a.x * f[0] + a.y * f[1] + a.z * f[2]; };
    Expected e{f[0], f[1], f[2], f2 - r2, r2, std::sqrt(f2)};
    if (parallel) {
        e.x = along(parallel->u);
        e.y = along(parallel->v);
        e.z = along(parallel->axis);
    }
    return e;
}

void check_near(float value, Long truth, Long slack) {
    // A rounding to float, and what the two floats lose.
    CHECK(std::fabs(Long{value} - truth) <= Long{u} * std::fabs(truth) * 1.0001L + slack);
}

/// All of a scene as one view sees it. Twice float's precision: 2^-44 (16 times 2^-48, some dozen roundings) of the
/// largest term.
void check_seen(Bench& bench, const Scene& scene, const PencilView& view, const Vec3& apex) {
    DeviceSpheres spheres(bench, scene);
    int seen = 0;
    const auto from_origin = [&](const Vec3& p) { return length(p - spheres.frame.origin); };
    for (const PencilCluster& c : spheres.seen(view).clusters)
        for (int i = 0; i < CLUSTER; ++i) {
            if (c.id[i] < 0) {
                CHECK(c.reach[i] == -INFINITY);
                CHECK(c.r2[i] == -INFINITY);
                CHECK(c.power[i] == INFINITY);
                continue;
            }
            const Sphere& s = scene.spheres[static_cast<size_t>(c.id[i])];
            INFO("sphere " << c.id[i] << ", radius " << s.radius);
            const Expected e = expected(s.center, s.radius, apex,
                                        std::get_if<ParallelPencil>(view.is_parallel ? &view.parallel : nullptr));
            const Long lost = 0x1p-47L * (from_origin(s.center) + from_origin(apex) + s.radius);
            check_near(c.x[i], e.x, lost);
            check_near(c.y[i], e.y, lost);
            check_near(c.z[i], e.z, lost);
            check_near(c.r2[i], e.r2, Long{u} * 0.51L * e.r2 + 0x1p-47L * s.radius * s.radius);
            check_near(c.power[i], e.power,
                       2 * lost * (e.distance + s.radius) + 0x1p-44L * (e.distance * e.distance + e.r2));
            const Long wide = s.radius + 0x1p-17L * std::max<Long>(e.distance, s.radius);
            CHECK(std::fabs(Long{c.reach[i]} - wide) <= 4 * Long{u} * wide);
            ++seen;
        }
    CHECK(seen > 0);
}

/// Whether child i of a node holds a rectangle and a depth, as an apex or a parallel pencil sees them.
bool holds(const Node& n, int i, const Node& inner, int k, bool is_parallel) {
    return n.x0[i] <= inner.x0[k] && n.x1[i] >= inner.x1[k] && n.y0[i] <= inner.y0[k] && n.y1[i] >= inner.y1[k] &&
           (is_parallel ? n.depth[i] >= inner.depth[k] : n.depth[i] <= inner.depth[k]);
}

void check_nodes(const PencilSpheres& spheres, const HierarchyShape& shape, int faces, bool is_parallel) {
    REQUIRE(spheres.nodes.size() == static_cast<size_t>(faces * shape.all_nodes()));
    for (int face = 0; face < faces; ++face) {
        const Node* nodes = spheres.nodes.data() + face * shape.all_nodes();
        std::vector<int> clusters(static_cast<size_t>(shape.clusters)),
            children(static_cast<size_t>(shape.all_nodes()));
        bool sorted = true, held = true;
        for (int n = 0; n < shape.all_nodes(); ++n)
            for (int i = 0; i < CLUSTER; ++i) {
                const int child = nodes[n].child[i];
                if (child < 0) continue;
                if (i > 0 && nodes[n].child[i - 1] >= 0) sorted = sorted && nodes[n].depth[i - 1] <= nodes[n].depth[i];
                if (n < shape.nodes[0]) {
                    ++clusters[static_cast<size_t>(child)];
                    continue;
                }
                ++children[static_cast<size_t>(child)];
                for (int k = 0; k < CLUSTER; ++k)
                    held = held && (nodes[child].child[k] < 0 || holds(nodes[n], i, nodes[child], k, is_parallel));
            }
        CHECK(sorted);
        CHECK(held);
        CHECK(std::all_of(clusters.begin(), clusters.end(), [](int times) { return times == 1; }));
        children.pop_back();  // the root is nobody's child
        CHECK(std::all_of(children.begin(), children.end(), [](int times) { return times == 1; }));
    }
}

const Vec3 eyes[] = {{0, 0, 0}, {100, -20, 30}, {0, 0, 100}, {1e-3, -40.0001, 100}};

}  // namespace

TEST_CASE("project_spheres: what an apex sees, against long double", "[project]") {
    on_every_bench([](Bench& bench) {
        for (const Crowd crowd : crowds)
            for (const Vec3& eye : eyes) {
                INFO(to_string(crowd));
                Scene scene = scene_of(crowd, 300);
                scene.camera = {eye, eye + Vec3{0, 0, 1}, {0, 1, 0}, 40};
                check_seen(bench, scene, view_of_eye(scene.camera, choose_frame(scene, survey(scene))), eye);
            }
    });
}

TEST_CASE("project_spheres: what a parallel pencil sees, against long double", "[project]") {
    on_every_bench([](Bench& bench) {
        for (const Crowd crowd : crowds)
            for (const Vec3& eye : eyes) {
                INFO(to_string(crowd));
                Scene scene = scene_of(crowd, 300);
                scene.camera = {eye, eye + Vec3{0, 0, 1}, {0, 1, 0}, 40};
                const ParallelPencil pencil = parallel_pencil({{1, 2, -1.5}, {1, 1, 1}});
                const Frame frame = choose_frame(scene, survey(scene));
                check_seen(bench, scene, view_of(pencil, scene.camera, frame), eye);
            }
    });
}

TEST_CASE("project_spheres: floats far from the origin are seen as if it were near", "[project]") {
    on_every_bench([](Bench& bench) {
        // Exact floats, so no frame of their own: the difference to the eye must lose nothing.
        Scene scene;
        for (int i = 0; i < 300; ++i) scene.spheres.push_back({{1e6 + i, 2e6 - i, 0.5 * i}, 0.25});
        REQUIRE(choose_frame(scene, survey(scene)).is_scene());
        const Vec3 eye{1e6 + 0.1, 2e6 - 0.1, 1e-7};
        scene.camera = {eye, eye + Vec3{0, 0, 1}, {0, 1, 0}, 40};
        DeviceSpheres spheres(bench, scene);
        const PencilSpheres seen = spheres.seen(view_of_eye(scene.camera, spheres.frame));
        for (const PencilCluster& c : seen.clusters)
            for (int i = 0; i < CLUSTER; ++i) {
                if (c.id[i] < 0) continue;
                const Sphere& s = scene.spheres[static_cast<size_t>(c.id[i])];
                // The eye as two floats is off by 2^-48 of itself.
                check_near(c.x[i], Long{s.center.x} - eye.x, 0x1p-48L * 1e6L);
                check_near(c.y[i], Long{s.center.y} - eye.y, 0x1p-48L * 2e6L);
            }
    });
}

TEST_CASE("nodes: each child once, in order, in bounds that hold it", "[project]") {
    on_every_bench([](Bench& bench) {
        for (const Crowd crowd : crowds) {
            INFO(to_string(crowd));
            const Scene scene = scene_of(crowd, 5000);
            DeviceSpheres spheres(bench, scene);
            const HierarchyShape& shape = spheres.buffers.shape;
            const auto check = [&](const PencilView& view) {
                check_nodes(spheres.seen(view), shape, static_cast<int>(view.faces.size()), view.is_parallel);
            };
            check(view_of_eye(scene.camera, spheres.frame));
            check(view_of(parallel_pencil({{1, 2, -1}, {}}), scene.camera, spheres.frame));
            for (const Vec3& at : {Vec3{0, 0, 100}, Vec3{0, 0, -1e5}}) {
                const PointPencil lamp = point_pencil({at, {}}, scene.camera, spheres.survey, spheres.frame);
                CHECK((lamp.faces == 6 || at.z < 0 || crowd == Crowd::coincident || crowd == Crowd::shells));
                check(view_of(lamp, scene.camera, spheres.frame));
            }
        }
    });
}
