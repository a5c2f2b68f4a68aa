#include "physics/motion/force_field.h"

#include <algorithm>

namespace carom {

ForceField::ForceField(const Forces& forces, const std::vector<Body>& bodies)
    : gravity_(forces.gravity),
      drag_(forces.quadratic_drag),
      inverse_mass_(mass_properties(bodies).inverse_mass) {
  if (forces.springs.empty()) return;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    first_.push_back(static_cast<int>(springs_.size()));
    for (const Spring& s : forces.springs) {
      if (s.body == bodies[i].name)
        springs_.push_back({static_cast<int>(i), s.anchor, s.stiffness, s.rest_length});
    }
  }
  first_.push_back(static_cast<int>(springs_.size()));
}

Vec2 ForceField::spring_force(int body, const Vec2& position) const {
  Vec2 force = Vec2::Zero();
  for (int k = first_[body]; k < first_[body + 1]; ++k) {
    const Anchored& s = springs_[k];
    const Vec2 d = position - s.anchor;
    if (s.rest_length == 0.0) {
      force -= s.stiffness * d;
    } else if (const double length = d.norm(); length > 0.0) {
      force -= (s.stiffness * (length - s.rest_length) / length) * d;
    }
  }
  return force;
}

double ForceField::potential_energy(int body, const Vec2& position) const {
  if (!(inverse_mass_[body] > 0.0)) return 0.0;
  double energy = -gravity_.dot(position) / inverse_mass_[body];
  if (springs_.empty()) return energy;
  for (int k = first_[body]; k < first_[body + 1]; ++k) {
    const double stretch = (position - springs_[k].anchor).norm() - springs_[k].rest_length;
    energy += 0.5 * springs_[k].stiffness * stretch * stretch;
  }
  return energy;
}

}  // namespace carom
