#include "physics/world/simulation.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <tuple>

#include "physics/collision/time_of_impact.h"
#include "physics/motion/integrators.h"

namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

}  // namespace

std::string Notices::text() const {
  std::string line;
  if (resting_since >= 0.0) {
    line += fmt::format(
        "from t = {:.6g} s bounces come faster than they can be told apart (Zeno): such a contact is held by "
        "inelastic "
        "impacts at each step's end",
        resting_since);
  }
  if (impacts_capped_since >= 0.0) {
    if (!line.empty()) line += "; ";
    line +=
        fmt::format("at t = {:.6g} s a step had more than {} impacts: the rest of it was resolved at its end",
                    impacts_capped_since, Simulation::kMostImpactsPerStep);
  }
  return line.empty() ? "ok" : line;
}

Simulation::Simulation(const Scene& scene)
    : scene_(scene), method_(scene.method), bodies_(all_bodies(scene)), state_(initial_state(bodies_)) {
  lay_out();
  ledger_.initial = totals().energy();
}

void Simulation::lay_out() {
  mass_ = mass_properties(bodies_);
  shapes_ = geometry(bodies_);
  field_ = ForceField(scene_.forces, bodies_);

  std::vector<Material> materials = scene_.materials;
  const auto index_of = [&](const std::string& name) {
    for (std::size_t i = 0; i < materials.size(); ++i) {
      if (materials[i].name == name) return static_cast<int>(i);
    }
    materials.push_back(material_named(scene_, name));
    return static_cast<int>(materials.size()) - 1;
  };
  material_.clear();
  for (const Body& body : bodies_) material_.push_back(index_of(body.material));
  materials_ = static_cast<int>(materials.size());
  mixed_.clear();
  for (const Material& a : materials) {
    for (const Material& b : materials) mixed_.push_back(mixed(a, b));
  }

  const auto n = bodies_.size();
  bounds_.resize(n);
  local_time_.assign(n, 0.0);
  acceleration_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n));
  end_ = state_;
}

void Simulation::set_method(const Method& method) { method_ = method; }

void Simulation::add_body(const Body& body) {
  const double before = totals().energy();
  bodies_.push_back(body);
  const State one = initial_state({body});
  const int n = state_.size();
  state_.q.conservativeResize(Eigen::NoChange, n + 1);
  state_.v.conservativeResize(Eigen::NoChange, n + 1);
  state_.dissipated.conservativeResize(n + 1);
  state_.set_motion(n, one.motion(0));
  lay_out();
  ledger_.put_in_by_user += totals().energy() - before;
}

Ledger Simulation::ledger() const {
  Ledger ledger = ledger_;
  ledger.lost_to_drag = state_.dissipated.sum();
  return ledger;
}

const Material& Simulation::material_between(int a, int b) const {
  return mixed_[static_cast<std::size_t>(material_[a] * materials_ + material_[b])];
}

ImpactSide Simulation::side(int body, const Contact& contact, double towards) const {
  return {state_.velocity(body), state_.v(2, body), mass_.inverse_mass[body], mass_.inverse_inertia[body],
          towards * (contact.point - state_.position(body)).dot(contact.normal)};
}

void Simulation::step(double h) {
  if (h != origin_step_) {
    origin_ = time_;
    origin_step_ = h;
    steps_since_origin_ = 0;
  }
  ++steps_since_origin_;
  step_end_ = origin_ + static_cast<double>(steps_since_origin_) * h;
  impacts_.clear();
  deferred_.clear();
  if (method_.impacts == ImpactsId::kLocated) {
    step_with_located_impacts(h);
    resolve_at_end(deferred_, h);
  } else {
    fly(h);
    for (int i = 0; i < state_.size(); ++i) {
      const Eigen::Array2d x = state_.position(i).array();
      bounds_[i] = {x - shapes_.extent.col(i).array(), x + shapes_.extent.col(i).array()};
    }
    for (const auto& [a, b] : broad_phase_.pairs(bounds_, shapes_.fixed)) deferred_.push_back({a, b, false});
    resolve_at_end(deferred_, h);
  }

  time_ = step_end_;
  ++steps_;
}

void Simulation::fly(double h) {
  for (int i = 0; i < state_.size(); ++i) {
    if (shapes_.fixed[i] == 0) {
      state_.set_motion(i, integrator_step(method_.integrator, field_, i, state_.motion(i), h));
    }
  }
}

// --- impacts at the step's end
// --------------------------------------------------------------------------------------

