#include "physics/world/frame.h"

#include <string_view>
#include <unordered_map>

#include "physics/motion/link_geometry.h"

namespace carom {
namespace {

std::vector<LinkState> link_states(const Simulation& simulation) {
  const std::vector<Link>& links = simulation.links();
  std::vector<LinkState> states;
  if (links.empty()) return states;
  std::unordered_map<std::string_view, int> index;
  for (const Body& body : simulation.bodies()) index.emplace(body.name, static_cast<int>(index.size()));
  const auto now = [&](int i) { return Eigen::Vector3d(simulation.state().q.col(i)); };
  const auto at_start = [&](int i) {
    return Eigen::Vector3d(q_of(initial_motion(simulation.bodies()[static_cast<std::size_t>(i)])));
  };
  const auto end = [](const Eigen::Vector3d& q, const Vec2& own) {
    return Vec2(q.head<2>() + turned_by(q[2], own));
  };
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link& link = links[i];
    const int body = index.at(link.body);
    const int other = link.to.empty() ? -1 : index.at(link.to);
    LinkState& s = states.emplace_back();
    s.kind = link.kind;
    s.from = other < 0 ? link.anchor : end(now(other), link.anchor);
    s.to = end(now(body), link.point);
    s.in_plane = other < 0;
    const Vec2 start = other < 0 ? link.anchor : end(at_start(other), link.anchor);
    s.length = link.length.value_or((end(at_start(body), link.point) - start).norm());
    s.taut = link.kind != LinkKind::kString || simulation.is_taut(static_cast<int>(i));
  }
  return states;
}

}  // namespace

Sample sample_of(const Simulation& simulation) {
  const Ledger ledger = simulation.ledger();
  Sample s;
  s.time = simulation.time();
  s.totals = simulation.totals();
  s.lost_to_restitution = ledger.lost_to_restitution;
  s.lost_to_friction = ledger.lost_to_friction;
  s.lost_to_sticking = ledger.lost_to_sticking;
  s.lost_in_flight =
      ledger.lost_to_drag + ledger.lost_to_dampers + ledger.lost_to_rolling + ledger.lost_to_links;
  s.put_in = ledger.put_in_by_drives + ledger.put_in_by_user + ledger.overlap_correction;
  s.drift = ledger.numerical_drift(s.totals.energy());
  s.momentum_drift = ledger.momentum_drift(s.totals.momentum);
  return s;
}

void take_moment(const Simulation& simulation, Frame& frame) {
  frame.time = simulation.time();
  frame.steps = simulation.steps();
  frame.impact_count = simulation.impact_count();
  frame.evaluations = simulation.evaluations();
  frame.rejected_steps = simulation.rejected_steps();
  frame.state = simulation.state();
  frame.links = link_states(simulation);
  frame.contacts = simulation.contact_forces();
  frame.totals = simulation.totals();
  frame.ledger = simulation.ledger();
  frame.status = simulation.notices().text();
}

void append_samples(const Simulation& simulation, std::vector<Sample>& samples) {
  const Sample end = sample_of(simulation);
  // What was lost before the step, so that the sums grow impact by impact.
  Sample at = end;
  for (const ImpactRecord& impact : simulation.last_impacts()) {
    at.lost_to_restitution -= impact.lost_to_restitution;
    at.lost_to_friction -= impact.lost_to_friction;
    at.lost_to_sticking -= impact.lost_to_sticking;
  }
  // The jumps are those of the first impacts.
  const std::vector<Jump>& jumps = simulation.last_jumps();
  for (std::size_t i = 0; i < jumps.size(); ++i) {
    const ImpactRecord& impact = simulation.last_impacts()[i];
    at.time = jumps[i].time;
    at.totals = jumps[i].before;
    samples.push_back(at);
    at.lost_to_restitution += impact.lost_to_restitution;
    at.lost_to_friction += impact.lost_to_friction;
    at.lost_to_sticking += impact.lost_to_sticking;
    at.totals = jumps[i].after;
    samples.push_back(at);
  }
  samples.push_back(end);
}

}  // namespace carom
