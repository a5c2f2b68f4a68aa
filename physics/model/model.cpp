#include "physics/model/model.h"

#include <utility>

namespace carom {

std::shared_ptr<const Model> compile(Scene scene, const Needs& needs, double start_time) {
  auto model = std::make_shared<Model>();
  scene.bodies = all_bodies(scene);
  scene.generators.clear();
  model->needs = needs;
  model->start_time = start_time;
  model->mass = mass_properties(scene.bodies);
  model->shapes = geometry(scene.bodies, scene.joints);
  model->surfaces = surfaces_of(scene, scene.bodies, model->shapes);
  model->forces = force_terms(scene.forces, scene.bodies, needs);
  if (needs.has(Part::kJoints))
    model->joint_terms = joint_terms_of(scene.joints, scene.bodies, model->mass, start_time);
  if (needs.has(Part::kDrives)) {
    for (const Body& body : scene.bodies) model->kinematic.push_back(body.drive ? 1 : 0);
  }
  model->smooth_discs = true;
  for (const Part part : {Part::kRotation, Part::kFriction, Part::kSticking, Part::kJoints, Part::kSwitching})
    model->smooth_discs = model->smooth_discs && !needs.has(part);
  model->scene = std::move(scene);
  return model;
}

}  // namespace carom
