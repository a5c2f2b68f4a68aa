#include "physics/model/compiled_scene.h"

#include <utility>

namespace carom {
namespace {

Model model_of(const Scene& scene, const Needs& needs, double start_time) {
  Model model;
  model.start_time = start_time;
  model.starts = body_starts(scene.bodies, start_time);
  model.mass = mass_properties(scene.bodies);
  model.shapes = geometry(scene.bodies, scene.joints);
  model.surfaces = surfaces_of(scene, scene.bodies, model.shapes);
  model.forces = force_terms(scene.forces, scene.bodies, needs);
  if (needs.has(Part::kDrives)) model.drives = drive_terms(scene.bodies);
  if (needs.has(Part::kJoints))
    model.joint_terms =
        joint_terms_of(scene.joints, scene.bodies, {model.starts, model.drives, model.mass}, start_time);
  model.impact_law = scene.impact_law;
  model.several_impacts = scene.several_impacts;
  model.untrimmed = needs.untrimmed;
  model.smooth_discs = true;
  for (const Part part : {Part::kRotation, Part::kFriction, Part::kSticking, Part::kJoints, Part::kSwitching})
    model.smooth_discs = model.smooth_discs && !needs.has(part);
  return model;
}

}  // namespace

std::shared_ptr<const CompiledScene> compile(Scene scene, const Needs& needs, double start_time) {
  scene.bodies = all_bodies(scene);
  scene.generators.clear();
  auto compiled = std::make_shared<CompiledScene>();
  compiled->model = model_of(scene, needs, start_time);
  compiled->needs = needs;
  compiled->scene = std::move(scene);
  return compiled;
}

}  // namespace carom
