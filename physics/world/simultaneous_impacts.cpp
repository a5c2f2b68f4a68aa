#include <algorithm>

#include "physics/collision/pair_contact.h"
#include "physics/world/simulation.h"

// Impacts of all bodies that touch at one time.
namespace carom {

// Puts the contacts of two bodies at `time` on the list, if they touch.
void Simulation::touching(int a, int b, double time) {
  if (a > b) std::swap(a, b);
  if (!shapes().can_meet(a, b)) return;
  const Eigen::Vector3d qa = tracks_.at(a, time).head<3>();
  const Eigen::Vector3d qb = tracks_.at(b, time).head<3>();
  const double tolerance = touch_tolerance(a, b, time);
  if (shapes().is_disc(a) || shapes().is_disc(b)) {
    const Contact contact = contact_between(shapes(), a, qa, b, qb);
    if (contact.gap <= tolerance) touches_.push_back({a, b, contact});
    return;
  }
  const Manifold ends = manifold(shapes().shapes, a, pose_of(shapes().shapes, a, qa), b,
                                 pose_of(shapes().shapes, b, qb), tolerance);
  for (int k = 0; k < ends.count; ++k)
    touches_.push_back({a, b, {ends.points[k].gap, ends.normal, ends.points[k].point}});
}

bool Simulation::meet_all(int a, int b, double time, double horizon, bool crowd, double h) {
  // Outwards from the pair, over bodies that move.
  touches_.clear();
  cluster_.assign({a, b});
  for (std::size_t k = 0; k < cluster_.size(); ++k) {
    const int body = cluster_[k];
    if (immovable(body)) continue;
    grid_.each_near(body, [&](int other) {
      const auto known = std::find(cluster_.begin(), cluster_.end(), other);
      // Pairs of which the other one has been looked at are there already.
      if (known < cluster_.begin() + static_cast<std::ptrdiff_t>(k) && !immovable(other)) return;
      const std::size_t before = touches_.size();
      touching(body, other, time);
      if (touches_.size() > before && known == cluster_.end()) cluster_.push_back(other);
    });
  }
  if (touches_.size() < 2) return false;
  std::sort(touches_.begin(), touches_.end(),
            [](const Touch& x, const Touch& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });

  std::vector<int> islands;
  for (const int i : cluster_) {
    const int island = tracks_.island_of(i);
    if (island < 0 || std::find(islands.begin(), islands.end(), island) != islands.end()) continue;
    islands.push_back(island);
  }
  std::sort(islands.begin(), islands.end());
  for (const int island : islands) {
    if (tracks_.start(tracks_.members(island).front()) != time) tracks_.settle(island, time);
  }

  const auto n = static_cast<Eigen::Index>(cluster_.size());
  Eigen::Matrix3Xd velocities(3, n);
  Eigen::VectorXd inverse_mass(n);
  Eigen::VectorXd inverse_inertia(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const int i = cluster_[static_cast<std::size_t>(k)];
    velocities.col(k) = tracks_.settled(i).segment<3>(3);
    inverse_mass[k] = mass().inverse_mass[i];
    inverse_inertia[k] = mass().inverse_inertia[i];
  }
  const auto column = [&](int i) {
    return static_cast<int>(std::find(cluster_.begin(), cluster_.end(), i) - cluster_.begin());
  };
  std::vector<ClusterContact> contacts;
  std::vector<double> closing;
  for (const Touch& t : touches_) {
    const Material& material = material_between(t.a, t.b);
    contacts.push_back(
        {column(t.a), column(t.b), t.contact.normal, t.contact.point - tracks_.settled(t.a).head<2>(),
         t.contact.point - tracks_.settled(t.b).head<2>(), material.restitution, material.kinetic_friction});
    closing.push_back(
        -relative_velocity(side(t.a, t.contact, 1.0), side(t.b, t.contact, -1.0), t.contact.normal).normal);
  }
  std::vector<Impact> impacts(contacts.size());
  const bool watched = watches_more();
  Jump jump;
  if (watched) jump.before = state_at(time);
  Ledger booked = ledger_;
  const ClusterOutcome outcome =
      resolve_simultaneous(velocities, inverse_mass, inverse_inertia, contacts, impacts, cluster_scratch_);
  if (!outcome.solved) {
    if (notices_.cluster_unsolved_since < 0.0) notices_.cluster_unsolved_since = tracks_.epoch() + time;
    return false;
  }
  // Closing speeds may be so small that the solution rounds to nothing; pair by pair they still come to an end.
  if (std::none_of(impacts.begin(), impacts.end(), [](const Impact& i) { return i.normal > 0.0; }))
    return false;
  if (outcome.lowered && notices_.restitution_lowered_since < 0.0)
    notices_.restitution_lowered_since = tracks_.epoch() + time;
  for (Eigen::Index k = 0; k < n; ++k) {
    const int i = cluster_[static_cast<std::size_t>(k)];
    if (!immovable(i)) tracks_.set_velocity(i, velocities.col(k).head<2>(), velocities(2, k));
  }
  for (const int island : islands) {
    if (field().has_switching_springs()) ledger_.lost_to_dampers += tracks_.recheck_switches(island);
  }
  // One jump for each entry of the log: the first one has all of the motion.
  if (watched) jump.after = state_at(time);
  jump.time = std::min(tracks_.epoch() + time, step_end_);
  for (std::size_t k = 0; k < touches_.size(); ++k) {
    const Touch& t = touches_[k];
    if (!(impacts[k].normal > 0.0)) continue;
    book(t.a, t.b, t.contact, impacts[k], closing[k], time);
    if (!watched || !watches_more()) continue;
    jump.change = ledger_;
    jump.change.add(-1.0, booked);
    booked = ledger_;
    jumps_.push_back(jump);
    jump.before = jump.after;
  }
  for (std::size_t k = 0; k < touches_.size(); ++k) {
    const Touch& t = touches_[k];
    if (impacts[k].normal > 0.0) judge(t.a, t.b, t.contact, material_between(t.a, t.b), time, crowd, h);
  }
  last_impact_ = time;
  go_on(islands, horizon);
  return true;
}

}  // namespace carom
