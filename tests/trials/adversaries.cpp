#include "adversaries.h"

#include "shapes.h"

namespace gnomon::test {

const std::vector<Maker>& adversaries() {
    static const std::vector<Maker> all = {{"limbs", limbs},
                                           {"gauntlets", gauntlets},
                                           {"horizons", horizons},
                                           {"crossings", crossings},
                                           {"terminators", day_and_night},
                                           {"shadow edges", shadow_edges},
                                           {"specks", specks},
                                           {"nests", nested},
                                           {"twins", twins},
                                           {"chains", chains},
                                           {"lattices", lattices},
                                           {"standing balls", standing_balls},
                                           {"lamps at surfaces", lamps_at_surfaces},
                                           {"eyes at surfaces", eyes_at_surfaces},
                                           {"touches", touches}};
    return all;
}

Scene elsewhere(Random& random, Scene scene) {
    if (chance(random, 0.25)) scene = moved(scene, random.direction() * random.scale(1, 1e7));
    if (chance(random, 0.25)) scene = scaled(scene, random.scale(1e-4, 1e4));
    return chance(random, 0.02) ? scaled(scene, random.scale(1e-25, 1e25)) : scene;
}

}  // namespace gnomon::test
