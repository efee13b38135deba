#include "measure.h"

#include <limits>
#include <utility>

namespace gnomon::report {

namespace {

std::vector<Formula> formulas_for(const DeviceInfo& device) {
    std::vector<Formula> able;
    for (const Formula& formula : formulas())
        if (device.fp64 || !formula.needs_double) able.push_back(formula);
    return able;
}

double error_of(const RootRow& row) {
    // A formula that found none of the hits has no error of t, and is worth nothing.
    return row.error.t.count > 0 ? row.error.t.max : std::numeric_limits<double>::infinity();
}
double time_of(const RootRow& row) { return row.ns_per_ray.median; }
double error_of(const PictureRow& row) { return row.picture.error.check.max_radiance; }
double time_of(const PictureRow& row) { return row.picture.seconds.median; }

template <class Row>
void mark_front(std::vector<Row>& rows) {
    std::vector<Cost> costs;
    for (const Row& row : rows) costs.push_back({time_of(row), error_of(row)});
    const std::vector<bool> front = pareto_front(costs);
    for (size_t i = 0; i < rows.size(); ++i) rows[i].on_front = front[i];
}

RootTable measure_case(RootsBench& bench, const RootCase& rays, const std::vector<ExactHit>& exact,
                       const std::vector<Formula>& formulas, int rounds) {
    RootTable table{rays.name, rays.about, static_cast<int64_t>(rays.dirs.size()), {}};
    const std::vector<Roots> found = bench.measure(rays, formulas, rounds);
    for (size_t i = 0; i < formulas.size(); ++i)
        table.rows.push_back({formulas[i], found[i].ns_per_ray, compare(rays, exact, found[i])});
    mark_front(table.rows);
    return table;
}

std::vector<GridMap> measure_grid(RootsBench& bench, const Exam& exam, const std::vector<Formula>& formulas,
                                  const Grid& grid) {
    std::vector<GridMap> maps;
    const std::vector<Roots> found = bench.measure(exam.grid, formulas, 0);
    for (size_t i = 0; i < formulas.size(); ++i)
        maps.push_back({formulas[i], compare_cells(grid, exam.grid, exam.grid_exact, found[i])});
    return maps;
}

PictureTable measure_scene(Renderer& renderer, const DeviceInfo& device, const NamedScene& named,
                           const PictureEffort& effort) {
    const Scene& scene = named.scene;
    PictureTable table{named.name, scene.image, sphere_count(scene), static_cast<int64_t>(scene.lights.size()), {}};
    for (Picture& picture : measure_pictures(renderer, scene, available_accuracies(device), effort))
        table.rows.push_back({std::move(picture)});
    mark_front(table.rows);
    return table;
}

}  // namespace

Effort quick_effort() { return {1 << 13, 7, {28, 25, 7, 1.25, 1}, {3, 1 << 11, int64_t{1} << 24}}; }

Exam make_exam(const Effort& effort) {
    Exam exam{root_cases(effort.rays), {}, grid_case(effort.grid), {}};
    for (const RootCase& rays : exam.cases) exam.exact.push_back(exact_hits(rays));
    exam.grid_exact = exact_hits(exam.grid);
    return exam;
}

DeviceReport measure(const DeviceInfo& device, const Exam& exam, const std::vector<NamedScene>& scenes,
                     const Effort& effort, const std::function<void(const std::string&)>& say) {
    DeviceReport report;
    report.device = device;
    report.grid = effort.grid;
    const std::vector<Formula> able = formulas_for(device);
    if (!device.fp64) report.notes.push_back("the device has no double precision (cl_khr_fp64): no formula in double");
    {
        RootsBench bench(device);
        for (size_t i = 0; i < exam.cases.size(); ++i) {
            say("rays: " + exam.cases[i].name);
            report.roots.push_back(measure_case(bench, exam.cases[i], exam.exact[i], able, effort.rounds));
        }
        report.maps = measure_grid(bench, exam, able, effort.grid);
    }
    Renderer renderer(device);
    for (const NamedScene& scene : scenes) {
        say("picture: " + scene.name);
        report.pictures.push_back(measure_scene(renderer, device, scene, effort.pictures));
    }
    return report;
}

}  // namespace gnomon::report
