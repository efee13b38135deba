// All that a report says: what the writers (text, JSON, HTML) and the plots share.
#pragma once

#include <string>
#include <vector>

#include "formulas.h"
#include "measure_pictures.h"
#include "pareto.h"
#include "roots_error.h"

namespace gnomon::report {

/// A formula on one case.
struct RootRow {
    Formula formula;
    Series ns_per_ray;
    RootError error;
    bool on_front = false;  ///< of time against the largest error of t
};

struct RootTable {
    std::string name, about;
    int64_t rays = 0;
    std::vector<RootRow> rows;
};

/// A formula on the grid, and what it costs there.
struct GridMap {
    Formula formula;
    std::vector<Cell> cells;
};

/// A picture in one accuracy.
struct PictureRow {
    Picture picture;
    bool on_front = false;  ///< of time against the largest error of the radiance
};

struct PictureTable {
    std::string scene;
    ImageSize image;
    int64_t spheres = 0, lights = 0;
    std::vector<PictureRow> rows;
};

struct Figure {
    std::string name, title, explanation, svg;
};

struct DeviceReport {
    DeviceInfo device;
    std::vector<std::string> notes;  ///< what is missing, and why
    std::vector<RootTable> roots;
    Grid grid;
    std::vector<GridMap> maps;
    std::vector<PictureTable> pictures;
    std::vector<Figure> figures;
};

struct Report {
    std::string date;  ///< UTC, as ISO 8601 writes it
    bool quick = false;
    std::vector<DeviceReport> devices;
    std::string plots;  ///< why there are none; empty when there are
};

inline bool is_default(const RootRow& row) { return row.formula.is_default; }
inline bool is_default(const PictureRow& row) { return row.picture.accuracy == RenderOptions{}.accuracy; }

/// Whether what is used unless told otherwise is on the front of its table.
template <class Table>
bool default_on_front(const Table& table) {
    for (const auto& row : table.rows)
        if (is_default(row)) return row.on_front;
    return false;
}

/// Million rays a second.
inline double mrays_per_second(const RootRow& row) { return 1e3 / row.ns_per_ray.median; }
inline double mrays_per_second(const Picture& p) { return 1e-6 * static_cast<double>(p.rays) / p.seconds.median; }

}  // namespace gnomon::report
