#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "physics/dynamics/state.h"
#include "physics/ledger/impact_counts.h"
#include "physics/ledger/ledger.h"
#include "physics/ledger/totals.h"
#include "physics/model/geometry.h"
#include "physics/model/mass.h"
#include "physics/run/simulation.h"
#include "physics/step/contact_force.h"

namespace carom {

// Sums over the impacts of a run: call begin() once, then add() after each step. After a step with more
// impacts than its log has (kMostLogged) the sums are unknown, and the numbers from them are NaN from then
// on. So is the count of a pair that a saved run has not counted.
class ImpactTally {
 public:
  // Before begin(): also counts the impacts of this pair of bodies.
  void watch(BodyIndex a, BodyIndex b) { counts_.watch(a, b, 0); }
  [[nodiscard]] bool watches(BodyIndex a, BodyIndex b) const { return counts_.find(a, b) != nullptr; }
  // Starts from the counts of the run up to now.
  void begin(const Simulation& simulation);
  void add(const Simulation& simulation);
  // The same in parts: one impact, then the total number so far.
  void add(const ImpactRecord& impact, const MassProperties& mass) {
    counts_.add(impact.a, impact.b, impact.normal_impulse, mass);
  }
  void happened(std::int64_t impacts) { happened_ = impacts; }

  [[nodiscard]] double between(BodyIndex a, BodyIndex b) const;  // of a watched pair; otherwise NaN
  // With static and kinematic bodies, and of two free bodies.
  [[nodiscard]] double with_walls() const { return known(static_cast<double>(counts_.walls)); }
  [[nodiscard]] double mutual() const { return known(static_cast<double>(counts_.mutual)); }
  [[nodiscard]] double wall_impulse() const {
    return known(counts_.wall_impulse);
  }  // N s, sum of the normal impulses

 private:
  [[nodiscard]] double known(double value) const {
    return counts_.counted >= happened_ ? value : std::numeric_limits<double>::quiet_NaN();
  }

  ImpactCounts counts_;
  std::int64_t happened_ = 0;
};

// The reference of a run at the same moment.
struct ReferenceReading {
  const State& state;
  double energy;                           // J
  std::span<const std::uint8_t> awaiting;  // by body: an impact has happened in one of the two runs only
};

// The data of a run at one moment, from which observables are read.
struct Reading {
  const State& state;
  const ImpactTally& tally;
  double time;
  std::int64_t impacts;
  Totals totals;
  Ledger ledger;
  double energy_drift;            // J, numerical
  Vec2 momentum_drift;            // N s
  double angular_momentum_drift;  // kg m²/s
  const MassProperties& mass;
  const Geometry& shapes;
  const WeldedBodies& welded;
  std::span<const ContactForce> contacts;
  bool contacts_known;  // false: bodies may rest on each other, and the method has impulses only
  const ReferenceReading* reference = nullptr;  // none: errors are NaN
};

[[nodiscard]] Reading reading_of(const Simulation& simulation, const ImpactTally& tally);

// Topics of observables, for a menu.
enum class Topic { kBody, kPair, kEnergy, kMomentum, kLedger, kAllBodies, kRun, kError };

// A number read from a run at one moment, for expectations and plots.
struct Observable {
  std::string_view name;   // in files
  std::string_view label;  // for people
  std::string_view unit;
  int bodies;  // number of bodies it refers to
  Topic topic;
  double (*value)(const Reading& reading, std::span<const BodyIndex> bodies);

  // The error of a run against its reference: known at the ends of steps only.
  [[nodiscard]] bool is_error() const { return topic == Topic::kError; }
};

// All observables, each described in the table itself and in app/help/presets.md.
[[nodiscard]] std::span<const Observable> observables();

// Of two bodies, known only where contacts last or nothing can rest.
[[nodiscard]] bool is_contact_force(std::string_view observable);

// nullptr if there is none with that name.
[[nodiscard]] const Observable* find_observable(std::string_view name);

}  // namespace carom
