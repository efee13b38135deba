// Where to write the names of points, so that they cover neither each other nor the points.
#pragma once

#include <string>
#include <vector>

namespace gnomon::report {

/// A rectangle to place within, in pixels, y up; and what a letter needs.
struct Panel {
    double width, height, letter_width = 6.3, letter_height = 14;
};
struct Point {
    double x, y;
    std::string name;
};
/// The middle of the left end of a name.
struct LabelPlace {
    double x, y;
};
/// What names should not cover either: x0 <= x1, y0 <= y1.
struct Box {
    double x0, x1, y0, y1;
};
/// Greedy: each name in turn takes the one of the places around its point where it covers least of points, of names
/// before it, of obstacles and of what is outside.
std::vector<LabelPlace> label_places(const Panel& panel, const std::vector<Point>& points,
                                     const std::vector<Box>& obstacles = {});

}  // namespace gnomon::report
