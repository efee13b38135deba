// Adversaries by subject, each in a file of its name.
#pragma once

#include "trials.h"

namespace gnomon::test {

// edges
Scene limbs(Random& random);
Scene gauntlets(Random& random);
Scene horizons(Random& random);
Scene crossings(Random& random);
Scene day_and_night(Random& random);
Scene shadow_edges(Random& random);
Scene specks(Random& random);
// contacts
Scene nested(Random& random);
Scene twins(Random& random);
Scene chains(Random& random);
Scene standing_balls(Random& random);
// at_surfaces
Scene lamps_at_surfaces(Random& random);
Scene eyes_at_surfaces(Random& random);
// whole_numbers
Scene lattices(Random& random);
Scene touches(Random& random);

}  // namespace gnomon::test
