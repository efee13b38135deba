// Scenes by the thousand, no two alike, and whether certified pictures of them decide what the oracle decides.
//
// A decision is one of: a ray and the spheres (the nearest id, or a miss); a hit and a light (does it arrive?). Each
// scene's lights, three at most, shine in a channel of their own, so that one picture shows what arrives of each, and
// one without shadows which surfaces face them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kernel_harness.h"
#include "quick_oracle.h"
#include "render.h"

namespace gnomon::test {

/// Makes scenes of one kind. A scene follows from the seed.
struct Maker {
    const char* name;
    Scene (*make)(Random& random);
};
/// Spheres strewn at random, in sizes and places over many orders of magnitude.
extern const Maker random_scenes;
/// Scenes of which many pixels lie on an edge: of a sphere, of a shadow, of day and night, between two spheres.
const std::vector<Maker>& adversaries();
/// One scene in four is moved, by up to 1e7 times what spheres are like there, and one in four is scaled.
Scene elsewhere(Random& random, Scene scene);

/// What trials came to.
struct Tally {
    int64_t scenes = 0, pixels = 0;
    int64_t rays = 0, shadows = 0, facings = 0;  ///< decisions; those about facing are not counted as decisions again
    int64_t wrong = 0;                           ///< decisions, those about facing too
    int64_t too_dark = 0;        ///< pixels and lights that arrive, but in less than the smallest float: black is right
    int64_t exactly = 0;         ///< decisions for which the oracle took many digits
    int64_t confirmed = 0;       ///< pixels for which it was asked both ways
    int64_t contradictions = 0;  ///< where its two ways differ: the oracle is wrong
    int64_t refined = 0, decided_exactly = 0;  ///< pixels, by the renderer: in double or exactly; exactly
    double render_seconds = 0, oracle_seconds = 0;

    int64_t decisions() const { return rays + shadows; }
    Tally& operator+=(const Tally& other);
};
std::string to_string(const Tally& tally);

/// Two answers that differ, who gives them, and the scene: all that it takes to look at the pixel again.
struct Answer {
    const char* whose;
    const oracle::Decisions& decisions;
};
std::string to_string(const Scene& scene, int i, int j, const Answer& a, const Answer& b);

/// Renders a scene and asks the oracle about each pixel. Prints what is wrong, at most `most`
/// pixels of it. Of the pixels that the oracle decides quickly every 4096th is decided exactly too.
Tally try_scene(Renderer& renderer, const Scene& scene, const std::string& name,
                Accuracy accuracy = Accuracy::certified, int64_t most = 3);

}  // namespace gnomon::test