void Simulation::resolve_at_end(const std::vector<Deferred>& pairs, double h) {
  for (const auto& [a, b, resting] : pairs) {
    const Contact contact = contact_between(shapes_, a, state_.q.col(a), b, state_.q.col(b));
    if (contact.gap >= 0.0) continue;

    const double u = relative_velocity(side(a, contact, 1.0), side(b, contact, -1.0), contact.normal).normal;
    if (u < 0.0) {
      Material material = material_between(a, b);
      // What gravity pressed in during this step must not bounce; a true impact on a resting pair must.
      if (resting && -u <= pressed_in(a, b, h)) material.restitution = 0.0;
      collide(a, b, contact, material, h);
    }

    const double share = mass_.inverse_mass[a] + mass_.inverse_mass[b];
    const Vec2 push = (resting ? 1.0 : kOverlapFraction) * -contact.gap / share * contact.normal;
    for (const int i : {a, b}) {
      const Vec2 x = state_.position(i);
      const Vec2 moved = x + (i == a ? -1.0 : 1.0) * mass_.inverse_mass[i] * push;
      ledger_.overlap_correction += field_.potential_energy(i, moved) - field_.potential_energy(i, x);
      state_.q.col(i).head<2>() = moved;
    }
  }
}

void Simulation::collide(int a, int b, const Contact& contact, const Material& material, double within) {
  ImpactSide side_a = side(a, contact, 1.0);
  ImpactSide side_b = side(b, contact, -1.0);
  ImpactRecord record;
  record.time = std::min(time_ + within, step_end_);  // the sum may round beyond the end
  record.a = a;
  record.b = b;
  record.point = contact.point;
  record.normal = contact.normal;
  record.closing_speed = -relative_velocity(side_a, side_b, contact.normal).normal;
  record.watched = watch_impacts_ && impacts_.size() < kMostWatched;
  if (record.watched) record.before = totals_at(within);

  const Impact impact = resolve_impact(side_a, side_b, contact.normal, material);
  state_.v.col(a) << side_a.velocity, side_a.spin;
  state_.v.col(b) << side_b.velocity, side_b.spin;

  record.normal_impulse = impact.normal;
  record.tangential_impulse = impact.tangential;
  record.lost_to_restitution = impact.lost_to_restitution;
  record.lost_to_friction = impact.lost_to_friction;
  if (record.watched) record.after = totals_at(within);
  ledger_.lost_to_restitution += impact.lost_to_restitution;
  ledger_.lost_to_friction += impact.lost_to_friction;
  const Vec2 tangent(-contact.normal.y(), contact.normal.x());
  const Vec2 j = impact.normal * contact.normal + impact.tangential * tangent;
  if (shapes_.fixed[a] != 0) ledger_.momentum_to_walls -= j;
  if (shapes_.fixed[b] != 0) ledger_.momentum_to_walls += j;
  ++impact_count_;
  impacts_.push_back(record);
}

// --- impacts at their own time
// --------------------------------------------------------------------------------------

Motion Simulation::motion_at(int body, double within) const {
  const double h = within - local_time_[body];
  if (shapes_.fixed[body] != 0 || h <= 0.0) return state_.motion(body);
  return integrator_step(method_.integrator, field_, body, state_.motion(body), h);
}

Totals Simulation::totals_at(double within) const {
  if (method_.impacts == ImpactsId::kStepEnd) return totals();
  State all = state_;
  for (int i = 0; i < all.size(); ++i) all.set_motion(i, motion_at(i, within));
  return carom::totals(all, mass_, field_);
}

// The rest of the step of one body if nothing meets it: where it ends, how far its path can stray from its
// chord, and the rectangle that holds both.
void Simulation::predict(int body, double h) {
  end_.set_motion(body, motion_at(body, h));
  acceleration_[body] = 0.0;
  if (!field_.is_free() && shapes_.fixed[body] == 0) {
    // Twice the larger of the accelerations at both ends: sub-steps of semi-implicit Euler bend by 2a, and
    // within a step that resolves the motion the acceleration varies by less than that.
    acceleration_[body] = 2.0 * std::max(field_.rate(body, state_.motion(body)).acceleration.norm(),
                                         field_.rate(body, end_.motion(body)).acceleration.norm());
  }
  const double left = h - local_time_[body];
  const Eigen::Array2d from = state_.position(body).array();
  const Eigen::Array2d to = end_.position(body).array();
  const Eigen::Array2d margin = shapes_.extent.col(body).array() + acceleration_[body] * left * left / 8.0 +
                                32.0 * kEpsilon * (from.abs() + to.abs());
  bounds_[body] = {from.min(to) - margin, from.max(to) + margin};
}

// m: below this a gap is closed within rounding.
double Simulation::touch_tolerance(int a, int b, double h) const {
  const double reach = state_.q.col(a).head<2>().lpNorm<1>() + state_.q.col(b).head<2>().lpNorm<1>() +
                       shapes_.extent.col(a).sum() + shapes_.extent.col(b).sum();
  return 16.0 * kEpsilon * (reach + (state_.velocity(a).norm() + state_.velocity(b).norm()) * h);
}

bool Simulation::pressed_together(int a, int b, const Vec2& normal) const {
  const Eigen::Vector3d relative =
      field_.rate(b, state_.motion(b)).acceleration - field_.rate(a, state_.motion(a)).acceleration;
  return normal.dot(relative.head<2>()) < 0.0;
}

double Simulation::pressed_in(int a, int b, double h) const {
  return (acceleration_[a] + acceleration_[b]) * h + kRestSpeed;
}

