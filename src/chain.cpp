#include "chain.h"

#include <algorithm>

namespace gnomon {

namespace {

/// Adds launches to a plan, and a kernel variant when a launch is the first to need it.
class Chain {
  public:
    explicit Chain(Plan& plan) : plan_(plan) {}

    void add(Step step, const std::vector<std::string>& defines, Accuracy accuracy) {
        const Variant variant{step.kernel, defines, accuracy};
        std::vector<Variant>& variants = plan_.variants;
        const auto found = std::find(variants.begin(), variants.end(), variant);
        step.variant = static_cast<int>(found - variants.begin());
        if (found == variants.end()) variants.push_back(variant);
        plan_.steps.push_back(step);
    }
    void add_lanes(Step step, std::vector<std::string> defines) {
        defines.insert(defines.begin(),
                       {"LANES=" + std::to_string(plan_.lanes), "PACKETS=" + std::to_string(plan_.packets)});
        add(step, defines, plan_.accuracy);
    }
    /// For a kernel that meets the spheres.
    void add_tracing(Step step, std::vector<std::string> defines) {
        defines.push_back("WALK=" + plan_.walk());
        if (step.kernel == Kernel::shade_light) {
            defines.push_back(plan_.albedos_of_rays ? "ALBEDOS_OF_RAYS=1" : "ALBEDOS_OF_RAYS=0");
            defines.push_back(plan_.resolve_radiance ? "RESOLVES=0" : "RESOLVES=1");
            defines.push_back(stream());
        } else {
            defines.push_back(plan_.memory.cut ? "CHUNKS=1" : "CHUNKS=0");
        }
        if (plan_.certified) {
            defines.push_back("CERTIFIED=1");
            defines.push_back("DOUBT_RAYS=" + std::to_string(plan_.doubt_rays));
        }
        if (plan_.boxes) defines.push_back("BOXES=1");
        if (step.kernel == Kernel::intersect_closest) {
            defines.push_back(plan_.generate_rays ? "RAYS=RAYS_READ" : "RAYS=RAYS_GENERATED");
            defines.push_back(plan_.all_hits ? "HITS=HITS_ALL" : "HITS=HITS_FOR_LIGHTS");
        }
        add_lanes(step, defines);
    }
    void resolve(Output output) {
        Step step{Kernel::resolve, 0};
        step.output = output;
        // Ids are words, and so are floats to this kernel.
        const bool doubles = computes_in_double(plan_.accuracy) && output != Output::id;
        add(step, {stream()}, doubles ? plan_.accuracy : Accuracy::strict);
    }

  private:
    std::string stream() const { return plan_.stream ? "STREAM=1" : "STREAM=0"; }

