#include "physics/world/simulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/impact/linked_impact.h"

namespace carom {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

}  // namespace

Simulation::Simulation(const RunSetup& setup, const Needs& needs)
    : Simulation(compile(setup.scene, needs, start_time(setup.saved)), setup.method) {
  if (setup.saved) go_on_from(*setup.saved);
  count_pairs(setup.counted_pairs);
}

Simulation::Simulation(std::shared_ptr<const Model> model, const Method& method)
    : model_(std::move(model)), method_(method), tracks_(model_, method_) {
  const double start = model_->start_time;
  tracks_.begin(start);
  // Seven digits of a file are not where links hold their ends within rounding.
  for (int k = 0; k < tracks_.islands(); ++k) tracks_.restore_links(k);
  lay_out();
  tracks_.begin(start);
  publish(0.0);
  peak_kinetic_ = kinetic_energy(state_, mass());
  time_ = step_end_ = origin_ = gravity_since_ = start;
  ledger_.initial = totals().energy();
  ledger_.initial_momentum = totals().momentum;
}

void Simulation::count_pairs(const std::vector<std::pair<std::string, std::string>>& names) {
  std::unordered_map<std::string_view, int> index;
  for (const Body& body : bodies()) index.emplace(body.name, static_cast<int>(index.size()));
  const ImpactCounts saved = impact_counts_;
  impact_counts_.pairs.clear();
  const std::int64_t before = impact_count_ == 0 ? 0 : ImpactCounts::kNotKnown;
  for (const auto& [first, second] : names) {
    const auto a = index.find(first);
    const auto b = index.find(second);
    if (a == index.end() || b == index.end()) continue;
    const ImpactCounts::Pair* known = saved.find(a->second, b->second);
    impact_counts_.watch(a->second, b->second, known != nullptr ? known->count : before);
  }
}

void Simulation::lay_out() {
  bounds_.resize(bodies().size());
  stamp_.assign(bodies().size(), 0);
  state_.resize(static_cast<int>(bodies().size()));
  state_.books.setZero();
  running_ = false;
}

void Simulation::recompile(Scene scene, const Needs& needs, double within) {
  model_ = compile(std::move(scene), needs, model_->start_time);
  Tracks tracks(model_, method_);
  tracks.take_over(tracks_, within);
  tracks_ = std::move(tracks);
}

void Simulation::set_method(const Method& method) {
  if (lost_) return;
  method_ = method;
  // Tracks that run on are settled here; all others were at the step's end.
  for (int k = 0; k < tracks_.islands(); ++k) tracks_.settle(k, time_ - tracks_.epoch());
  for (const int i : lasting_.pushed) tracks_.set_contact_acceleration(i, Eigen::Vector3d::Zero());
  lasting_ = {};
  tracks_.set_method(method);
  tracks_.begin(time_);
  running_ = false;
}

void Simulation::add_body(const Body& body) {
  if (lost_) return;
  const Totals before = totals();
  ledger_.momentum_from_gravity = ledger().momentum_from_gravity;
  gravity_since_ = time_;
  Scene scene = model_->scene;
  scene.bodies.push_back(body);
  const Needs needs = this->needs().untrimmed ? this->needs() : needs_of(scene);
  recompile(std::move(scene), needs, time_ - tracks_.epoch());
  tracks_.begin(time_);
  lay_out();
  publish(0.0);
  const Totals after = totals();
  ledger_.put_in_by_user += after.energy() - before.energy();
  ledger_.momentum_from_user += after.momentum - before.momentum;
}

Notices Simulation::notices() const {
  Notices notices = notices_;
  notices.tolerance_missed_since = tracks_.tolerance_missed_since();
  notices.links_missed_since = tracks_.links_missed_since();
  notices.switches_missed_since = tracks_.switches_missed_since();
  return notices;
}

Ledger Simulation::ledger() const {
  Ledger ledger = ledger_;
  ledger.add(1.0, ledger_of_books(state_));
  ledger.lost_to_links = tracks_.lost_to_links();
  double total = 0.0;
  for (int i = 0; i < state_.size(); ++i) {
    if (!immovable(i)) total += mass().mass[i];
  }
  ledger.momentum_from_gravity += total * (time_ - gravity_since_) * model_->scene.forces.gravity;
  return ledger;
}

