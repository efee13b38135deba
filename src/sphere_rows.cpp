#include "sphere_rows.h"

#include "rounding.h"

namespace gnomon {

namespace {

/// The table of floats that holds all the wanted rows, if one does and the frame leaves them as they are.
const SphereTable* table_with(const Scene& scene, const Frame& frame, int64_t first, int64_t count, int64_t& row) {
    row = first - static_cast<int64_t>(scene.spheres.size());
    if (!frame.is_scene() || row < 0) return nullptr;
    for (const SphereTable& table : scene.tables) {
        if (row < table.count)
            return row + count <= table.count && std::holds_alternative<const float*>(table.rows) ? &table : nullptr;
        row -= table.count;
    }
    return nullptr;
}

/// Rounds to float and keeps what is left over.
class Splitter {
  public:
    Splitter(SphereRows& rows, const Frame& frame) : rows_(rows), frame_(frame) {}

    void operator()(const Sphere& s) {
        const Vec3 c = frame_.place(s.center);
        for (const double number : {c.x, c.y, c.z, s.radius / frame_.unit}) add(number);
        for (const double share : {s.albedo.r, s.albedo.g, s.albedo.b}) rows_.made.push_back(static_cast<float>(share));
    }

  private:
    void add(double number) {
        rows_.made.push_back(round_to_float(number));
        if (!frame_.floats) rows_.rests.push_back(rest_of_float(number));
    }

    SphereRows& rows_;
    const Frame& frame_;
};

}  // namespace

SphereRows sphere_rows(const Scene& scene, const Frame& frame, int64_t first, int64_t count) {
    SphereRows result;
    result.first = first;
    result.count = count;
    int64_t row = 0;
    if (const SphereTable* table = table_with(scene, frame, first, count, row)) {
        result.columns = table->columns;
        result.albedo = table->albedo;
        result.rows = std::get<const float*>(table->rows) + row * table->columns;
        if (table->forget) result.forget = [table, row, count] { table->forget(row, count); };
        return result;
    }
    result.made.reserve(static_cast<size_t>(7 * count));
    if (!frame.floats) result.rests.reserve(static_cast<size_t>(4 * count));
    Splitter split(result, frame);
    for_each_sphere(scene, first, count, [&](int64_t, const Sphere& s) { split(s); });
    result.rows = result.made.data();
    return result;
}

}  // namespace gnomon
