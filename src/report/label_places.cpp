#include "label_places.h"

#include <algorithm>

namespace gnomon::report {

namespace {

double area(const Box& b) { return std::max(0.0, b.x1 - b.x0) * std::max(0.0, b.y1 - b.y0); }
double overlap(const Box& a, const Box& b) {
    return area({std::max(a.x0, b.x0), std::min(a.x1, b.x1), std::max(a.y0, b.y0), std::min(a.y1, b.y1)});
}

constexpr double marker = 6;  // pixels from a point's middle to its edge

/// The places around a point, the best first: beside it, above and below, and farther off.
std::vector<Box> candidates(const Panel& panel, const Point& p) {
    const double w = panel.letter_width * static_cast<double>(p.name.size()), h = panel.letter_height, gap = marker + 3;
    std::vector<Box> boxes;
    const auto add = [&](double x, double y) { boxes.push_back({x, x + w, y - h / 2, y + h / 2}); };
    for (const double dy : {0.0, h, -h, 2 * h, -2 * h, 3 * h, -3 * h, 4 * h, -4 * h}) {
        add(p.x + gap, p.y + dy);
        add(p.x - gap - w, p.y + dy);
        if (dy != 0) add(p.x - w / 2, p.y + dy);
    }
    return boxes;
}

}  // namespace

std::vector<LabelPlace> label_places(const Panel& panel, const std::vector<Point>& points,
                                     const std::vector<Box>& obstacles) {
    const Box inside{0, panel.width, 0, panel.height};
    std::vector<Box> taken = obstacles;
    for (const Point& p : points) taken.push_back({p.x - marker, p.x + marker, p.y - marker, p.y + marker});
    std::vector<LabelPlace> places;
    for (const Point& p : points) {
        const auto covered = [&](const Box& box) {
            double sum = 4 * (area(box) - overlap(box, inside));  // what is cut off cannot be read at all
            for (const Box& other : taken) sum += overlap(box, other);
            return sum;
        };
        const std::vector<Box> boxes = candidates(panel, p);
        const auto best = std::min_element(boxes.begin(), boxes.end(),
                                           [&](const Box& a, const Box& b) { return covered(a) < covered(b); });
        taken.push_back(*best);
        places.push_back({best->x0, (best->y0 + best->y1) / 2});
    }
    return places;
}

}  // namespace gnomon::report