void Simulation::publish(double within) {
  for (int i = 0; i < state_.size(); ++i) {
    if (tracks_.is_parabolic() && model_->driven[i] == 0 && !field().keeps_books()) {
      state_.q.col(i) = tracks_.parabola(i, within);
      state_.v.col(i) = tracks_.parabola_velocity(i, within);
    } else {
      state_.set_motion(i, tracks_.at(i, within));
    }
  }
}

State Simulation::state_at(double within) {
  State all;
  all.resize(state_.size());
  for (int i = 0; i < all.size(); ++i) all.set_motion(i, tracks_.at(i, std::max(within, tracks_.start(i))));
  return all;
}

void Simulation::check_motions() const {
  const auto beyond = [](const auto& m) { return !(m.array().abs() <= kLostBeyond).all(); };
  if (!beyond(state_.q) && !beyond(state_.v) && state_.books.allFinite()) return;
  for (int i = 0; i < state_.size(); ++i) {
    if (beyond(state_.q.col(i)) || beyond(state_.v.col(i)) || !state_.books.col(i).allFinite())
      throw LostMotion{LossReason::kTooLarge, i, step_end_};
  }
}

// Looks at the ledger each time that the kinetic energy passes its peak by a power of four, so that most steps
// do without the potential energy, which costs n² under attraction. Twice in a row, as Euler's first step from
// rest is all of its own making: it moves nothing yet.
void Simulation::check_energy() {
  constexpr double kMade = 0.75;  // of the kinetic energy
  // Of the energies in the ledger: less is rounding.
  constexpr double kRounding = 1e-9;
  const double kinetic = kinetic_energy(state_, mass());
  const double peak = std::exchange(peak_kinetic_, std::max(peak_kinetic_, kinetic));
  if (notices_.energy_made_since >= 0.0 || std::ilogb(kinetic) / 2 <= std::ilogb(peak) / 2) return;
  const Ledger now = ledger();
  const double made = now.numerical_drift(totals().energy());
  energy_doubts_ = made > kMade * kinetic && made > kRounding * now.turnover() ? energy_doubts_ + 1 : 0;
  if (energy_doubts_ == 2) note(&Notices::energy_made_since, step_end_);
}

std::string Simulation::status() const {
  const std::string notices = this->notices().text();
  if (!lost_) return notices;
  const std::string lost = lost_->text(bodies(), time_);
  return notices == "ok" ? lost : lost + "; " + notices;
}

void Simulation::step(double h) {
  impacts_.clear();
  jumps_.clear();
  if (lost_) return;
  last_good_.state = state_;
  last_good_.ledger = ledger_;
  last_good_.notices = notices_;
  last_good_.impact_count = impact_count_;
  last_good_.impact_counts = impact_counts_;
  tracks_.begin_step();
  work_.begin(static_cast<int>(bodies().size()), h);
  try {
    make_step(h);
  } catch (const LostMotion& lost) {
    give_up(lost);
  }
}

void Simulation::give_up(const LostMotion& lost) {
  lost_ = LostRun{lost.reason, lost.body, std::min(lost.time, step_end_)};
  state_ = last_good_.state;
  ledger_ = last_good_.ledger;
  notices_ = last_good_.notices;
  impact_count_ = last_good_.impact_count;
  impact_counts_ = last_good_.impact_counts;
  tracks_.give_back();
  impacts_.clear();
  jumps_.clear();
  lasting_.forces.clear();
}

void Simulation::make_step(double h) {
  if (h != origin_step_) {
    origin_ = time_;
    origin_step_ = h;
    steps_since_origin_ = 0;
  }
  ++steps_since_origin_;
  step_end_ = origin_ + static_cast<double>(steps_since_origin_) * h;
  impacts_before_step_ = impact_count_;
  lasts_ = contacts_last(method_, needs());
  if (lasts_) {
    step_length_ = std::max(h, method_.step);
    tracks_.begin(time_);
    hold_contacts(h);
  }
  if (method_.impacts == ImpactsId::kLocated) {
    step_with_located_impacts(h);
  } else {
    step_with_impacts_at_end(h);
  }
  check_motions();
  time_ = step_end_;
  check_energy();
  ++steps_;
}

// --- one impact
// ---------------------------------------------------------------------------------------------------

ImpactSide Simulation::side(int body, const Contact& contact, double towards) const {
  const auto y = tracks_.settled(body);
  const Vec2 r = contact.point - y.head<2>();
  const Vec2& n = contact.normal;
  // The normal of a disc's contact passes through its centre, but for rounding.
  const double lever = shapes().is_disc(body) ? 0.0 : towards * (r.x() * n.y() - r.y() * n.x());
  return {y.segment<2>(3),    y[5], mass().inverse_mass[body], mass().inverse_inertia[body],
          towards * r.dot(n), lever};
}

