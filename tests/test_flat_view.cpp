// What a pencil sees of few spheres, on the host, is what project_spheres sees.
#include "flat_view.h"

#include "crowds.h"
#include "guarded_spheres.h"

using namespace gnomon;
using namespace gnomon::test;

namespace {

/// The values of all clusters' spheres, one after the other.
template <class real, class Member>
auto values_of(const std::vector<PencilClusterOf<real>>& clusters, Member member) {
    std::vector<std::decay_t<decltype((clusters[0].*member)[0])>> values;
    for (const auto& c : clusters)
        for (size_t i = 0; i < CLUSTER; ++i)
            if (c.id[i] >= 0) values.push_back((c.*member)[i]);
    return values;
}

template <class real>
void check_same(const Bench& bench, const std::vector<PencilClusterOf<real>>& a,
                const std::vector<PencilClusterOf<real>>& b) {
    using C = PencilClusterOf<real>;
    for (const auto member : {&C::x, &C::y, &C::z, &C::r2, &C::power})
        CHECK(values_of(a, member) == values_of(b, member));
    CHECK(values_of(a, &C::id) == values_of(b, &C::id));
    // Of a root, which few devices round otherwise: cl/reach.h.
    if (bench.info.correctly_rounded) CHECK(values_of(a, &C::reach) == values_of(b, &C::reach));
}

/// Of so many spheres that the kernel has them.
template <class real>
void check_views(Bench& bench, const Scene& scene) {
    DeviceSpheres spheres(bench, scene);
    REQUIRE(!spheres.buffers.shape.is_flat());
    const bool has_rests = spheres.buffers.has_rests;
    const FlatClusters same{spheres.clusters(), read_back<ClusterRest>(bench, spheres.buffers.rests,
                                                                       has_rests ? spheres.clusters().size() : 0)};
    const auto check = [&](const PencilView& view) {
        check_same(bench, spheres.seen<real>(view).clusters,
                   flat_view(same, std::get<ApexOf<real>>(view.apex), std::get<ParallelPencilOf<real>>(view.parallel),
                             view.is_parallel));
    };
    check(view_of_eye<real>(scene.camera, spheres.frame));
    check(view_of(parallel_pencil<real>({{1, 2, -1.5}, {1, 1, 1}}), scene.camera, spheres.frame));
}

}  // namespace

TEST_CASE("flat_view: the bits are those of project_spheres", "[flat]") {
    on_every_bench([](Bench& bench) {
        for (const Crowd crowd : crowds)
            for (const double eye : {0.0, 100.0, 1.0 / 3}) {
                INFO(to_string(crowd) << ", eye at " << eye);
                Scene scene = scene_of(crowd, 300);
                scene.camera = {{eye, -eye, eye}, {eye, -eye, eye + 1}, {0, 1, 0}, 40};
                check_views<float>(bench, scene);
                if (bench.info.fp64) check_views<double>(bench, scene);
            }
    });
}

TEST_CASE("flat_view: empty places reach nothing", "[flat]") {
    Cluster cluster{};
    std::fill(std::begin(cluster.id), std::end(cluster.id), -1);
    cluster.id[2] = 7;
    cluster.radius[2] = 1;
    const PencilCluster seen = flat_view<float>({{cluster}, {}}, {}, {}, false)[0];
    CHECK(std::vector<int>(seen.id, seen.id + 4) == std::vector<int>{-1, -1, 7, -1});
    CHECK(seen.reach[2] > 1);
    CHECK(seen.power[2] == -1);
    for (const int empty : {0, 1, 3, CLUSTER - 1}) {
        CHECK(seen.reach[empty] == -INFINITY);
        CHECK(seen.r2[empty] == -INFINITY);
        CHECK(seen.power[empty] == INFINITY);
    }
}
