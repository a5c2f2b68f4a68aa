#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/record/jump_moment.h"
#include "physics/record/sampler.h"
#include "physics/run/met_stop.h"
#include "physics/scene/stop.h"

namespace carom {

class Simulation;
struct KeyFrame;  // physics/record/replay.h

// A joint at one moment, in world coordinates.
struct JointState {
  JointKind kind = JointKind::kRod;
  Vec2 from = Vec2::Zero();  // m, its end on the other body or in the plane
  Vec2 to = Vec2::Zero();    // m, its end on its body
  bool in_plane = false;     // from is a point of the plane
  double length = 0.0;       // m, of a rod or a string
  bool taut = true;          // false: a slack string
};

// A hand at one moment.
struct HandState {
  Vec2 grip = Vec2::Zero();   // m, where it holds its body
  Vec2 place = Vec2::Zero();  // m, where it is
  Vec2 force = Vec2::Zero();  // N, on the body
};

// Playing, or a single step, has ended where a stop was met: in the last step of the run, or at its end.
struct Halt {
  std::uint64_t number = 0;  // each has another one
  MetStop at;
};

// A complete moment of a run, as the simulation's thread publishes it: the present state, and the changes
// since the previous frame. Constant once published.
struct Frame {
  std::uint64_t run = 0;  // number of loads and restarts: rows of different runs don't belong together
  double time = 0.0;
  std::int64_t steps = 0;
  std::int64_t impact_count = 0;
  std::int64_t evaluations = 0;
  std::int64_t rejected_steps = 0;
  State state;
  std::shared_ptr<const std::vector<Body>> bodies;
  std::shared_ptr<const Forces> forces;
  std::vector<JointState> joints;
  std::optional<HandState> hand;
  std::vector<ContactForce> contacts;  // of the last step; empty without resting contacts
  Totals totals;
  Ledger ledger;
  std::string status = "ok";  // the run's notices, with why it can't continue
  std::string brief;          // the notices in a few words each
  std::optional<std::string>
      lost;  // why the run can't continue, if so: it stays at the end of its last good step
  // s: the runs are on their way there again, after an edit was undone or redone.
  std::optional<double> replay_until;
  bool playing = false;
  double realised_speed = 0.0;    // simulated seconds per second, while playing
  bool slow = false;              // playing slower than chosen, near an impact
  Method method;                  // in force
  double wall_time = 0.0;         // s, spent on its steps
  std::optional<RunError> error;  // if the run is compared with a reference
  // Since the previous frame: of the recorded curves, and of curves requested later, from the start on.
  std::vector<Rows> rows;
  double rows_known_until = 0.0;      // s: the latter are known up to here; the frame's time if there are none
  std::vector<ImpactRecord> impacts;  // since the previous frame
  bool impacts_of_late = false;       // or else all of late, whatever the previous frame was
  // s: the run has gone back there since, and earlier impacts after it are to be dropped.
  std::optional<double> back_to;
  // Of the first run: the stops that it watches, another object whenever they begin to be looked for anew, and
  // where it met them since the previous frame. As impacts, those after back_to are to be dropped.
  std::shared_ptr<const std::vector<Stop>> stops;
  std::vector<MetStop> met;
  std::optional<Halt> halt;  // of the first run, until it is played on
  // The last moment with impacts whose jumps are known; of a moment of the past all those of its last step.
  std::vector<std::shared_ptr<const JumpMoment>> jumps;
  Scales scales;
  std::shared_ptr<const RunSetup> setup;  // of the run, with all its edits
  // scene_now() of the first run while it is paused, for edits from here on; else none.
  std::shared_ptr<const Scene> scene;
  std::vector<std::shared_ptr<const KeyFrame>> key_frames;
};

// Fills in everything that the simulation itself knows: not the run, the playing status or earlier rows.
void take_moment(const Simulation& simulation, Frame& frame);

// Puts the changes of an earlier frame of the same run, which nobody has taken, before those of `frame`.
void take_up(Frame& earlier, Frame& frame);

// Keeps the newest impacts of a run for display: a resting heap makes thousands a second, of which the newest
// kMostRecent are enough. Removes those `span` s or more before `now`, and any after it; then adds the fresh
// ones.
inline constexpr std::size_t kMostRecent = 1000;
void keep_recent(std::vector<ImpactRecord>& impacts, std::span<const ImpactRecord> fresh, double now,
                 double span);

// Replays runs side by side and shows them at `times` (s, ascending), which may lie beyond their ends. A time
// between two steps is reached by one shorter step of a copy, so the run itself is unchanged. The frames, one
// for each run, have no rows; their impacts are those of the last `span` s. Before each step `go_on` gets the
// time reached. If `show` or `go_on` returns false, the replay ends and returns false.
[[nodiscard]] bool visit_moments(std::span<const RunSetup> runs, std::span<const double> times, double span,
                                 const std::function<bool(std::span<const Frame>)>& show,
                                 const std::function<bool(double time)>& go_on);

}  // namespace carom
