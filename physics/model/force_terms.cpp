#include "physics/model/force_terms.h"

#include "physics/math/vectors.h"
#include "physics/model/bodies_by_name.h"
#include "physics/scene/forces.h"

namespace carom {

ForceTerms force_terms(const Forces& forces, const std::vector<Body>& bodies, const Needs& needs) {
  ForceTerms t;
  static_cast<CommonForces&>(t) = static_cast<const CommonForces&>(forces);
  each_common_force(forces, [&t](const CommonForce& force, const auto& value, const auto&...) {
    t.on_each = t.on_each || (force.on == ActsOn::kEachBody && acts(value));
  });
  if (needs.has(Part::kSprings)) {
    for (auto* by_body : {&t.outside, &t.between}) by_body->resize(bodies.size());
  }
  if (needs.has(Part::kSwitching)) t.switching.resize(bodies.size());
  if (needs.has(Part::kAppliedForces)) t.applied_to.resize(bodies.size());
  const auto index = bodies_by_name(bodies);
  for (const Spring& s : forces.springs) {
    const BodyIndex body = index.at(s.body);
    SpringTerm term{body,     kNoBody,     kNoBody,   s.point,       s.anchor,
                    s.anchor, s.stiffness, s.damping, s.rest_length, s.acts};
    const SpringIndex spring = t.springs.end_index();
    if (!s.to.empty()) {
      const BodyIndex other = index.at(s.to);
      term.anchor = bodies[other].position + turned_by(bodies[other].angle, s.anchor);
      if (bodies[other].drive) term.drive = other;
      if (!has_infinite_mass(bodies[other])) term.other = other;
    }
    (term.other < 0 ? t.outside : t.between)[body].push_back(spring);
    if (term.other >= 0) t.between[term.other].push_back(spring);
    if (s.acts != SpringActs::kBoth) {
      t.switching[body].push_back(spring);
      if (term.other >= 0) t.switching[term.other].push_back(spring);
      t.one_sided = true;
    }
    t.springs.push_back(term);
  }
  for (const AppliedForce& f : forces.applied) {
    const BodyIndex body = index.at(f.body);
    t.applied_to[body].push_back(t.applied.end_index());
    t.applied.push_back({body, f.point, f.force, f.torque, f.start, f.rise, f.end});
    const bool turns_along = !f.point.isZero(0.0) && !f.force.isZero(0.0);
    t.constant = t.constant && f.start == 0.0 && f.rise == 0.0 && !f.end && !turns_along;
  }
  if (forces.hand) {
    const auto body = index.find(forces.hand->body);
    if (body != index.end() && !has_infinite_mass(bodies[body->second]))
      t.hand = {body->second, forces.hand->grip, forces.hand->place, forces.hand->stiffness,
                forces.hand->damping};
  }
  bool smooth = false;
  for (const PartEntry& part : part_entries()) smooth = smooth || (part.varies && needs.has(part.part));
  t.constant = t.constant && !smooth && !t.hand;
  t.gravity_only = !smooth && !needs.has(Part::kAppliedForces);
  return t;
}

}  // namespace carom
