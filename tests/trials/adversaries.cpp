#include "adversaries.h"

#include "shapes.h"

namespace gnomon::test {

/// One in four is moved far away, by up to 1e7 times what spheres are like there; one in four is scaled.
Scene elsewhere(Random& random, Scene scene) {
    if (chance(random, 0.25)) scene = moved(scene, random.direction() * random.scale(1, 1e7));
    if (chance(random, 0.25)) scene = scaled(scene, random.scale(1e-4, 1e4));
    return chance(random, 0.02) ? scaled(scene, random.scale(1e-25, 1e25)) : scene;
}

const std::vector<Maker>& adversaries() {
    static const std::vector<Maker> all = [] {
        std::vector<Maker> both = edges();
        both.insert(both.end(), contacts().begin(), contacts().end());
        return both;
    }();
    return all;
}

}  // namespace gnomon::test
