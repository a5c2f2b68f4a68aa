#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "physics/dynamics/state.h"
#include "physics/model/geometry.h"
#include "physics/model/mass.h"
#include "physics/world/contact_force.h"
#include "physics/world/impact_counts.h"
#include "physics/world/ledger.h"
#include "physics/world/simulation.h"
#include "physics/world/totals.h"

namespace carom {

// What the impacts of a run add up to, from the moment begin() and fed after each of its steps. Where a step
// had more impacts than it logs (kMostLogged) the sums are not known, and the numbers that show
// them are NaN from there on; so is the number of a pair which a run that was saved on its way has not counted.
class ImpactTally {
 public:
  // Before begin(): counts the impacts of this pair of bodies too.
  void watch(int a, int b) { counts_.watch(a, b, 0); }
  [[nodiscard]] bool watches(int a, int b) const { return counts_.find(a, b) != nullptr; }
  // From what the run has counted up to now.
  void begin(const Simulation& simulation);
  void add(const Simulation& simulation);
  // The same piece by piece: one impact, and then how many there were so far.
  void add(const ImpactRecord& impact, const MassProperties& mass) {
    counts_.add(impact.a, impact.b, impact.normal_impulse, mass);
  }
  void happened(std::int64_t impacts) { happened_ = impacts; }

  [[nodiscard]] double between(int a, int b) const;  // of a watched pair; else NaN
  // With fixed and kinematic bodies, and of two free ones.
  [[nodiscard]] double with_walls() const { return known(static_cast<double>(counts_.walls)); }
  [[nodiscard]] double mutual() const { return known(static_cast<double>(counts_.mutual)); }
  [[nodiscard]] double wall_impulse() const {
    return known(counts_.wall_impulse);
  }  // N s, sum of the normal ones

 private:
  [[nodiscard]] double known(double value) const {
    return counts_.counted >= happened_ ? value : std::numeric_limits<double>::quiet_NaN();
  }

  ImpactCounts counts_;
  std::int64_t happened_ = 0;
};

// What a run is compared with, at the same moment.
struct ReferenceReading {
  const State& state;
  double energy;                           // J
  std::span<const std::uint8_t> awaiting;  // by body: an impact has happened in one of the two runs only
};

// What an observable is read off: a run at one moment.
struct Reading {
  const State& state;
  const ImpactTally& tally;
  double time;
  std::int64_t impacts;
  Totals totals;
  Ledger ledger;
  double energy_drift;  // J, numerical
  Vec2 momentum_drift;  // N s
  const MassProperties& mass;
  const Geometry& shapes;
  std::span<const ContactForce> contacts;
  const ReferenceReading* reference = nullptr;  // none: errors are NaN
};

[[nodiscard]] Reading reading_of(const Simulation& simulation, const ImpactTally& tally);

// What observables are about, for a menu of them.
enum class Topic { kBody, kPair, kEnergy, kMomentum, kLedger, kAllBodies, kRun, kError };

// What an expectation or a plot can be about: a number read off a run at one moment.
struct Observable {
  std::string_view name;   // in files
  std::string_view label;  // for people
  std::string_view unit;
  int bodies;  // how many bodies it is about
  Topic topic;
  double (*value)(const Reading& reading, std::span<const int> bodies);

  // Of a run beside its reference: known at the ends of steps only.
  [[nodiscard]] bool is_error() const { return topic == Topic::kError; }
};

// All observables, each described in the table itself and in app/help/presets.md.
[[nodiscard]] std::span<const Observable> observables();

// nullptr if there is none of that name.
[[nodiscard]] const Observable* find_observable(std::string_view name);

}  // namespace carom
