// The formulas of cl/formulas.h, as the report names them.
#pragma once

#include <string>
#include <vector>

namespace gnomon::report {

struct Formula {
    std::string name;  ///< cl/formulas.h has it as intersect_NAME
    std::string about;
    bool needs_double = false;
    bool is_default = false;  ///< what pictures are made with
};

inline std::vector<Formula> formulas() {
    return {{"textbook", "b^2 - 4 a c in float"},
            {"perpendicular", "r^2 - |f - (f.d) d|^2 in float (Ray Tracing Gems, ch. 7)"},
            {"pencil", "cl/sphere.h: perpendicular or b^2 - C, with C from the host; compensated where rays graze",
             false, true},
            {"compensated", "perpendicular, in sums of two floats"},
            {"double", "perpendicular in double, rounded to float", true},
            {"certified", "pencil where the bounds of cl/certify.h settle hit or miss, else double", true}};
}

}  // namespace gnomon::report
