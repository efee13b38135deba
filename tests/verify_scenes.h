// Which of the hard scenes (tests/hard) `gnomon verify` renders: its files in src/verify/scenes were written from
// these.
#pragma once

#include <string>

#include "hard/hard_case.h"

namespace gnomon::test {

struct VerifyScene {
    const char* file;  ///< NAME.json
    std::vector<HardCase> (*subject)();
    const char* hard_case;
    size_t scene = 0;  ///< of the case's
};

inline constexpr VerifyScene verify_scenes[] = {
    {"touched_exactly", tangents, "touched exactly, small spheres"},
    {"nearly_touched", tangents, "discriminant +-1e-9 r^2, small spheres", 1},
    {"touching_outside", nests, "touching outside"},
    {"nested_4e-5_apart", nests, "nested 4e-5 apart"},
    {"lamps_outside", nests, "inside a sphere, lamps outside", 1},
    {"ground_1e6", grounds, "ground of radius 1e6"},
    {"horizon_1e5", grounds, "horizon of radius 1e5"},
    {"offset_1e8", offsets, "1e8 from the origin", 1},
    {"far_1e-4", distances, "r / d = 1e-4"},
    {"far_1e-6", distances, "r / d = 1e-6"},
    {"radii_1e-6_to_1e6", extremes, "radii 1e-6 to 1e6, stacked"},
    {"scaled_1e-38", extremes, "scaled by 1e-38"},
    {"lamp_on_surface", point_lights, "lamp on a surface"},
    {"grazing_lamp", point_lights, "ways to a lamp that graze"},
    {"eye_inside_1e-9", surfaces, "eye 1e-9 r inside a surface"},
    {"sun_across", terminators, "sun exactly across"},
};

inline Scene scene_of(const VerifyScene& which) {
    for (const HardCase& hard : which.subject())
        if (hard.name == which.hard_case) return hard.scenes.at(which.scene);
    throw std::runtime_error(std::string("no hard case ") + which.hard_case);
}

}  // namespace gnomon::test
