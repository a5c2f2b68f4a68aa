#include "physics/model/needs.h"

#include <array>
#include <cstddef>

namespace carom {
namespace {

bool can_collide(const SceneFacts& f) { return f.moving > 0 && f.moving + f.infinite_mass > 1; }

// Whether two bodies can have different accelerations. Uniform gravity accelerates two free bodies alike: it
// presses bodies only against those of infinite mass.
bool accelerate_apart(const SceneFacts& f, const Scene& scene) {
  return !f.common_forces.empty() || f.springs || f.joints || f.sticks || f.pushes || f.hand ||
         f.accelerating || (!scene.forces.gravity.isZero(0.0) && f.infinite_mass > 0);
}

constexpr std::array<PartEntry, kPartCount> kEntries = {{
    // Without friction only a torque turns a disc, while impacts turn all other shapes.
    {Part::kRotation, "rotation", "rotation", "impacts with lever arms and spins, not only between centres",
     "something spins, or an impact, friction or a torque can turn it",
     "nothing spins, and nothing can turn it",
     [](const SceneFacts& f, const Scene&) {
       return f.spinning || f.torques || f.hand || f.rub || f.turning_springs || f.turning_joints || f.sticks ||
              (can_collide(f) && f.cornered);
     }},
    // Tangential restitution acts only within the bound that kinetic friction sets, so it needs friction too.
    {Part::kFriction, "friction", "friction", "tangential impulses and forces",
     "two bodies that can meet have kinetic friction", "no two bodies that can meet have friction",
     [](const SceneFacts& f, const Scene&) { return f.rub; }},
    {Part::kSticking, "sticking", "sticking", "welds that impacts make",
     "two bodies that can meet have a surface that sticks", "no surface sticks",
     [](const SceneFacts& f, const Scene&) { return f.sticks; }},
    {Part::kDrag, "drag", "drag", "a force on each body, and its work",
     "the scene has linear or quadratic drag", "there is no drag",
     [](const SceneFacts& f, const Scene&) { return f.common_forces.contains("drag"); }, true},
    {Part::kSprings, "springs", "springs",
     "springs by their bodies; those between two moving bodies couple them", "the scene has springs",
     "there are no springs", [](const SceneFacts& f, const Scene&) { return f.springs; }, true},
    {Part::kAttraction, "attraction", "attraction",
     "a force between every two bodies: all are advanced together", "bodies attract each other",
     "nothing attracts",
     [](const SceneFacts& f, const Scene&) { return f.common_forces.contains("attraction"); }, true},
    {Part::kAppliedForces, "applied_forces", "applied forces",
     "forces and torques by their bodies, and their work", "the scene applies forces or torques",
     "no force or torque is applied",
     [](const SceneFacts& f, const Scene& scene) { return f.hand || !scene.forces.applied.empty(); }},
    {Part::kSwitching, "switching", "switched forces",
     "each flight is searched for the times at which they switch",
     "some springs act in one direction only, or there are strings", "no spring or link switches",
     [](const SceneFacts& f, const Scene&) { return f.one_sided || f.strings; }},
    {Part::kDrives, "drives", "driven bodies", "bodies with a prescribed motion", "some bodies are driven",
     "no body is driven", [](const SceneFacts& f, const Scene&) { return f.drives; }},
    {Part::kJoints, "links", "links", "linear equations for the forces of rods, strings, pins and welds",
     "the scene has links", "there are no links", [](const SceneFacts& f, const Scene&) { return f.joints; },
     true},
    // With e = 1 and no relative acceleration every impact separates its pair for good; with e < 1 several
    // bodies can collapse onto one another.
    {Part::kRestingContacts, "resting_contacts", "lasting contacts",
     "a contact search and a solver of contact forces in each step", "something can press bodies together",
     "nothing keeps bodies pressed together",
     [](const SceneFacts& f, const Scene& scene) {
       return can_collide(f) && (accelerate_apart(f, scene) || f.yield);
     }},
}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < kPartCount; ++i) {
    if (kEntries[i].needed == nullptr || static_cast<std::size_t>(kEntries[i].part) != i) return false;
  }
  return true;
}
static_assert(in_order(), "each part has its entry, in the order of Part");

}  // namespace

std::span<const PartEntry> part_entries() { return kEntries; }

Needs needs_of(const Scene& scene) {
  const SceneFacts facts = facts_of(scene);
  Needs needs;
  for (const PartEntry& entry : kEntries) needs.set(entry.part, entry.needed(facts, scene));
  return needs;
}

Needs all_needs() {
  Needs needs;
  for (const PartEntry& entry : kEntries) needs.set(entry.part);
  needs.untrimmed = true;
  return needs;
}

NeedsText text_of(const Needs& needs, const Scene& scene, ContactsId contacts) {
  const SceneFacts f = facts_of(scene);
  NeedsText text;
  if (can_collide(f)) text.modelled.emplace_back("normal impulses");
  if (f.moving > 0 && !scene.forces.gravity.isZero(0.0)) text.modelled.emplace_back("gravity");
  for (const PartEntry& entry : kEntries) {
    std::string noun(entry.noun);
    const bool in = needs.has(entry.part);
    if (in && entry.part == Part::kRestingContacts && contacts == ContactsId::kImpulse)
      noun += " (as repeated impacts)";
    (in ? text.modelled : text.not_needed).push_back(std::move(noun));
  }
  return text;
}

}  // namespace carom
