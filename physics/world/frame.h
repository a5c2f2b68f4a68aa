#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "physics/world/simulation.h"

namespace carom {

// The scene's sums at one moment, for plots. The ledger's part is in J and N s since the start:
//   energy = initial - lost_to_restitution - lost_to_friction - lost_to_sticking - lost_in_flight + put_in +
//   drift.
struct Sample {
  double time = 0.0;  // s
  Totals totals;
  double lost_to_restitution = 0.0;
  double lost_to_friction = 0.0;
  double lost_to_sticking = 0.0;
  double lost_in_flight = 0.0;  // to drag, dampers, rolling resistance, and strings that jerked taut
  double put_in = 0.0;          // by drives, by the user and by the pseudo-spring
  double drift = 0.0;           // numerical
  Vec2 momentum_drift = Vec2::Zero();
};

// A link at one moment, in the world.
struct LinkState {
  LinkKind kind = LinkKind::kRod;
  Vec2 from = Vec2::Zero();  // m, its end on the other body or in the plane
  Vec2 to = Vec2::Zero();    // m, its end on its body
  bool in_plane = false;     // from is a point of the plane
  double length = 0.0;       // m, of a rod or a string
  bool taut = true;          // false: a string that hangs slack
};

// A moment of a run, whole, as the simulation's thread publishes it: what is now, and what happened since the
// frame before. Nothing in it changes after it was published.
struct Frame {
  std::uint64_t run = 0;  // counts loads and restarts: samples of different runs don't belong together
  double time = 0.0;
  std::int64_t steps = 0;
  std::int64_t impact_count = 0;
  std::int64_t evaluations = 0;
  std::int64_t rejected_steps = 0;
  State state;
  std::shared_ptr<const std::vector<Body>> bodies;
  std::shared_ptr<const Forces> forces;
  std::vector<LinkState> links;
  std::vector<ContactForce> contacts;  // of the last step; empty where contacts don't last
  Totals totals;
  Ledger ledger;
  std::string status = "ok";
  bool playing = false;
  double realised_speed = 0.0;  // simulated seconds per second, while playing
  std::vector<Sample> samples;  // since the frame before: each step's end, and before and after each impact
  std::vector<ImpactRecord> impacts;  // since the frame before
  bool complete = true;               // false: nobody took a frame for so long that these two were thinned
};

[[nodiscard]] Sample sample_of(const Simulation& simulation);

// Fills in all that the simulation itself knows: not the run, its status of playing, nor what happened before.
void take_moment(const Simulation& simulation, Frame& frame);

// Appends what the last step of a simulation has to show on a plot: jumps at its watched impacts, then its end.
// What flight takes, and the drift, are known at the step's end only: its impacts show the values of then.
void append_samples(const Simulation& simulation, std::vector<Sample>& samples);

}  // namespace carom
