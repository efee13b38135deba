// Measures everything on one device.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report.h"

namespace gnomon::report {

/// How much is done.
struct Effort {
    int64_t rays = 1 << 19;  ///< a case
    int rounds = 21;         ///< launches of each formula that are timed
    Grid grid{28, 25, 7, 1.25, 4};
    PictureEffort pictures;
};
/// What --quick does.
Effort quick_effort();

/// The cases and the grid with what is exact, computed once for all devices.
struct Exam {
    std::vector<RootCase> cases;
    std::vector<std::vector<ExactHit>> exact;
    RootCase grid;
    std::vector<ExactHit> grid_exact;
};
Exam make_exam(const Effort& effort);

/// `say` is told what comes next. Throws Error(Blame::run) when the device fails.
DeviceReport measure(const DeviceInfo& device, const Exam& exam, const std::vector<NamedScene>& scenes,
                     const Effort& effort, const std::function<void(const std::string&)>& say);

}  // namespace gnomon::report
