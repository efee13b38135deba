#include "quick_oracle.h"

#include "look.h"

namespace gnomon::oracle {

namespace {

Pinhole<QuickInterval> quick_pinhole_of(const Scene& scene) {
    return decided([&] {
        const Pinhole<Interval> p = pinhole_of(scene);
        return Pinhole<QuickInterval>{around(p.eye), around(p.x), around(p.y), around(p.z), p.image};
    });
}

}  // namespace

QuickOracle::QuickOracle(const Scene& scene) : scene_(scene), exact_(scene), pinhole_(quick_pinhole_of(scene)) {}

QuickOracle::Answer QuickOracle::decide(int i, int j) const {
    try {
        return {decisions(Look(exact_.spheres(), pinhole_.line(i, j)), scene_.lights), false};
    } catch (const Undecided&) {
        return {exact_.decide(i, j), true};
    }
}

}  // namespace gnomon::oracle
