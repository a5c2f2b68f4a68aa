#include "physics/record/frame.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "physics/math/vectors.h"
#include "physics/model/bodies_by_name.h"
#include "physics/record/replay.h"

namespace carom {
namespace {

std::vector<JointState> joint_states(const Simulation& simulation) {
  const std::vector<Joint> joints = simulation.joints();
  std::vector<JointState> states;
  if (joints.empty()) return states;
  const auto index = bodies_by_name(simulation.bodies());
  const auto now = [&](BodyIndex i) { return Eigen::Vector3d(simulation.state().q.col(i)); };
  const auto at_start = [&](BodyIndex i) {
    return Eigen::Vector3d(q_of(initial_motion(simulation.bodies()[static_cast<std::size_t>(i)])));
  };
  const auto end = [](const Eigen::Vector3d& q, const Vec2& own) {
    return Vec2(q.head<2>() + turned_by(q[2], own));
  };
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& joint = joints[i];
    const BodyIndex body = index.at(joint.body);
    const BodyIndex other = joint.to.empty() ? kNoBody : index.at(joint.to);
    JointState& s = states.emplace_back();
    s.kind = joint.kind;
    s.from = other < 0 ? joint.anchor : end(now(other), joint.anchor);
    s.to = end(now(body), joint.point);
    s.in_plane = other < 0;
    const Vec2 start = other < 0 ? joint.anchor : end(at_start(other), joint.anchor);
    s.length = joint.length.value_or((end(at_start(body), joint.point) - start).norm());
    s.taut = joint.kind != JointKind::kString || simulation.is_taut(JointIndex{static_cast<int>(i)});
  }
  return states;
}

std::optional<HandState> hand_state(const Simulation& simulation) {
  const auto& hand = simulation.model()->forces.hand;
  if (!hand) return std::nullopt;
  const State& state = simulation.state();
  const Vec2 arm = turned_by(state.q.col(hand->body)[2], hand->grip);
  const Vec2 grip = state.position(hand->body) + arm;
  const Vec2 velocity = state.velocity(hand->body) + state.v.col(hand->body)[2] * crossed(arm);
  const ForceField& field = simulation.field();
  return HandState{grip, field.hand_place(), field.pull_of_hand(grip, velocity)};
}

// Consecutive rows of the same curves become one table.
void append(Rows rows, std::vector<Rows>& all) {
  if (all.empty() || all.back().curves != rows.curves || rows.from_the_start || rows.back_to) {
    all.push_back(std::move(rows));
    return;
  }
  Rows& to = all.back();
  to.times.insert(to.times.end(), rows.times.begin(), rows.times.end());
  to.values.insert(to.values.end(), rows.values.begin(), rows.values.end());
  to.moments.insert(to.moments.end(), rows.moments.begin(), rows.moments.end());
}

}  // namespace

void take_moment(const Simulation& simulation, Frame& frame) {
  frame.time = simulation.time();
  frame.bodies = {simulation.compiled(), &simulation.compiled()->scene.bodies};
  frame.forces = {simulation.compiled(), &simulation.compiled()->scene.forces};
  frame.method = simulation.method();
  frame.steps = simulation.steps();
  frame.impact_count = simulation.impact_count();
  frame.evaluations = simulation.evaluations();
  frame.rejected_steps = simulation.rejected_steps();
  frame.state = simulation.state();
  frame.joints = joint_states(simulation);
  frame.hand = hand_state(simulation);
  frame.contacts = simulation.contact_forces();
  frame.totals = simulation.totals();
  frame.ledger = simulation.ledger();
  frame.status = simulation.status();
  frame.brief = simulation.notices_brief();
  frame.lost.reset();
  if (const auto& lost = simulation.lost()) frame.lost = lost->text(simulation.bodies(), simulation.time());
}

void take_up(Frame& earlier, Frame& frame) {
  std::swap(frame.rows, earlier.rows);
  for (Rows& rows : earlier.rows) append(std::move(rows), frame.rows);
  if (frame.back_to) {
    const double time = *frame.back_to;
    std::erase_if(earlier.impacts, [time](const ImpactRecord& impact) { return impact.time > time; });
    std::erase_if(earlier.met, [time](const MetStop& met) { return met.time > time; });
  }
  if (earlier.back_to) frame.back_to = std::min(*earlier.back_to, frame.back_to.value_or(*earlier.back_to));
  std::swap(frame.impacts, earlier.impacts);
  frame.impacts.insert(frame.impacts.end(), earlier.impacts.begin(), earlier.impacts.end());
  if (earlier.stops == frame.stops) frame.met.insert(frame.met.begin(), earlier.met.begin(), earlier.met.end());
}

void keep_recent(std::vector<ImpactRecord>& impacts, std::span<const ImpactRecord> fresh, double now,
                 double span) {
  std::erase_if(impacts, [&](const ImpactRecord& i) { return i.time > now || now - i.time >= span; });
  const std::size_t added = std::min(fresh.size(), kMostRecent);
  if (impacts.size() + added > kMostRecent) {
    const std::size_t surplus = impacts.size() + added - kMostRecent;
    impacts.erase(impacts.begin(), impacts.begin() + static_cast<std::ptrdiff_t>(surplus));
  }
  impacts.insert(impacts.end(), fresh.end() - static_cast<std::ptrdiff_t>(added), fresh.end());
}

namespace {

// The replay of one run through the moments.
class MomentReplay {
 public:
  MomentReplay(const RunSetup& setup, double span) : replay_(setup), span_(span) {}

  bool go_to(double time, Frame& frame, const std::function<bool(double)>& go_on) {
    const Simulation& simulation = replay_.simulation();
    bool cancelled = false;
    replay_.go_through([](const RunEdit&) {},
                       [&](const Simulation& s) {
                         if (s.lost() || s.next_step(time) < s.next_step()) return false;
                         cancelled = !go_on(s.time());
                         return !cancelled;
                       },
                       [&](const Simulation& s) { keep_recent(impacts_, s.last_impacts(), s.time(), span_); });
    if (cancelled) return false;
    frame.impacts = impacts_;
    const double left = simulation.next_step(time);
    if (simulation.lost() || left == 0.0) {
      take(simulation, frame);
      return true;
    }
    Simulation between = simulation;
    between.step(left);
    keep_recent(frame.impacts, between.last_impacts(), between.time(), span_);
    take(between, frame);
    return true;
  }

 private:
  void take(const Simulation& simulation, Frame& frame) {
    frame.run = 1;
    take_moment(simulation, frame);
  }

  Replay replay_;
  std::vector<ImpactRecord> impacts_;
  double span_;
};

}  // namespace

bool visit_moments(std::span<const RunSetup> runs, std::span<const double> times, double span,
                   const std::function<bool(std::span<const Frame>)>& show,
                   const std::function<bool(double time)>& go_on) {
  std::vector<MomentReplay> replays;
  for (const RunSetup& setup : runs) replays.emplace_back(setup, span);
  std::vector<Frame> frames(runs.size());
  for (const double time : times) {
    for (std::size_t i = 0; i < replays.size(); ++i) {
      if (!replays[i].go_to(time, frames[i], go_on)) return false;
    }
    if (!show(frames)) return false;
  }
  return true;
}

}  // namespace carom
