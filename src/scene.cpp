#include "scene.h"

namespace gnomon {

Sphere SphereTable::operator[](size_t row) const {
    const auto read = [&](const auto* first) {
        const auto* v = first + row * static_cast<size_t>(columns);
        const auto at = [&](int i) { return static_cast<double>(v[i]); };
        return Sphere{{at(0), at(1), at(2)}, at(3), columns == 4 ? albedo : Rgb{at(4), at(5), at(6)}};
    };
    return std::visit(read, rows);
}

int64_t sphere_count(const Scene& scene) {
    auto count = static_cast<int64_t>(scene.spheres.size());
    for (const SphereTable& table : scene.tables) count += table.count;
    return count;
}

Sphere sphere_of(const Scene& scene, int64_t id) {
    if (id < static_cast<int64_t>(scene.spheres.size())) return scene.spheres[static_cast<size_t>(id)];
    id -= static_cast<int64_t>(scene.spheres.size());
    size_t table = 0;
    for (; id >= scene.tables[table].count; ++table) id -= scene.tables[table].count;
    return scene.tables[table][static_cast<size_t>(id)];
}

}  // namespace gnomon
