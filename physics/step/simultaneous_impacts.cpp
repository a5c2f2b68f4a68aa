#include <algorithm>
#include <utility>

#include "physics/collision/pair_contact.h"
#include "physics/step/apply_impact.h"
#include "physics/step/event_driven_impacts.h"
#include "physics/step/pair_motion.h"

// Impacts of all bodies that touch at one time.
namespace carom {
namespace {

// Relative to the sizes: points touch together if their gaps differ by less.
constexpr double kTogether = 1e-9;

// The islands of these bodies, in rising order.
std::vector<int> islands_of(const Trajectories& trajectories, const std::vector<int>& bodies) {
  std::vector<int> islands;
  for (const int i : bodies) {
    const int island = trajectories.island_of(i);
    if (island < 0 || std::find(islands.begin(), islands.end(), island) != islands.end()) continue;
    islands.push_back(island);
  }
  std::sort(islands.begin(), islands.end());
  return islands;
}

}  // namespace

// Puts the contacts of two bodies at `time` on the list, if they touch; near_ are the bodies near one of them.
void EventDrivenImpacts::find_touches(World& world, int a, int b, double time) {
  Trajectories& trajectories = world.trajectories;
  const Geometry& shapes = world.shapes();
  if (a > b) std::swap(a, b);
  if (!shapes.can_collide(a, b)) return;
  const Eigen::Vector3d qa = trajectories.at(a, time).head<3>();
  const Eigen::Vector3d qb = trajectories.at(b, time).head<3>();
  const double tolerance = touch_tolerance(world, a, b);
  if (!may_be_continued(world, a, b)) {
    const Contact contact = contact_between(shapes, a, qa, b, qb);
    if (contact.gap <= tolerance) touches_.push_back({a, b, contact});
    return;
  }
  const auto pose = [&](int i) {
    const double then = std::clamp(time, trajectories.start(i), trajectories.end(i));
    return shapes.pose(i, trajectories.at(i, then).head<3>());
  };
  // What is flush lands together.
  const double margin = tolerance + kTogether * (shapes.size[a] + shapes.size[b]);
  const std::size_t before = touches_.size();
  bool touch = false;
  each_manifold(shapes, a, shapes.pose(a, qa), b, shapes.pose(b, qb), margin, [&](const Manifold& ends) {
    for (int k = 0; k < ends.count; ++k) {
      const Contact contact = ends.contact(k);
      if (contact.gap > margin || on_internal_edge(world, a, b, contact, near_, pose)) continue;
      touch = touch || contact.gap <= tolerance;
      touches_.push_back({a, b, contact});
    }
  });
  if (!touch) touches_.resize(before);
}

// Outwards from the pair, over bodies that move.
void EventDrivenImpacts::find_cluster(World& world, int a, int b, double time) {
  touches_.clear();
  cluster_.assign({a, b});
  for (std::size_t k = 0; k < cluster_.size(); ++k) {
    const int body = cluster_[k];
    if (world.infinite_mass(body)) continue;
    near_.clear();
    grid_.each_near(body, [&](int other) { near_.push_back(other); });
    for (const int other : near_) {
      const auto known = std::find(cluster_.begin(), cluster_.end(), other);
      // Pairs of which the other one has been looked at are there already.
      if (known < cluster_.begin() + static_cast<std::ptrdiff_t>(k) && !world.infinite_mass(other)) continue;
      const std::size_t before = touches_.size();
      find_touches(world, body, other, time);
      if (touches_.size() > before && known == cluster_.end()) cluster_.push_back(other);
    }
  }
  std::sort(touches_.begin(), touches_.end(),
            [](const Touch& x, const Touch& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
}

std::optional<bool> EventDrivenImpacts::resolve_cluster(const Step& step, int a, int b, double time,
                                                        bool guarded) {
  World& world = step.world;
  Trajectories& trajectories = world.trajectories;
  find_cluster(world, a, b, time);
  if (touches_.size() < 2) return std::nullopt;
  const std::vector<int> islands = islands_of(trajectories, cluster_);
  for (const int island : islands) {
    if (trajectories.start(trajectories.members(island).front()) != time) trajectories.advance_to(island, time);
  }

  const auto n = static_cast<Eigen::Index>(cluster_.size());
  Eigen::Matrix3Xd velocities(3, n);
  Eigen::VectorXd inverse_mass(n);
  Eigen::VectorXd inverse_inertia(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const int i = cluster_[static_cast<std::size_t>(k)];
    velocities.col(k) = trajectories.at_start(i).segment<3>(3);
    inverse_mass[k] = world.mass().inverse_mass[i];
    inverse_inertia[k] = world.mass().inverse_inertia[i];
  }
  const auto column = [&](int i) {
    return static_cast<int>(std::find(cluster_.begin(), cluster_.end(), i) - cluster_.begin());
  };
  std::vector<ClusterContact> contacts;
  std::vector<double> closing;
  for (const Touch& t : touches_) {
    const Material& material = world.material(t.contact, t.a, t.b);
    contacts.push_back({column(t.a), column(t.b), t.contact.normal,
                        t.contact.point - trajectories.at_start(t.a).head<2>(),
                        t.contact.point - trajectories.at_start(t.b).head<2>(), material.restitution,
                        material.kinetic_friction});
    closing.push_back(-world.parting_speed(t.a, t.b, t.contact));
  }
  std::vector<Impact> impacts(contacts.size());
  const bool wants_jump = world.log.wants_jump(world.model->bodies().size());
  Jump jump;
  if (wants_jump) jump.before = world.state_at(time);
  Ledger& ledger = world.sums.ledger;
  Ledger recorded = ledger;
  const ClusterOutcome outcome =
      resolve_simultaneous(velocities, inverse_mass, inverse_inertia, contacts, impacts, cluster_scratch_);
  if (!outcome.solved) {
    world.note(&Notices::cluster_unsolved_since, trajectories.epoch() + time);
    return std::nullopt;
  }
  // Closing speeds may be so small that the solution rounds to nothing; pair by pair they still come to an end.
  if (std::none_of(impacts.begin(), impacts.end(), [](const Impact& i) { return i.normal > 0.0; }))
    return std::nullopt;
  if (outcome.lowered) world.note(&Notices::restitution_lowered_since, trajectories.epoch() + time);
  for (Eigen::Index k = 0; k < n; ++k) {
    const int i = cluster_[static_cast<std::size_t>(k)];
    if (!world.infinite_mass(i)) trajectories.set_velocity(i, velocities.col(k).head<2>(), velocities(2, k));
  }
  for (const int island : islands) {
    if (world.field().has_switching_springs()) ledger.lost_to_dampers += trajectories.recheck_switches(island);
  }
  // One jump for each entry of the log: the first one has all of the motion.
  if (wants_jump) jump.after = world.state_at(time);
  jump.time = std::min(trajectories.epoch() + time, world.clock.step_end);
  for (std::size_t k = 0; k < touches_.size(); ++k) {
    const Touch& t = touches_[k];
    if (!(impacts[k].normal > 0.0)) continue;
    record_impact(world, t.a, t.b, t.contact, impacts[k], closing[k], time);
    if (!wants_jump || !world.log.wants_jump(world.model->bodies().size())) continue;
    jump.change = ledger;
    jump.change.add(-1.0, recorded);
    recorded = ledger;
    world.log.jumps.push_back(jump);
    jump.before = jump.after;
  }
  bool divides = false;
  for (std::size_t k = 0; k < touches_.size(); ++k) {
    const Touch& t = touches_[k];
    if (!(impacts[k].normal > 0.0)) continue;
    divides |= classify_rebound(step, t.a, t.b, t.contact, world.material(t.contact, t.a, t.b), time, guarded);
  }
  last_impact_ = time;
  rebuild_and_search(step, islands);
  return divides;
}

}  // namespace carom
