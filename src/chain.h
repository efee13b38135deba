// The launches of every tile's chain, and the kernel variants that they and the spheres need.
#pragma once

#include "plan.h"

namespace gnomon {

/// Only what the scene and the outputs need: without spheres, or without anything to show of them, no launch at all.
/// All else of the plan must be decided.
void add_steps(Plan& plan, const Scene& scene, const RenderOptions& options);

/// The kernels that put the spheres in order, and in each pencil's view, if they are many; after the steps.
void add_sphere_kernels(Plan& plan, const Scene& scene);

/// Of rays that are listed: what is made for each, with nothing resolved.
void add_refinement_steps(Plan& plan, const Scene& scene, bool shaded);

}  // namespace gnomon