Approach Simulation::approach(int a, int b, double tolerance) const {
  const auto ya = tracks_.settled(a);
  const auto yb = tracks_.settled(b);
  return approach_of(shapes(), a, ya.head<3>(), {ya.segment<2>(3), ya[5]}, b, yb.head<3>(),
                     {yb.segment<2>(3), yb[5]}, tolerance);
}

void Simulation::collide(int a, int b, const Contact& contact, const Material& material, double within) {
  ImpactSide side_a = side(a, contact, 1.0);
  ImpactSide side_b = side(b, contact, -1.0);
  const double closing = -relative_velocity(side_a, side_b, contact.normal).normal;
  // Semi-implicit Euler's path x + t v(t) may close again, from an overlap, while v(t) still parts the bodies.
  if (!(closing > 0.0)) return;
  const bool watched = watches_more();
  Jump jump;
  if (watched) {
    jump.before = state_at(within);
    jump.change.add(-1.0, ledger_);
  }

  Impact impact;
  if (material.sticks) {
    impact = join(a, b, contact);
  } else if (tracks_.is_linked(a) || tracks_.is_linked(b)) {
    impact = resolve_linked_impact(tracks_, mass(), a, b, contact, material, model_->scene.impact_law);
  } else {
    impact = resolve_impact(side_a, side_b, contact.normal, material, model_->scene.impact_law);
    if (!immovable(a)) tracks_.set_velocity(a, side_a.velocity, side_a.spin);
    if (!immovable(b)) tracks_.set_velocity(b, side_b.velocity, side_b.spin);
  }

  if (field().has_switching_springs()) {
    for (const int i : {a, b}) {
      if (!immovable(i)) ledger_.lost_to_dampers += tracks_.recheck_switches(tracks_.island_of(i));
    }
  }

  book(a, b, contact, impact, closing, within);
  if (watched) {
    jump.time = std::min(tracks_.epoch() + within, step_end_);
    jump.after = state_at(within);
    jump.change.add(1.0, ledger_);
    jumps_.push_back(std::move(jump));
  }
}

void Simulation::book(int a, int b, const Contact& contact, const Impact& impact, double closing,
                      double within) {
  ++impact_count_;
  impact_counts_.add(a, b, impact.normal, mass());
  ImpactRecord record;
  record.time = std::min(tracks_.epoch() + within, step_end_);  // the sum may round beyond the end
  record.a = a;
  record.b = b;
  record.point = contact.point;
  record.normal = contact.normal;
  record.closing_speed = closing;
  record.normal_impulse = impact.normal;
  record.tangential_impulse = impact.tangential;
  record.lost_to_restitution = impact.lost_to_restitution;
  record.lost_to_friction = impact.lost_to_friction;
  record.lost_to_sticking = impact.lost_to_sticking;
  if (impacts_.size() < kMostLogged) {
    impacts_.push_back(record);
  } else if (notices_.log_cut_since < 0.0) {
    notices_.log_cut_since = record.time;
  }
  if (impact.energy_gain > 0.0) {
    if (notices_.gained_since < 0.0) notices_.gained_since = record.time;
    notices_.gained += impact.energy_gain;
  }
  ledger_.lost_to_restitution += impact.lost_to_restitution;
  ledger_.lost_to_friction += impact.lost_to_friction;
  ledger_.lost_to_sticking += impact.lost_to_sticking;
  // What comes through a link, so through the weld of two that have stuck, stands in the bodies' own books.
  if (!shapes().can_meet(a, b)) return;
  const Vec2 tangent(-contact.normal.y(), contact.normal.x());
  const Vec2 j = impact.normal * contact.normal + impact.tangential * tangent;
  if (immovable(a)) {
    ledger_.momentum_to_walls -= j;
    ledger_.put_in_by_drives += j.dot(tracks_.settled(a).segment<2>(3));
  }
  if (immovable(b)) {
    ledger_.momentum_to_walls += j;
    ledger_.put_in_by_drives -= j.dot(tracks_.settled(b).segment<2>(3));
  }
}

// --- impacts at the step's end
// ------------------------------------------------------------------------------------

