#include "flat_view.h"

#include <cmath>
#include <limits>

namespace gnomon {

namespace {

using std::fma;
using std::sqrt;

/// What the kernel includes, with one sphere in place of 16.
template <class real>
struct Projection {
    using floatn = float;
    using realn = real;
    using Real3 = Real3Of<real>;
    using Apex = ApexOf<real>;
    using ParallelPencil = ParallelPencilOf<real>;
    static real reals_of_n(float v) { return v; }
    static float floats_of_n(real v) { return static_cast<float>(v); }
    static constexpr bool HOLDS_TWO_FLOATS = sizeof(real) == sizeof(double);
#include "../cl/projection.h"
};

template <class real>
PencilClusterOf<real> nothing() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    PencilClusterOf<real> empty{};
    for (size_t i = 0; i < CLUSTER; ++i) {
        empty.reach[i] = -infinity;
        empty.r2[i] = -infinity;
        empty.power[i] = infinity;
        empty.id[i] = -1;
    }
    return empty;
}

}  // namespace

template <class real>
std::vector<PencilClusterOf<real>> flat_view(const FlatClusters& spheres, const ApexOf<real>& apex,
                                             const ParallelPencilOf<real>& light, bool is_parallel) {
    using P = Projection<real>;
    const ClusterRest none{};
    std::vector<PencilClusterOf<real>> view(spheres.clusters.size(), nothing<real>());
    for (size_t c = 0; c < view.size(); ++c) {
        const Cluster& from = spheres.clusters[c];
        const ClusterRest& rest = spheres.rests.empty() ? none : spheres.rests[c];
        for (size_t i = 0; i < CLUSTER; ++i) {
            if (from.id[i] < 0) continue;
            const typename P::TwoReals3 center = {P::number_of(from.x[i], rest.x[i]),
                                                  P::number_of(from.y[i], rest.y[i]),
                                                  P::number_of(from.z[i], rest.z[i])};
            const typename P::Projected seen =
                P::projected(center, P::number_of(from.radius[i], rest.radius[i]), apex, light, is_parallel);
            PencilClusterOf<real>& to = view[c];
            to.x[i] = seen.x;
            to.y[i] = seen.y;
            to.z[i] = seen.z;
            to.reach[i] = seen.reach;
            to.r2[i] = seen.r2;
            to.power[i] = seen.power;
            to.id[i] = from.id[i];
        }
    }
    return view;
}

template std::vector<PencilClusterOf<float>> flat_view(const FlatClusters&, const ApexOf<float>&,
                                                       const ParallelPencilOf<float>&, bool);
template std::vector<PencilClusterOf<double>> flat_view(const FlatClusters&, const ApexOf<double>&,
                                                        const ParallelPencilOf<double>&, bool);

}  // namespace gnomon
