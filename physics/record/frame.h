#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/record/replay.h"
#include "physics/record/sampler.h"
#include "physics/world/simulation.h"

namespace carom {

// A joint at one moment, in the world.
struct JointState {
  JointKind kind = JointKind::kRod;
  Vec2 from = Vec2::Zero();  // m, its end on the other body or in the plane
  Vec2 to = Vec2::Zero();    // m, its end on its body
  bool in_plane = false;     // from is a point of the plane
  double length = 0.0;       // m, of a rod or a string
  bool taut = true;          // false: a string that hangs slack
};

// A moment of a run, whole, as the simulation's thread publishes it: what is now, and what happened since the
// frame before. Nothing in it changes after it was published.
struct Frame {
  std::uint64_t run = 0;  // counts loads and restarts: rows of different runs don't belong together
  double time = 0.0;
  std::int64_t steps = 0;
  std::int64_t impact_count = 0;
  std::int64_t evaluations = 0;
  std::int64_t rejected_steps = 0;
  State state;
  std::shared_ptr<const std::vector<Body>> bodies;
  std::shared_ptr<const Forces> forces;
  std::vector<JointState> joints;
  std::vector<ContactForce> contacts;  // of the last step; empty where contacts don't last
  Totals totals;
  Ledger ledger;
  std::string status = "ok";
  std::optional<std::string>
      lost;  // why the run can't go on, if so: it stands at the end of its last good step
  // s: the first run goes through its past again, after an edit was taken back or put back, until here.
  std::optional<double> again;
  bool playing = false;
  double realised_speed = 0.0;    // simulated seconds per second, while playing
  Method method;                  // in force
  double wall_time = 0.0;         // s, that its steps have taken
  std::optional<RunError> error;  // of a run that is compared with a reference
  // Since the frame before: of the recorded curves, and of curves that were asked for later, from the start on.
  std::vector<Rows> rows;
  double rows_known_until = 0.0;      // s: so far the latter have come; the frame's time if there are none
  std::vector<ImpactRecord> impacts;  // since the frame before
  Scales scales;
  std::shared_ptr<const RunLog> log;  // of the run so far
  std::vector<std::shared_ptr<const KeyFrame>> key_frames;
};

// Fills in all that the simulation itself knows: not the run, its status of playing, nor what happened before.
void take_moment(const Simulation& simulation, Frame& frame);

// The newest impacts of a run, for showing: a resting heap makes thousands a second, of which the newest
// kMostRecent are enough. Forgets those of `span` s or more before `now`, and any after it; then adds the fresh
// ones.
inline constexpr std::size_t kMostRecent = 1000;
void keep_recent(std::vector<ImpactRecord>& impacts, std::span<const ImpactRecord> fresh, double now,
                 double span);

// Goes through runs once more, side by side, and shows them at `times` (s, ascending), on beyond where they
// were left if these lie there. A time between two steps is reached by one shorter step of a copy, of which the
// run knows nothing. The frames, one a run, have no rows; their impacts are the recent ones of the last `span`
// s. Before each step `go_on` is told the time that is reached. Where one of the two answers false the runs are
// left, and the answer is false.
[[nodiscard]] bool visit_moments(std::span<const RunLog> runs, std::span<const double> times, double span,
                                 const std::function<bool(std::span<const Frame>)>& show,
                                 const std::function<bool(double time)>& go_on);

}  // namespace carom