void Simulation::step_with_impacts_at_end(double h) {
  tracks_.begin(time_);
  for (int k = 0; k < tracks_.islands(); ++k) {
    double end = 0.0;
    do {
      tracks_.lay(k, h, 0.0);
      end = tracks_.end(tracks_.members(k).front());
      ledger_.lost_to_dampers += tracks_.settle_at_end(k);
    } while (end < h);
  }
  if (lasts_) {
    book_contact_forces(h, 1.0);
    rebound_at_end(lasting_.near);
    publish(h);
    return;
  }
  for (int i = 0; i < state_.size(); ++i) {
    const Eigen::Array2d x = tracks_.settled(i).head<2>().array();
    bounds_[i] = {x - shapes().extent.col(i).array(), x + shapes().extent.col(i).array()};
  }
  near_pairs_.clear();
  for (const auto& [a, b] : near_pairs()) {
    if (shapes().can_meet(a, b)) near_pairs_.push_back({a, b, false});
  }
  publish(h);
  check_motions();
  resolve_at_end(near_pairs_, h);
  if (!near_pairs_.empty()) publish(h);
}

// Of bounds_, in rising order.
const std::vector<std::pair<int, int>>& Simulation::near_pairs() {
  const auto& pairs = broad_phase_.pairs(bounds_, shapes().fixed);
  if (broad_phase_.cut()) note(&Notices::pairs_cut_since, time_);
  return pairs;
}

// After a push moved one of its bodies: positions and velocities go back onto the links. The energy is the
// push's, the momentum comes from what the links are fastened to.
void Simulation::restore_links(int island) {
  const auto totals_now = [&] {
    for (const int i : tracks_.members(island)) state_.set_motion(i, tracks_.settled(i));
    return totals();
  };
  const Totals before = totals_now();
  tracks_.restore_links(island);
  const Totals after = totals_now();
  ledger_.overlap_correction += after.energy() - before.energy();
  ledger_.momentum_to_walls -= after.momentum - before.momentum;
}

// The state must be published.
void Simulation::resolve_at_end(const std::vector<WaitingPair>& pairs, double h) {
  const double now = step_end_ - tracks_.epoch();
  // Each push changes the energy of attraction with all bodies: of many pairs their sum is taken at once.
  const bool all_at_once = field().attracts() && !needs().links && pairs.size() > bodies().size();
  if (all_at_once) ledger_.overlap_correction -= field().potential_energy(state_.q);
  for (const auto& [a, b, resting] : pairs) {
    work_.pass(1);
    if (!shapes().can_meet(a, b)) continue;  // joined meanwhile
    Approach at = approach(a, b, 0.0);
    const double gap = at.contact.gap;
    if (gap >= 0.0) continue;
    const Vec2 normal = at.contact.normal;

    // Bodies with corners may overlap at two: once for the middle, then for the one that still approaches.
    const int most = shapes().is_disc(a) || shapes().is_disc(b) ? 1 : 3;
    for (int k = 0; k < most; ++k) {
      if (k > 0) at = approach(a, b, -gap);
      if (!(at.speed < (k == 0 ? 0.0 : -16.0 * kEpsilon * at.scale))) break;
      Material material = material_between(a, b);
      // What gravity pressed in during this step must not bounce; a true impact on a resting pair must.
      if (resting && -at.speed <= pressed_in(a, b, h)) material.restitution = 0.0;
      collide(a, b, at.contact, material, now);
      if (!shapes().can_meet(a, b)) break;
    }
    if (!shapes().can_meet(a, b)) continue;

    const double share = mass().inverse_mass[a] + mass().inverse_mass[b];
    const Vec2 push = (resting ? 1.0 : kOverlapFraction) * -gap / share * normal;
    for (const int i : {a, b}) {
      if (immovable(i)) continue;
      const Vec2 x = tracks_.settled(i).head<2>();
      const Vec2 moved = x + (i == a ? -1.0 : 1.0) * mass().inverse_mass[i] * push;
      if (!all_at_once) {
        ledger_.overlap_correction +=
            field().potential_energy_of(i, moved, state_.q) - field().potential_energy_of(i, x, state_.q);
      }
      tracks_.set_pose(i, {moved.x(), moved.y(), tracks_.settled(i)[2]});
      state_.q.col(i).head<2>() = moved;
      if (tracks_.is_linked(i)) restore_links(tracks_.island_of(i));
    }
  }
  if (all_at_once) ledger_.overlap_correction += field().potential_energy(state_.q);
}

}  // namespace carom
