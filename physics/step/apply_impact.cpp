#include "physics/step/apply_impact.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "physics/impact/jointed_impact.h"
#include "physics/ledger/step_limits.h"
#include "physics/math/vectors.h"
#include "physics/step/face_impact.h"
#include "physics/step/jumps_of_moment.h"
#include "physics/step/moved_together.h"

namespace carom {
namespace {

// Welds two bodies that have stuck together. From then on they can't collide, and the islands are different.
Impact join(World& world, BodyIndex a, BodyIndex b, const Contact& contact) {
  const BodyIndex body = world.infinite_mass(a) ? b : a;
  const BodyIndex other = body == a ? b : a;
  const Eigen::Vector3d q = world.trajectories.at_start(body).head<3>();
  const Eigen::Vector3d q_other = world.trajectories.at_start(other).head<3>();
  const Weld weld{.body = body,
                  .other = other,
                  .point = turned_by(-q[2], contact.point - q.head<2>()),
                  .anchor = turned_by(-q_other[2], contact.point - q_other.head<2>()),
                  .angle = q[2] - q_other[2]};
  // The impact is completely plastic, and the two turn as one body after it: the effect of the weld on the
  // motions as they are.
  const auto [taken, impulse] = world.trajectories.add_weld(weld, world.trajectories.start(body));
  const Vec2 on_b = body == b ? impulse : Vec2(-impulse);
  Impact impact;
  impact.normal = on_b.dot(contact.normal);
  impact.tangential = on_b.dot(crossed(contact.normal));
  impact.lost_to_sticking = taken;
  return impact;
}

// For discs without spin, friction, joints or switches: see Model::smooth_discs. The closing speed is in m/s.
struct SmoothImpact {
  Vec2 velocity_a, velocity_b;
  const Vec2& normal;

  SmoothImpact(const World& world, BodyIndex a, BodyIndex b, const Contact& contact)
      : velocity_a(world.trajectories.at_start(a).segment<2>(3)),
        velocity_b(world.trajectories.at_start(b).segment<2>(3)),
        normal(contact.normal) {}
  static bool joins(const SurfaceLaw&) { return false; }
  static std::optional<FaceImpact> of_face(World&, BodyIndex, BodyIndex, const Contact&, const SurfaceLaw&) {
    return std::nullopt;
  }
  [[nodiscard]] double closing() const { return -Vec2(velocity_b - velocity_a).dot(normal); }
  Impact resolve(World& world, BodyIndex a, BodyIndex b, const Contact&, const SurfaceLaw& material,
                 const std::optional<FaceImpact>&) {
    const Eigen::VectorXd& inverse_mass = world.mass().inverse_mass;
    const Impact impact = resolve_smooth_impact(velocity_a, inverse_mass[a], velocity_b, inverse_mass[b],
                                                normal, material.restitution);
    if (!world.infinite_mass(a))
      world.trajectories.set_velocity(a, velocity_a, world.trajectories.at_start(a)[5]);
    if (!world.infinite_mass(b))
      world.trajectories.set_velocity(b, velocity_b, world.trajectories.at_start(b)[5]);
    return impact;
  }
};

// For any two bodies.
struct GeneralImpact {
  ImpactSide side_a, side_b;
  double closing_speed;