void Simulation::defer(int a, int b, bool resting, double within) {
  for (Deferred& d : deferred_) {
    if (d.a == a && d.b == b) {
      d.resting = d.resting || resting;
      return;
    }
  }
  deferred_.push_back({a, b, resting});
  if (resting && notices_.resting_since < 0.0) notices_.resting_since = time_ + within;
}

// Finds the next impact of a and b within the step, if there is one.
void Simulation::search(int a, int b, double h) {
  if (a > b) std::swap(a, b);
  const bool resting = std::any_of(deferred_.begin(), deferred_.end(),
                                   [&](const Deferred& d) { return d.a == a && d.b == b && d.resting; });
  double start = std::max(local_time_[a], local_time_[b]);
  const auto sample_of = [&](const Eigen::Vector3d& qa, const Eigen::Vector3d& qb) {
    const Contact c = contact_between(shapes_, a, qa, b, qb);
    return GapSample{c.gap, c.normal, (qb - qa).head<2>()};
  };
  const auto sample = [&](double t) { return sample_of(motion_at(a, t).q, motion_at(b, t).q); };

  const double tolerance = touch_tolerance(a, b, h);
  const double curvature = acceleration_[a] + acceleration_[b];
  GapSample first = sample(start);
  if (first.gap <= tolerance) {
    const Vec2 va = motion_at(a, start).v.head<2>();
    const Vec2 vb = motion_at(b, start).v.head<2>();
    const double u = first.normal.dot(vb - va);
    // A resting pair waits for the step's end, unless something drives it together.
    if (resting && -u <= pressed_in(a, b, h)) return;
    if (u < -16.0 * kEpsilon * (va.norm() + vb.norm())) {
      events_.push_back({start, a, b});
      return;
    }
    if (curvature == 0.0) {
      if (first.gap < -tolerance) defer(a, b, false, start);
      return;
    }
    // They part at speed u and cannot be back before 2u/curvature: search from the half of that on.
    start += std::max(u, 0.0) / curvature;
    if (start >= h) return;
    const bool touching = first.gap >= -tolerance;
    first = sample(start);
    if (first.gap <= tolerance) {
      defer(a, b, touching && pressed_together(a, b, first.normal), start);
      return;
    }
  }
  const GapSample last = sample_of(end_.q.col(a), end_.q.col(b));
  if (const auto time = first_contact(sample, start, first, h, last, curvature, tolerance)) {
    if (resting) {
      const Vec2 u = (motion_at(b, *time).v - motion_at(a, *time).v).head<2>();
      if (-sample(*time).normal.dot(u) <= pressed_in(a, b, h)) return;
    }
    events_.push_back({*time, a, b});
  }
}

void Simulation::step_with_located_impacts(double h) {
  const int n = state_.size();
  std::fill(local_time_.begin(), local_time_.end(), 0.0);
  for (int i = 0; i < n; ++i) predict(i, h);
  events_.clear();
  for (const auto& [a, b] : broad_phase_.pairs(bounds_, shapes_.fixed)) search(a, b, h);

  const int crowd = kCrowdedImpacts + kCrowdedImpactsPerBody * n;
  for (int count = 0; !events_.empty(); ++count) {
    if (count == kMostImpactsPerStep) {
      if (notices_.impacts_capped_since < 0.0) notices_.impacts_capped_since = time_ + events_.front().time;
      for (const Event& e : events_) defer(e.a, e.b, false, e.time);
      break;
    }
    const Event next = *std::min_element(events_.begin(), events_.end(), [](const Event& x, const Event& y) {
      return std::tie(x.time, x.a, x.b) < std::tie(y.time, y.a, y.b);
    });
    const auto [time, a, b] = next;
    const auto touched = [&](int i) { return shapes_.fixed[i] == 0 && (i == a || i == b); };
    for (const int i : {a, b}) {
      if (!touched(i)) continue;
      state_.set_motion(i, motion_at(i, time));
      local_time_[i] = time;
    }
    const Contact contact = contact_between(shapes_, a, state_.q.col(a), b, state_.q.col(b));
    const Material& material = material_between(a, b);
    collide(a, b, contact, material, time);

    const double rebound =
        relative_velocity(side(a, contact, 1.0), side(b, contact, -1.0), contact.normal).normal;
    // Zeno's bounces under a force, or, in a crowd, an inelastic collapse.
    const bool collapse = count >= crowd && rebound < pressed_in(a, b, h);
    const bool zeno = rebound < kRestSpeed && pressed_together(a, b, contact.normal);
    if (material.restitution < 1.0 && (zeno || collapse)) defer(a, b, true, time);

    std::erase_if(events_, [&](const Event& e) { return touched(e.a) || touched(e.b); });
    for (const int i : {a, b}) {
      if (touched(i)) predict(i, h);
    }
    search(a, b, h);
    for (const int i : {a, b}) {
      if (!touched(i)) continue;
      for (int k = 0; k < n; ++k) {
        if (k != a && k != b && bounds_[i].overlaps(bounds_[k])) search(i, k, h);
      }
    }
  }
  std::swap(state_, end_);
  std::fill(local_time_.begin(), local_time_.end(), h);  // all bodies are at the end now
}

}  // namespace carom