    Plan& plan_;
};

const char* define(Shadows shadows) {
    switch (shadows) {
        case Shadows::off:
            return "SHADOWS=SHADOWS_OFF";
        case Shadows::read:
            return "SHADOWS=SHADOWS_READ";
        case Shadows::traced:
            break;
    }
    return "SHADOWS=SHADOWS_TRACED";
}

bool shines(const Light& light) {
    const auto any = [](const Rgb& c) { return c.r > 0 || c.g > 0 || c.b > 0; };
    const auto* point = std::get_if<PointLight>(&light);
    return any(point ? point->power : std::get<DirectionalLight>(light).irradiance);
}

std::vector<int> shining(const Scene& scene) {
    std::vector<int> lights;
    for (size_t i = 0; i < scene.lights.size(); ++i)
        if (shines(scene.lights[i])) lights.push_back(static_cast<int>(i));
    return lights;
}

const char* define(const Light& light) {
    return std::holds_alternative<PointLight>(light) ? "LIGHT=LIGHT_POINT" : "LIGHT=LIGHT_DIRECTIONAL";
}

/// A shadow pass for each of some lights, of which the last may be part of the launch that shades them all. What is
/// built for that serves all lights of its kind.
void add_batch(Chain& chain, const Scene& scene, Shadows shadows, const std::vector<int>& lights, bool first) {
    const auto light = [&](int i) -> const Light& { return scene.lights[static_cast<size_t>(i)]; };
    const size_t read = lights.size() - (shadows == Shadows::read ? 0 : 1);
    const std::vector<std::string> shading{define(light(lights.back())), define(shadows),
                                           "LIGHTS=" + std::to_string(lights.size())};
    for (size_t i = 0; i < read; ++i) {
        const bool alike = light(lights[i]).index() == light(lights.back()).index() && shadows == Shadows::traced;
        Step step{alike ? Kernel::shade_light : Kernel::intersect_shadow, 0, lights[i]};
        step.arrival = static_cast<int>(i);
        chain.add_tracing(step, alike ? shading : std::vector<std::string>{define(light(lights[i]))});
    }
    Step step{Kernel::shade_light, 0, lights.back()};
    step.shaded = lights;
    step.first = first;
    chain.add_tracing(step, shading);
}

void add_lights(Chain& chain, const Scene& scene, Shadows shadows) {
    const std::vector<int> all = shining(scene);
    const size_t most = shadows == Shadows::off ? 1 : MOST_SHADED;
    for (size_t i = 0; i < all.size(); i += most) {
        const auto begin = all.begin() + static_cast<std::ptrdiff_t>(i);
        const auto count = static_cast<std::ptrdiff_t>(std::min(most, all.size() - i));
        add_batch(chain, scene, shadows, {begin, begin + count}, i == 0);
    }
}

}  // namespace

void add_steps(Plan& plan, const Scene& scene, const RenderOptions& options) {
    const Outputs& wanted = options.outputs;
    const bool shaded = wanted.radiance && std::any_of(scene.lights.begin(), scene.lights.end(), shines);
    if (plan.spheres == 0 || !(shaded || wanted.distance || wanted.normal || wanted.id)) return;
    plan.boxes = shaded && plan.shadows == Shadows::traced && plan.walk() == "WALK_CLUSTERS" &&
                 plan.rays_per_item() == BLOCK_RAYS && !computes_in_double(plan.accuracy);
    Chain chain(plan);
    if (plan.generate_rays) chain.add_lanes({Kernel::generate_rays, 0}, {});
    chain.add_tracing({Kernel::intersect_closest, 0}, {});
    if (wanted.distance) chain.resolve(Output::distance);
    if (wanted.normal) chain.resolve(Output::normal);
    if (wanted.id) chain.resolve(Output::id);
    if (shaded) {
        add_lights(chain, scene, plan.shadows);
        if (plan.resolve_radiance)
            chain.resolve(Output::radiance);
        else
            plan.steps.back().resolves = true;
    }
}

void add_refinement_steps(Plan& plan, const Scene& scene, bool shaded) {
    Chain chain(plan);
    chain.add({Kernel::refine_rays, 0}, {"LANES=1", "PACKETS=1"}, plan.accuracy);
    chain.add_tracing({Kernel::intersect_closest, 0}, {});
    if (shaded) add_lights(chain, scene, plan.shadows);
}

void add_sphere_kernels(Plan& plan, const Scene& scene) {
    if (plan.flat()) return;
    const auto add = [&](Kernel kernel, bool parallel = false) {
        const Variant variant = sphere_variant(kernel, plan.accuracy, plan.has_rests, parallel, plan.memory.cut);
        std::vector<Variant>& all = plan.variants;
        if (std::find(all.begin(), all.end(), variant) == all.end()) all.push_back(variant);
    };
    const auto add_view = [&](bool parallel) {
        add(Kernel::project_spheres);
        add(Kernel::bound_clusters, parallel);
        add(Kernel::bound_nodes, parallel);
    };
    for (const Kernel kernel : {Kernel::sphere_keys, Kernel::count_digits, Kernel::scan_counts, Kernel::scatter_pairs,
                                Kernel::find_duplicates, Kernel::gather_spheres})
        add(kernel);
    add_view(false);
    if (plan.shadows == Shadows::off || !plan.uses(Kernel::shade_light)) return;
    for (const Light& light : scene.lights)
        if (shines(light)) add_view(std::holds_alternative<DirectionalLight>(light));
}

}  // namespace gnomon
