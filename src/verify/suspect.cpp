#include "suspect.h"

#include <fmt/core.h>

#include <algorithm>

namespace gnomon::verify {

namespace {

bool ran(const RenderStats& stats, const std::string& kernel) {
    return std::any_of(stats.kernels.begin(), stats.kernels.end(),
                       [&](const KernelStats& k) { return k.kernel == kernel; });
}

/// What else can be behind it: what certified pictures compute again, what rays walk through.
std::string others(const RenderStats& stats) {
    std::string text;
    if (ran(stats, "refine_rays")) text += ", or where it is decided again, refine_rays";
    if (ran(stats, "bound_nodes")) text += ", or what it walks, from sphere_keys to bound_nodes";
    return text;
}

/// Radiance follows from what the eye's kernels wrote, not from what was resolved of that: it may stay as it was where
/// these are wrong, but hardly ever does.
std::string of_eye(const Evidence& evidence) {
    const RenderStats& stats = evidence.stats;
    const bool resolved =
        !evidence.expected.lights.empty() && evidence.found.sha1.back() == evidence.expected.picture.sha1.back();
    return (resolved ? "resolve or " : "") + std::string(ran(stats, "generate_rays") ? "generate_rays or " : "") +
           "intersect_closest" + others(stats);
}

std::string of_light(const RenderStats& stats, size_t light, bool shading) {
    if (shading) return fmt::format("shade_light, light {}", light);
    const std::string traces = ran(stats, "intersect_shadow") ? "intersect_shadow" : "shade_light's shadow rays";
    return fmt::format("{}, light {}{}", traces, light, others(stats));
}

}  // namespace

std::string suspect(Renderer& renderer, const Evidence& evidence) {
    const auto& expected = evidence.expected;
    for (size_t r = 0; r + 1 < results.size(); ++r)
        if (evidence.found.sha1[r] != expected.picture.sha1[r]) return of_eye(evidence);
    Film film;
    for (size_t light = 0; light < expected.lights.size(); ++light)
        for (const bool shadows : {false, true}) {
            const LightPrint& print = expected.lights[light];
            const RenderStats stats = render_light(renderer, evidence.of, evidence.mode, light, shadows, film);
            if (radiance_sha1(film) != (shadows ? print.shadowed : print.shaded))
                return of_light(stats, light, !shadows);
        }
    return "shade_light or resolve, where lights are added up";
}

}  // namespace gnomon::verify
