#include "physics/model/needs.h"

#include "physics/scene/facts.h"
#include "physics/scene/method.h"

namespace carom {

Needs needs_of(const Scene& scene) {
  const SceneFacts f = facts_of(scene);
  const bool meet = f.moving > 0 && f.moving + f.immovable > 1;
  Needs n;
  // Without friction nothing turns a disc but a torque, and impacts turn all other shapes. Tangential
  // restitution acts only within the bound that kinetic friction sets, so it needs friction as well.
  n.friction = f.rub;
  n.rotation = f.spinning || f.torques || f.rub || f.turning_links || f.sticks || (meet && f.cornered);
  const bool links = f.links || f.sticks;
  n.smooth_forces = f.drag || f.springs || links || f.attraction || f.pushes || f.torques;
  n.velocity_forces = f.drag || f.dampers;
  n.coupled_forces = f.coupling_springs || f.attraction;
  n.links = links;
  n.drives = f.driven || f.pushes || f.torques;
  n.switching = f.switched;
  // Uniform gravity gives two free bodies the same acceleration: it presses only against immovable ones. With
  // e = 1 and no relative acceleration every impact parts its pair for good; with e < 1 several bodies can
  // collapse onto one another.
  const bool relative_acceleration = f.drag || f.springs || links || f.attraction || f.pushes ||
                                     f.accelerating || (!scene.forces.gravity.isZero(0.0) && f.immovable > 0);
  n.lasting_contacts = meet && (relative_acceleration || f.yield);
  n.closed_form_flight = !f.drag && !f.springs && !f.links && !f.sticky && !f.attraction && !f.timed;
  return n;
}

NeedsText text_of(const Needs& needs, const Scene& scene, ContactsId contacts) {
  const SceneFacts f = facts_of(scene);
  NeedsText text;
  const auto modelled = [&](const char* noun, bool is) {
    if (is) text.modelled.emplace_back(noun);
  };
  // Parts that every scene is asked about.
  const auto either = [&](const char* noun, bool is) {
    (is ? text.modelled : text.not_needed).emplace_back(noun);
  };
  modelled("normal impulses", f.moving > 0 && f.moving + f.immovable > 1);
  modelled("gravity", f.moving > 0 && !scene.forces.gravity.isZero(0.0));
  modelled("springs", f.springs);
  modelled("dampers", f.dampers);
  modelled("links", f.links);
  modelled("sticking", f.sticks);
  modelled("attraction", f.attraction);
  modelled("applied forces", f.pushes || f.torques);
  either("rotation", needs.rotation);
  either("friction", needs.friction);
  either("drag", needs.velocity_forces && (f.drag || !f.dampers));
  either("coupled forces", needs.coupled_forces);
  either("driven bodies", needs.drives && (f.driven || !(f.pushes || f.torques)));
  either("switched forces", needs.switching);
  const bool as_impacts = needs.lasting_contacts && contacts == ContactsId::kImpulse;
  either(as_impacts ? "lasting contacts (as repeated impacts)" : "lasting contacts", needs.lasting_contacts);
  return text;
}

}  // namespace carom