  GeneralImpact(const World& world, BodyIndex a, BodyIndex b, const Contact& contact)
      : side_a(world.side(a, contact, 1.0)),
        side_b(world.side(b, contact, -1.0)),
        closing_speed(-relative_velocity(side_a, side_b, contact.normal).normal) {}
  static bool joins(const SurfaceLaw& material) { return material.sticks; }
  static std::optional<FaceImpact> of_face(World& world, BodyIndex a, BodyIndex b, const Contact& contact,
                                           const SurfaceLaw& material) {
    return face_impact(world, a, b, contact, material);
  }
  [[nodiscard]] double closing() const { return closing_speed; }
  Impact resolve(World& world, BodyIndex a, BodyIndex b, const Contact& contact, const SurfaceLaw& material,
                 const std::optional<FaceImpact>& face) {
    Trajectories& trajectories = world.trajectories;
    const ImpactLawId law = world.model->impact_law;
    Impact impact;
    if (joins(material)) {
      impact = join(world, a, b, contact);
    } else if (face && face->impact && apply_face_impulse(world, a, b, contact, *face->impact)) {
      impact = *face->impact;
    } else if (trajectories.is_jointed(a) || trajectories.is_jointed(b)) {
      impact = resolve_jointed_impact(trajectories, world.mass(), a, b, contact, material, law);
    } else {
      impact = resolve_impact(side_a, side_b, contact.normal, material, law);
      if (!world.infinite_mass(a)) trajectories.set_velocity(a, side_a.velocity, side_a.spin);
      if (!world.infinite_mass(b)) trajectories.set_velocity(b, side_b.velocity, side_b.spin);
    }
    if (world.field().has_switching_springs()) {
      for (const BodyIndex i : {a, b}) {
        if (world.infinite_mass(i)) continue;
        world.sums.ledger.lost_to_dampers += trajectories.recheck_switches(trajectories.island_of(i));
      }
    }
    return impact;
  }
};

// Whatever the closing speed.
template <class Kind>
ImpactEffect resolve_and_record(World& world, BodyIndex a, BodyIndex b, const Contact& contact,
                                const SurfaceLaw& material, double within, Kind& of_pair,
                                const std::optional<FaceImpact>& face) {
  JumpsOfMoment jumps(world, within);
  const double closing = std::max(0.0, of_pair.closing());
  const Impact impact = of_pair.resolve(world, a, b, contact, material, face);
  const ImpactEffect effect = Kind::joins(material) ? ImpactEffect::kJoined : ImpactEffect::kBounced;
  record_impact(world, a, b, contact, impact, closing, within);
  if (effect == ImpactEffect::kBounced) record_impulse(world, a, b, contact, impact);
  jumps.add(world);
  return effect;
}

template <class Kind>
ImpactEffect apply(World& world, BodyIndex a, BodyIndex b, const Contact& at, const SurfaceLaw& material,
                   double within) {
  Contact contact = at;
  if (Kind::joins(material)) {
    if (!(Kind(world, a, b, at).closing() > 0.0)) return ImpactEffect::kNone;
    contact = moved_together(world, a, b, at);
  }
  const std::optional<FaceImpact> face = Kind::of_face(world, a, b, contact, material);
  if (face) contact.point = face->point;
  Kind of_pair(world, a, b, contact);
  // Semi-implicit Euler's path x + t v(t) may close again, from a penetration, while v(t) still separates the
  // bodies.
  if (!(of_pair.closing() > 0.0)) return ImpactEffect::kNone;
  return resolve_and_record(world, a, b, contact, material, within, of_pair, face);
}

}  // namespace

ApplyImpact apply_impact_of(const Model& model) {
  return model.smooth_discs ? &apply<SmoothImpact> : &apply<GeneralImpact>;
}

void join_at_rest(World& world, BodyIndex a, BodyIndex b, const Contact& contact) {
  GeneralImpact of_pair(world, a, b, contact);
  resolve_and_record(world, a, b, contact, world.material(contact, a, b), 0.0, of_pair, std::nullopt);
}

void record_impact(World& world, BodyIndex a, BodyIndex b, const Contact& contact, const Impact& impact,
                   double closing, double within) {
  RunSums& sums = world.sums;
  // Where the slip turns round within the impact, friction may give energy: then restitution has taken less.
  const double given = std::max(0.0, -impact.lost_to_friction);
  const double lost_to_restitution = impact.lost_to_restitution - given;
  const double lost_to_friction = impact.lost_to_friction + given;
  ++sums.impact_count;
  sums.impact_counts.add(a, b, impact.normal, world.mass());
  ImpactRecord record;
  // The sum may round beyond the end.
  record.time = std::min(world.trajectories.epoch() + within, world.clock.step_end);
  record.a = a;
  record.b = b;
  record.point = contact.point;
  record.normal = contact.normal;
  record.closing_speed = closing;
  record.normal_impulse = impact.normal;
  record.tangential_impulse = impact.tangential;
  record.lost_to_restitution = lost_to_restitution;
  record.lost_to_friction = lost_to_friction;
  record.lost_to_sticking = impact.lost_to_sticking;
  if (world.log.records.size() < kMostLogged) {
    world.log.records.push_back(record);
  } else {
    world.note(&Notices::log_cut_since, record.time);
  }
  if (impact.energy_gain > 0.0) {
    world.note(&Notices::gained_since, record.time, {a, b});
    sums.notices.gained += impact.energy_gain;
  }
  Ledger& ledger = sums.ledger;
  ledger.lost_to_restitution += lost_to_restitution;
  ledger.lost_to_friction += lost_to_friction;
  ledger.lost_to_sticking += impact.lost_to_sticking;
}

void record_impulse(World& world, BodyIndex a, BodyIndex b, const Contact& contact, const Impact& impact) {
  Ledger& ledger = world.sums.ledger;
  const Vec2 j = impact.normal * contact.normal + impact.tangential * crossed(contact.normal);
  for (const auto& [body, sign] : {std::pair(a, -1.0), std::pair(b, 1.0)}) {
    const Vec2 arm = contact.point - world.trajectories.at_start(body).head<2>();
    world.record_angular_momentum(body, contact.point, arm, sign * j, 0.0);
  }
  if (world.infinite_mass(a)) {
    ledger.momentum_to_walls -= j;
    ledger.put_in_by_drives += j.dot(world.trajectories.at_start(a).segment<2>(3));
  }
  if (world.infinite_mass(b)) {
    ledger.momentum_to_walls += j;
    ledger.put_in_by_drives -= j.dot(world.trajectories.at_start(b).segment<2>(3));
  }
}

}  // namespace carom
