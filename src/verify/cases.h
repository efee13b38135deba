// The scenes that every device must render to the same bits.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "accuracy.h"
#include "device.h"
#include "scene.h"

namespace gnomon::verify {

/// One scene; its image is at most 320 x 240, in quick ones 40 x 30.
struct Case {
    std::string name;
    Scene scene;
    uint64_t memory = 0;  ///< bytes of the device that may be used, so that the spheres go through it in chunks; 0: all

    /// Whether the device can render it at all.
    bool suits(const DeviceInfo& device) const;
    /// Certified pictures want all spheres on the device at once.
    bool has(Accuracy accuracy) const { return memory == 0 || accuracy != Accuracy::certified; }
};

/// The examples, hard scenes (scenes/*.json) and a crowd, whole and in chunks. Quick ones, for devices that are
/// simulated or slow: a few of these, smaller, and a smaller crowd.
std::vector<Case> cases(bool quick);

/// `count` spheres strewn in a cube, without anything of the mathematics library, so that they are the same everywhere.
Scene crowd(int64_t count);

}  // namespace gnomon::verify
