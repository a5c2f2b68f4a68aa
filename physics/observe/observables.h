#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "physics/dynamics/state.h"
#include "physics/model/geometry.h"
#include "physics/model/mass.h"
#include "physics/observe/impact_tally.h"
#include "physics/world/contact_force.h"
#include "physics/world/ledger.h"
#include "physics/world/totals.h"

namespace carom {

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
