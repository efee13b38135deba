#include "render.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "clock.h"
#include "device_renderer.h"
#include "error.h"
#include "team.h"

namespace gnomon {

namespace {

template <class T>
void fill(Plane<T>& plane, T value) {
    std::fill(plane.begin(), plane.end(), value);
}

/// The planes that no step resolves: nothing was hit, or no light shines.
void fill_untouched(Film& film, const Plan& plan) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (!plan.uses(Kernel::shade_light))
        for (auto& plane : film.radiance) fill(plane, 0.0f);
    if (!plan.steps.empty()) return;
    fill(film.distance, infinity);
    for (auto& plane : film.normal) fill(plane, infinity);
    fill(film.id, -1);
}

bool fits(const Film& film, const ImageSize& image, const Outputs& outputs) {
    return film.width == image.width && film.height == image.height && !film.radiance[0].empty() == outputs.radiance &&
           !film.distance.empty() == outputs.distance && !film.normal[0].empty() == outputs.normal &&
           !film.id.empty() == outputs.id;
}

}  // namespace

struct Renderer::State {
    Team team;
    std::optional<Survey> spheres;  // of the last picture
};

Renderer::Renderer(const DeviceInfo& device) : Renderer(std::vector<DeviceInfo>{device}) {}
Renderer::Renderer(const std::vector<DeviceInfo>& devices)
    : state_(std::make_unique<State>(State{Team(devices), {}})) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

RenderStats Renderer::render(const Scene& scene, const RenderOptions& options, Film& film) try {
    Team& team = state_->team;
    team.check_accuracy(options.accuracy);
    const double start = now();
    if (!options.same_spheres || !state_->spheres) state_->spheres = survey(scene);
    const Survey& spheres = *state_->spheres;
    const Frame frame = choose_frame(scene, spheres);
    const std::vector<Plan> plans = team.make_plans(scene, spheres, options);
    if (!fits(film, scene.image, options.outputs)) film = Film(scene.image.width, scene.image.height, options.outputs);
    fill_untouched(film, plans.front());
    if (plans.front().steps.empty()) return planned(plans.front(), scene);
    const double planned_at = now();
    RenderStats stats = team.render(scene, spheres, frame, plans, options, film);
    stats.prepare_seconds += planned_at - start;
    if (frame.unit != 1)
        for (float& distance : film.distance) distance = static_cast<float>(distance * frame.unit);
    return stats;
} catch (const std::bad_alloc&) {
    throw Error(Blame::run, "out of memory", "", "render a smaller --size");
}

}  // namespace gnomon
