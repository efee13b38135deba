// Scenes that are hard for a renderer in floating point, and how wrong the default accuracy is about each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene.h"

namespace gnomon::test {

/// How far pictures are from the truth (oracle.h). Strict accuracy has the same bits on every device, so that these are
/// exact figures, not estimates.
struct Figures {
    int64_t hits = 0;     ///< pixels that hit where they should miss, or the other way
    int64_t ids = 0;      ///< pixels that hit another sphere
    int64_t shadows = 0;  ///< lights, counted once a pixel, that should (not) arrive at a hit of the right sphere
    double t = 0;         ///< worst distance to such a hit, in ulp of float
    double normal = 0;    ///< worst normal there, in radians

    int64_t wrong_decisions() const { return hits + ids + shadows; }
};

/// What may not grow: pictures as they are given, and all three times as wide and high, for the long tests.
struct Record {
    Figures figures, at_length;
};

struct HardCase {
    std::string name, why;
    std::vector<Scene> scenes;
    Record record;
};

// By subject, each in a file of its name.
std::vector<HardCase> distances();
std::vector<HardCase> grounds();
std::vector<HardCase> tangents();
std::vector<HardCase> surfaces();
std::vector<HardCase> nests();
std::vector<HardCase> terminators();
std::vector<HardCase> point_lights();
std::vector<HardCase> offsets();
std::vector<HardCase> extremes();
std::vector<HardCase> cameras();

}  // namespace gnomon::test
