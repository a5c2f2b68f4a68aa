#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "physics/ledger/ledger.h"
#include "physics/model/needs.h"
#include "physics/scene/method.h"
#include "physics/scene/scene.h"

// The entries of the ledger, one line each: files, observables, tables and reports use these lists.
namespace carom {

struct EnergyEntry {
  enum class Kind { kInitial, kLoss, kCorrection, kInput };
  Kind kind;
  std::string_view key;    // in files, and as an observable
  std::string_view name;   // in tables
  std::string_view label;  // as an observable, for people
  std::string_view tip;
  double Ledger::*value;  // J
  // True if the entry stays 0 in every run of the scene; nullptr: it may change in any scene.
  bool (*idle)(const Scene& scene, ContactsId contacts, const Needs& needs);

  [[nodiscard]] constexpr double sign() const { return kind == Kind::kLoss ? -1.0 : 1.0; }
};

// Of the momentum, and of the angular momentum about the origin.
struct MomentumEntry {
  std::string_view key;            // in a saved state
  std::string_view angular_key;    // likewise, and as an observable
  std::string_view report_key;     // in a report, in the sections of the two
  std::string_view name;           // in tables
  std::string_view angular_label;  // as an observable, for people
  std::string_view tip;
  Vec2 Ledger::*value;      // N s
  double Ledger::*angular;  // kg m²/s
  double sign;              // in the sums
  bool (*idle)(const Scene& scene);
};

using Kind = EnergyEntry::Kind;

// In the order in which they are summed up.
inline constexpr auto kEnergyEntries = std::to_array<EnergyEntry>({
    {Kind::kInitial, "initial", "initial", "initial energy",
     "Kinetic and potential energy at the start of the run", &Ledger::initial, nullptr},
    {Kind::kLoss, "lost_to_restitution", "lost to restitution", "lost to restitution",
     "Taken by impacts with a restitution below 1: ½ μ (1 − e²) uₙ² each", &Ledger::lost_to_restitution,
     nullptr},
    {Kind::kLoss, "lost_to_friction", "lost to friction", "lost to friction",
     "Work of the tangential impulses of impacts and of friction where contacts last",
     &Ledger::lost_to_friction,
     [](const Scene&, ContactsId, const Needs& needs) { return !needs.has(Part::kFriction); }},
    {Kind::kLoss, "lost_to_rolling", "lost to rolling", "lost to rolling resistance",
     "Work of the moment that resists rolling at contacts that last", &Ledger::lost_to_rolling,
     [](const Scene& scene, ContactsId contacts, const Needs&) {
       return contacts != ContactsId::kLasting || !has_rolling_resistance(scene);
     }},
    {Kind::kLoss, "lost_to_sticking", "lost to sticking", "lost to sticking",
     "Taken by impacts after which the bodies stay joined", &Ledger::lost_to_sticking,
     [](const Scene& scene, ContactsId, const Needs&) { return !has_sticking_surface(scene); }},
    {Kind::kLoss, "lost_to_drag", "lost to drag", "lost to drag",
     "Work of linear and quadratic drag, integrated along with the motion", &Ledger::lost_to_drag,
     [](const Scene&, ContactsId, const Needs& needs) { return !needs.has(Part::kDrag); }},
    {Kind::kLoss, "lost_to_dampers", "lost to dampers", "lost to dampers",
     "Work of the dampers of springs, integrated along with the motion", &Ledger::lost_to_dampers,
     [](const Scene& scene, ContactsId, const Needs&) { return !has_dampers(scene); }},
    {Kind::kLoss, "lost_to_links", "lost to links", "lost as strings become taut",
     "Taken by the impulses of strings that become taut", &Ledger::lost_to_joints,
     [](const Scene& scene, ContactsId, const Needs&) { return !has_strings(scene); }},
    {Kind::kCorrection, "overlap_correction", "overlap correction", "put in by separating overlaps",
     "Change of potential energy where overlapping bodies were separated", &Ledger::penetration_correction,
     nullptr},
    {Kind::kInput, "put_in_by_drives", "put in by drives", "put in by drives and forces",
     "Work of driven bodies, of applied forces and torques, and of what keeps a point-like body spinning",
     &Ledger::put_in_by_drives,
     [](const Scene& scene, ContactsId, const Needs& needs) {
       return !needs.has(Part::kDrives) && !needs.has(Part::kAppliedForces) &&
              !has_springs_beside_points(scene);
     }},
    {Kind::kInput, "put_in_by_user", "put in by hand", "put in by hand",
     "Work of the hand, and energy of what was added or changed during the run", &Ledger::put_in_by_user,
     nullptr},
});

inline constexpr auto kMomentumEntries = std::to_array<MomentumEntry>({
    {"initial_momentum", "initial_angular_momentum", "initial", "initial", "initial angular momentum",
     "Momentum and angular momentum of all bodies that move freely at the start of the run",
     &Ledger::initial_momentum, &Ledger::initial_angular_momentum, 1.0, nullptr},
    {"momentum_from_gravity", "angular_momentum_from_gravity", "from_gravity", "from gravity",
     "angular momentum from gravity", "Given by uniform gravity: its force, or its torque, times the time",
     &Ledger::momentum_from_gravity, &Ledger::angular_momentum_from_gravity, 1.0,
     [](const Scene& scene) { return scene.forces.gravity.isZero(0.0); }},
    {"momentum_from_forces", "angular_momentum_from_forces", "from_forces", "from forces",
     "angular momentum from forces",
     "Given by drag, by springs and links to fixed points and driven bodies, by applied forces and torques, "
     "and "
     "by the hand",
     &Ledger::momentum_from_forces, &Ledger::angular_momentum_from_forces, 1.0,
     [](const Scene& scene) {
       return !has_force_on_each_body(scene) && scene.forces.springs.empty() && scene.joints.empty() &&
              scene.forces.applied.empty();
     }},
    {"momentum_from_user", "angular_momentum_from_user", "from_user", "from the user",
     "angular momentum from the user", "Of the bodies that were added during the run",
     &Ledger::momentum_from_user, &Ledger::angular_momentum_from_user, 1.0, nullptr},
    {"momentum_to_walls", "angular_momentum_to_walls", "to_walls", "to walls", "angular momentum to walls",
     "What impacts and contacts gave to fixed and driven bodies; it is subtracted", &Ledger::momentum_to_walls,
     &Ledger::angular_momentum_to_walls, -1.0,
     [](const Scene& scene) {
       return std::none_of(scene.bodies.begin(), scene.bodies.end(), has_infinite_mass);
     }},
});

}  // namespace carom
