#include "physics/motion/tracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "physics/collision/time_of_impact.h"

namespace carom {
namespace {

// The adaptive integrator's shortest step, relative to the one that the method names: below it the tolerance
// counts as out of reach.
constexpr double kShortestStep = 1e-9;
// A driven body's track is at most this fraction of a radian of its swing long, so that its bend stays small.
constexpr double kSwing = 0.5;
// A track in which nothing moves ends some time.
constexpr double kLongestTrack = 1e6;  // s

struct OneBody {
  const ForceField& field;
  int body;
  double epoch;
  template <class Y>
  void operator()(double t, const Y& y, Y& k) const {
    field.external_rate(body, epoch + t, y, k);
  }
  [[nodiscard]] bool keeps_books() const { return field.keeps_books(); }
};

struct Group {
  const ForceField& field;
  const std::vector<int>& members;
  double epoch;
  void operator()(double t, const Motions& y, Motions& k) const {
    for (std::size_t j = 0; j < members.size(); ++j)
      field.external_rate(members[j], epoch + t, y.col(j), k.col(j));
    field.add_couplings(members, y, k);
  }
  [[nodiscard]] bool keeps_books() const { return field.keeps_books(); }
};

// The time after which a body of this speed and acceleration has moved by `reach` at the most.
double time_to_move(double reach, double speed, double acceleration) {
  return std::min(kLongestTrack, 2.0 * reach / (speed + std::sqrt(speed * speed + 2.0 * acceleration * reach)));
}

}  // namespace

Tracks::Tracks(const Scene& scene, const std::vector<Body>& bodies, const Needs& needs)
    : field_(scene.forces, bodies), bodies_(bodies), general_(needs == all_needs()) {
  const int n = static_cast<int>(bodies.size());
  island_of_.assign(n, -1);
  settled_.resize(Eigen::NoChange, n);
  constant_ = Eigen::Matrix3Xd::Zero(3, n);
  bend_ = Eigen::VectorXd::Zero(n);
  std::vector<std::vector<int>> groups;
  if (needs.coupled_forces) groups = field_.coupled_groups();
  if (general_) {
    groups.assign(1, {});
    for (int i = 0; i < n; ++i) {
      if (!is_immovable(bodies[i])) groups[0].push_back(i);
    }
  }
  for (const std::vector<int>& group : groups) {
    for (const int i : group) island_of_[i] = static_cast<int>(islands_.size());
    if (group.empty()) continue;
    Island island;
    island.members = group;
    island.from.resize(Eigen::NoChange, static_cast<Eigen::Index>(group.size()));
    island.now = island.from;
    island.stages.resize(static_cast<int>(group.size()));
    islands_.push_back(std::move(island));
  }
  for (int i = 0; i < n; ++i) {
    settled_.col(i) = initial_motion(bodies[i]);
    constant_.col(i) = field_.constant_acceleration(i);
    if (bodies[i].fixed || island_of_[i] >= 0) continue;
    island_of_[i] = static_cast<int>(islands_.size());
    islands_.emplace_back();
    islands_.back().members = {i};
    islands_.back().driven = bodies[i].drive.has_value();
  }
  at_end_ = settled_;
  set_method(scene.method);
}

void Tracks::set_method(const Method& method) {
  const IntegratorChoice& choice = choice_of(kIntegrators, method.integrator);
  integrator_ = method.integrator;
  adaptive_ = choice.adaptive;
  evaluations_a_step_ = choice.evaluations;
  // Without any acceleration every integrator goes straight.
  parabolic_ = !general_ && field_.is_constant() && (choice.exact_under_gravity || constant_.isZero(0.0));
  tolerance_ = method.tolerance;
  step_ = method.step;
  for (Island& island : islands_) island.next_step = method.step;
}

void Tracks::begin(double epoch) {
  epoch_ = epoch;
  for (Island& island : islands_) {
    island.start = island.end = 0.0;
    island.cached = -kForever;
    for (const int i : island.members) field_.set_phase(i, epoch);
  }
}

void Tracks::take_over(Tracks& other, double time) {
  for (int i = 0; i < static_cast<int>(other.bodies_.size()); ++i)
    settled_.col(i) = other.at(i, time - other.epoch_);
  field_.take_over(other.field_);
  evaluations_ = other.evaluations_;
  rejected_steps_ = other.rejected_steps_;
  tolerance_missed_since_ = other.tolerance_missed_since_;
  begin(time);
  for (const Island& island : islands_) {
    if (island.driven) settled_.col(island.members.front()) = at(island.members.front(), 0.0);
  }
}

Eigen::Index Tracks::column_of(const Island& island, int body) {
  return std::lower_bound(island.members.begin(), island.members.end(), body) - island.members.begin();
}

// --- along a track
// ------------------------------------------------------------------------------------------------

void Tracks::fly_one(const Island& island, double time, Motion& out, Stages<Motion>& stages) {
  const int body = island.members.front();
  if (island.driven) {
    const Body& b = bodies_[body];
    out = settled_.col(body);
    out.head<2>() = drive_position(*b.drive, b.position, epoch_ + time);
    out.segment<2>(3) = drive_velocity(*b.drive, epoch_ + time);
    return;
  }
  const Motion from = settled_.col(body);
  integrator_step(integrator_, OneBody{field_, body, epoch_}, island.start, from, time - island.start, stages,
                  out);
  evaluations_ += evaluations_a_step_;
}

void Tracks::fly(Island& island, double time) {
  if (island.cached == time) return;
  island.cached = time;
  for (std::size_t j = 0; j < island.members.size(); ++j) island.from.col(j) = settled_.col(island.members[j]);
  integrator_step(integrator_, Group{field_, island.members, epoch_}, island.start, island.from,
                  time - island.start, island.stages, island.now);
  evaluations_ += evaluations_a_step_ * static_cast<std::int64_t>(island.members.size());
}

Motion Tracks::at(int body, double time) {
  const int k = island_of_[body];
  if (k < 0) return settled_.col(body);
  Island& island = islands_[k];
  if (!island.driven) {
    if (time == island.start) return settled_.col(body);
    if (time == island.end) return at_end_.col(body);
  }
  if (island.members.size() == 1) {
    Stages<Motion> stages;
    Motion out;
    fly_one(island, time, out, stages);
    return out;
  }
  fly(island, time);
  return island.now.col(column_of(island, body));
}

Vec2 Tracks::acceleration(int body) {
  const int k = island_of_[body];
  if (k < 0 || islands_[k].driven) return Vec2::Zero();
  if (parabolic_) return constant_.col(body).head<2>();
  Island& island = islands_[k];
  if (island.members.size() == 1) {
    const Motion y = settled_.col(body);
    Motion rate;
    OneBody{field_, body, epoch_}(island.start, y, rate);
    return rate.segment<2>(3);
  }
  for (std::size_t j = 0; j < island.members.size(); ++j) island.from.col(j) = settled_.col(island.members[j]);
  Group{field_, island.members, epoch_}(island.start, island.from, island.stages.k[0]);
  return island.stages.k[0].col(column_of(island, body)).segment<2>(3);
}

void Tracks::settle(int k, double time) {
  Island& island = islands_[k];
  if (!island.driven) {
    if (island.members.size() == 1) {
      settled_.col(island.members.front()) = at(island.members.front(), time);
    } else if (time != island.start) {
      for (const int i : island.members) at_end_.col(i) = at(i, time);
      for (const int i : island.members) settled_.col(i) = at_end_.col(i);
    }
  } else {
    settled_.col(island.members.front()) = at(island.members.front(), time);
  }
  island.start = island.end = time;
  island.switching = -1;
  island.cached = -kForever;
}

double Tracks::settle_at_end(int k) {
  Island& island = islands_[k];
  const int spring = island.switching;
  settle(k, island.end);
  for (const int i : island.members) field_.set_phase(i, epoch_ + island.start);
  if (spring < 0) return 0.0;
  const Motion body = at(field_.spring_body(spring), island.start);
  const int other = field_.spring_other(spring);
  const Motion end = other >= 0 ? at(other, island.start) : field_.spring_end(spring, epoch_ + island.start);
  const double length = (body - end).head<2>().norm();
  const double before = field_.spring_energy(spring, length);
  field_.set_engaged(spring, !field_.engaged(spring));
  return before - field_.spring_energy(spring, length);
}

void Tracks::set_velocity(int body, const Vec2& velocity, double spin) {
  settled_.col(body).segment<3>(3) << velocity, spin;
  if (island_of_[body] >= 0) islands_[island_of_[body]].cached = -kForever;
}

void Tracks::set_position(int body, const Vec2& position) {
  settled_.col(body).head<2>() = position;
  if (island_of_[body] >= 0) islands_[island_of_[body]].cached = -kForever;
}

// --- laying a track
// -----------------------------------------------------------------------------------------------

void Tracks::lay(int k, double horizon, double reach) {
  Island& island = islands_[k];
  island.switching = -1;
  island.cached = -kForever;
  island.end = horizon;
  // Where no step ends the track, its path's length does.
  const bool free_running = !(horizon < kForever);
  for (const int i : island.members) {
    const Vec2 v = settled_.col(i).segment<2>(3);
    if (island.driven) {
      const Drive& d = *bodies_[i].drive;
      if (free_running) {
        const double swing = d.angular_frequency * d.amplitude.norm();
        const double most = time_to_move(reach, d.velocity.norm() + swing, 0.0);
        island.end = std::min(island.end, island.start + most);
      }
      if (free_running && d.angular_frequency > 0.0)
        island.end = std::min(island.end, island.start + kSwing / d.angular_frequency);
      continue;
    }
    if (free_running)
      island.end =
          std::min(island.end, island.start + time_to_move(reach, v.norm(), constant_.col(i).head<2>().norm()));
    const double moment = field_.next_break(i, epoch_ + island.start) - epoch_;
    if (moment < island.end) island.end = moment;
  }
  if (adaptive_ && !island.driven) lay_adaptive(island, island.end);
  if (island.members.size() == 1) {
    const int body = island.members.front();
    if (parabolic_ && !island.driven) {
      Stages<Motion> stages;
      Motion out;
      fly_one(island, island.end, out, stages);
      at_end_.col(body) = out;
      bend_[body] = constant_.col(body).head<2>().norm();
      return;
    }
    Stages<Motion> stages;
    Motion out;
    fly_one(island, island.end, out, stages);
    at_end_.col(body) = out;
  } else {
    fly(island, island.end);
    for (std::size_t j = 0; j < island.members.size(); ++j) at_end_.col(island.members[j]) = island.now.col(j);
  }
  if (field_.has_switching_springs() && !island.driven) find_switch(island);
  bound_bend(island);
}

double Tracks::error_of(Island& island, double time) {
  const double h = time - island.start;
  const auto members = static_cast<std::int64_t>(island.members.size());
  evaluations_ += members;
  if (members == 1) {
    Stages<Motion> stages;
    Motion out;
    fly_one(island, time, out, stages);
    evaluations_ -= members;  // the table counts the seventh with the step's six
    return dormand_prince_error(OneBody{field_, island.members.front(), epoch_}, island.start, h, stages, out);
  }
  fly(island, time);
  evaluations_ -= members;
  return dormand_prince_error(Group{field_, island.members, epoch_}, island.start, h, island.stages,
                              island.now);
}

// Shortens the track to one step whose error estimate keeps the tolerance.
void Tracks::lay_adaptive(Island& island, double latest) {
  const double most = latest - island.start;
  double h = std::min(island.next_step, most);
  while (true) {
    island.cached = -kForever;
    const double error = error_of(island, island.start + h);
    const double next = next_adaptive_step(h, error, tolerance_);
    const bool last = h < kShortestStep * step_;
    if (error <= tolerance_ || last) {
      if (last && error > tolerance_ && tolerance_missed_since_ < 0.0)
        tolerance_missed_since_ = epoch_ + island.start;
      // A step that was cut short tells little about the next one.
      if (h < most || next < island.next_step) island.next_step = next;
      break;
    }
    ++rejected_steps_;
    h = next;
  }
  island.end = h < most ? island.start + h : latest;
  island.cached = -kForever;
}

double Tracks::margin_at(int spring, double time) {
  const int other = field_.spring_other(spring);
  const Motion body = at(field_.spring_body(spring), time);
  return field_.switch_margin(spring, body,
                              other >= 0 ? at(other, time) : field_.spring_end(spring, epoch_ + time));
}

// Ends the track at the first moment at which a one-sided spring of the island starts or stops to act. The
// spring must first be seen in the state that it is said to be in: just after a switch its margin is zero
// within rounding.
void Tracks::find_switch(Island& island) {
  constexpr int kSamples = 8;
  double first = island.end;
  for (const int i : island.members) {
    for (const int spring : field_.switching_springs(i)) {
      const double sign = field_.engaged(spring) ? 1.0 : -1.0;
      const auto margin = [&](double t) { return sign * margin_at(spring, t); };
      const double width = island.end - island.start;
      bool settled = false;
      double before = island.start;
      double margin_before = 0.0;
      for (int s = 0; s <= kSamples; ++s) {
        const double t = s == kSamples ? island.end : island.start + width * s / kSamples;
        const double m = margin(t);
        if (settled && m <= 0.0) {
          const double root = bracketed_root(margin, before, margin_before, t, m);
          // The side on which it has not yet switched; the last bit beyond belongs to the next track.
          if (root < first || (root == first && island.switching < 0)) {
            first = root;
            island.switching = spring;
          }
          break;
        }
        settled = m > 0.0;
        before = t;
        margin_before = m;
      }
    }
  }
  if (island.switching < 0) return;
  std::vector<int>& members = island.members;
  for (const int i : members) {
    const Motion m = at(i, first);
    if (members.size() == 1) {
      at_end_.col(i) = m;
    } else {
      at_end_.col(i) = island.now.col(column_of(island, i));
    }
  }
  island.end = first;
}

void Tracks::bound_bend(Island& island) {
  for (std::size_t j = 0; j < island.members.size(); ++j) {
    const int i = island.members[j];
    if (island.driven) {
      const Drive& d = *bodies_[i].drive;
      bend_[i] = d.angular_frequency * d.angular_frequency * d.amplitude.norm();
    } else {
      bend_[i] = 0.0;
    }
  }
  if (island.driven) return;
  // Twice the larger of the accelerations at both ends: sub-steps of semi-implicit Euler bend by 2a, and within
  // a step that resolves the motion the acceleration varies by less than that.
  if (island.members.size() == 1) {
    const int body = island.members.front();
    const OneBody f{field_, body, epoch_};
    Motion k;
    for (const auto& [t, y] : {std::pair<double, Motion>{island.start, settled_.col(body)},
                               std::pair<double, Motion>{island.end, at_end_.col(body)}}) {
      f(t, y, k);
      bend_[body] = std::max(bend_[body], 2.0 * k.segment<2>(3).norm());
    }
    return;
  }
  const Group f{field_, island.members, epoch_};
  for (const bool at_start : {true, false}) {
    for (std::size_t j = 0; j < island.members.size(); ++j)
      island.from.col(j) = at_start ? settled_.col(island.members[j]) : at_end_.col(island.members[j]);
    f(at_start ? island.start : island.end, island.from, island.stages.k[0]);
    for (std::size_t j = 0; j < island.members.size(); ++j) {
      bend_[island.members[j]] =
          std::max(bend_[island.members[j]], 2.0 * island.stages.k[0].col(j).segment<2>(3).norm());
    }
  }
}

}  // namespace carom
