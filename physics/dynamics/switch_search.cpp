#include "physics/dynamics/switch_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/math/roots.h"

namespace carom {
namespace {

using Island = Flights::Island;

// A trajectory is looked at in parts in which no end of a switch turns, or swings, by more than this angle, or
// comes nearer to the other one by more than this share of the length at which it switches: a margin is near
// its parabola then. Where that makes too many parts, a step that is too long for its motion has fewer.
constexpr double kPartOfTurn = 0.25;  // rad
constexpr double kPartOfLength = 0.5;
constexpr int kFewestParts = 4;
constexpr int kMostParts = 64;
constexpr double kLongestTurn = 6.0;  // rad, of a trajectory that no step limits
// Of the largest of three margins: where their parabola goes below it the margin is looked at.
constexpr double kNear = 0.25;
constexpr double kRounding = 1e-12;  // likewise: a margin that is rounding leaves no state
constexpr int kMostLooks = 6;

bool is_on(const Flights& f, const Switch& a_switch) {
  if (const auto* joint = std::get_if<JointIndex>(&a_switch)) return f.joints.taut(*joint);
  return f.field.engaged(std::get<SpringIndex>(a_switch));
}

void set_on(Flights& f, const Switch& a_switch, bool on) {
  if (const auto* joint = std::get_if<JointIndex>(&a_switch)) {
    f.joints.set_taut(*joint, on);
  } else {
    f.field.set_engaged(std::get<SpringIndex>(a_switch), on);
  }
}

// The other end of a spring.
Motion other_end(Flights& f, SpringIndex spring, double time) {
  const BodyIndex other = f.field.spring_other(spring);
  return other >= 0 ? f.at(other, time) : f.field.spring_end(spring, f.epoch + time);
}

double margin_at(Flights& f, const Island& island, const Switch& a_switch, double time) {
  if (const auto* joint = std::get_if<JointIndex>(&a_switch)) {
    const Motions& y = f.group_at(island, time);
    if (!f.joints.taut(*joint)) return f.joints.overstretch(island.group, *joint, f.epoch + time, y);
    (void)f.rates_of(island, time, y);
    return f.joints.tension(island.group, *joint);
  }
  const SpringIndex spring = std::get<SpringIndex>(a_switch);
  const Motion body = f.at(f.field.spring_body(spring), time);
  return f.field.switch_margin(spring, body, other_end(f, spring, time));
}

}  // namespace

SwitchSearch::SwitchSearch(const Model& model) : released_at_(model.joint_terms.all.size(), -1.0) {
  const auto note = [&](const Ends& ends) {
    reaches_.resize(model.bodies());
    const auto add = [&](BodyIndex body, bool turns) {
      Reach& reach = reaches_[static_cast<std::size_t>(body)];
      reach.turns = reach.turns || turns;
      if (ends.length > 0.0) reach.length = std::min(reach.length, ends.length);
    };
    add(ends.body, ends.turns);
    if (ends.other >= 0) add(ends.other, ends.other_turns);
    if (ends.drive < 0) return;
    Reach& reach = reaches_[static_cast<std::size_t>(ends.body)];
    reach.swing = std::max(reach.swing, model.drive(ends.drive).angular_frequency);
    reach.passing = std::max(reach.passing, model.drive(ends.drive).velocity.norm());
  };
  for (const SpringIndex spring : model.forces.springs.indices()) {
    if (model.forces.springs[spring].acts != SpringActs::kBoth) note(ends_of(model, spring));
  }
  for (const JointIndex joint : model.joint_terms.all.indices()) {
    if (model.joint_terms.all[joint].kind == JointKind::kString) note(ends_of(model, joint));
  }
}

SwitchSearch::Ends SwitchSearch::ends_of(const Model& model, const Switch& a_switch) {
  if (const auto* joint = std::get_if<JointIndex>(&a_switch)) {
    const JointTerm& term = model.joint_terms.all[*joint];
    return {term.body, term.other, term.drive, !term.point.isZero(0.0), !term.anchor.isZero(0.0), term.length};
  }
  const SpringTerm& term = model.forces.springs[std::get<SpringIndex>(a_switch)];
  return {term.body,       term.other, term.drive, !term.point.isZero(0.0), !term.other_point.isZero(0.0),
          term.rest_length};
}

double SwitchSearch::time_to_follow(const Flights& f, const Island& island) const {
  double most = std::numeric_limits<double>::infinity();
  if (island.kinematic || reaches_.empty()) return most;
  const auto bound = [&most](double way, double pace, double change) {
    most = std::min(most, 2.0 * way / (pace + std::sqrt(pace * pace + 2.0 * change * way)));
  };
  for (const BodyIndex i : f.members_of(island)) {
    const Reach& reach = reaches_[static_cast<std::size_t>(i)];
    const auto start = f.at_start.col(i);
    if (reach.turns) bound(kLongestTurn, std::abs(start[5]), std::abs(f.constant.col(i)[2]));
    if (reach.swing > 0.0) bound(kLongestTurn, reach.swing, 0.0);
    if (std::isfinite(reach.length))
      bound(kMostParts * kPartOfLength * reach.length, start.segment<2>(3).norm() + reach.passing,
            f.constant.col(i).head<2>().norm());
  }
  return most;
}

double SwitchSearch::recheck(Flights& f, const Island& island) {
  double released = 0.0;
  for (const BodyIndex i : f.members_of(island)) {
    for (const SpringIndex spring : f.field.switching_springs(i)) {
      const double margin = margin_at(f, island, spring, island.start);
      if (margin != 0.0 && (margin > 0.0) != f.field.engaged(spring))
        released += flip(f, island, spring, island.start);
    }
  }
  return released;
}

double SwitchSearch::flip(Flights& f, const Island& island, const Switch& a_switch, double time) {
  if (const auto* joint = std::get_if<JointIndex>(&a_switch)) {
    set_on(f, a_switch, !is_on(f, a_switch));
    if (is_on(f, a_switch)) {
      lost_to_joints_ += f.apply_taut_impulse(island);
      if (!is_on(f, a_switch)) released_at_[static_cast<std::size_t>(*joint)] = f.epoch + time;
    }
    f.forget(island);
    return 0.0;
  }
  const SpringIndex spring = std::get<SpringIndex>(a_switch);
  const Motion body = f.at(f.field.spring_body(spring), time);
  const Motion other = other_end(f, spring, time);
  const double before = f.field.spring_energy(spring, body, other);
  f.field.set_engaged(spring, !f.field.engaged(spring));
  return before - f.field.spring_energy(spring, body, other);
}

bool SwitchSearch::may_follow(const Flights& f, const Island& island) {
  std::int64_t most = kMostWork + kMostWorkPerBody * f.bodies();
  if (missed_since_ >= 0.0) most /= 50;
  if (f.flight_work <= most) return true;
  if (missed_since_ < 0.0) missed_since_ = f.epoch + island.start;
  return false;
}

void SwitchSearch::list(const Flights& f, const Island& island) {
  listed_.clear();
  for (const BodyIndex i : f.members_of(island)) {
    for (const SpringIndex spring : f.field.switching_springs(i)) {
      // A spring between two members belongs to both.
      if (f.field.spring_body(spring) == i || !island.coupled()) listed_.emplace_back(spring);
    }
  }
  if (!island.coupled()) return;
  for (const JointIndex joint : f.joints.strings(island.group)) listed_.emplace_back(joint);
}

// The margins of all listed switches at one time, > 0 where they are in the state that they are said to be in:
// one motion of the group serves them all.
void SwitchSearch::sample(Flights& f, const Island& island, double time, std::vector<double>& margins) {
  margins.clear();
  bool pulled = false;  // the tensions at this time are known
  for (const Switch& a_switch : listed_) {
    const bool on = is_on(f, a_switch);
    double margin = 0.0;
    if (const auto* joint = std::get_if<JointIndex>(&a_switch); joint != nullptr && on) {
      if (!pulled) (void)f.rates_of(island, time, f.group_at(island, time));
      pulled = true;
      margin = f.joints.tension(island.group, *joint);
    } else {
      margin = margin_at(f, island, a_switch, time);
    }
    margins.push_back(on ? margin : -margin);
  }
}

// A switch must first be seen in the state that it is said to be in: just after it flipped its margin is zero
// within rounding. One that is out of that state over the whole trajectory flips at once, if it is then in its
// state: it was due together with another switch of the island.
void SwitchSearch::end_at_first(Flights& f, Island& island) {
  const bool strings = island.coupled() && !f.joints.strings(island.group).empty();
  if (!f.field.has_switching_springs() && !strings) return;
  if (!may_follow(f, island)) return;
  double first = island.end;
  find_leaving(f, island, first);
  find_roots(f, island, first);
  if (!island.switching) return;
  for (const BodyIndex i : f.members_of(island)) f.at_end.col(i) = f.at(i, first);
  island.end = first;
}

int SwitchSearch::parts_of(Flights& f, const Island& island) const {
  const double width = island.end - island.start;
  double parts = kFewestParts;
  for (const Switch& a_switch : listed_) {
    const Ends ends = ends_of(*f.model, a_switch);
    const auto turned = [&](BodyIndex body) {
      return width * std::max(std::abs(f.at_start.col(body)[5]), std::abs(f.at_end.col(body)[5]));
    };
    double turn = ends.turns ? turned(ends.body) : 0.0;
    if (ends.other >= 0 && ends.other_turns) turn = std::max(turn, turned(ends.other));
    if (ends.drive >= 0) turn = std::max(turn, width * f.model->drive(ends.drive).angular_frequency);
    const auto way = [&](const Motion& y, const Motion& far) { return width * (y - far).segment<2>(3).norm(); };
    double most = 0.0;  // m
    if (ends.other >= 0) {
      most = std::max(way(f.at_start.col(ends.body), f.at_start.col(ends.other)),
                      way(f.at_end.col(ends.body), f.at_end.col(ends.other)));
    } else {
      const Motion plane = Motion::Zero();
      most = std::max(way(f.at_start.col(ends.body), plane), way(f.at_end.col(ends.body), plane));
      if (ends.drive >= 0) most += width * f.model->drive(ends.drive).velocity.norm();
    }
    parts = std::max(parts, turn / kPartOfTurn);
    if (ends.length > 0.0) parts = std::max(parts, most / (kPartOfLength * ends.length));
  }
  return parts < kMostParts ? static_cast<int>(std::ceil(parts)) : kMostParts;
}

std::optional<SwitchSearch::Leaving> SwitchSearch::dip(Flights& f, const Island& island, const Switch& a_switch,
                                                       std::array<Sample, 3> at) {
  const double largest = std::max({at[0].margin, at[1].margin, at[2].margin});
  double lowest = std::min({at[0].margin, at[1].margin, at[2].margin});
  if (!(lowest > 0.0)) return std::nullopt;
  const double sign = is_on(f, a_switch) ? 1.0 : -1.0;
  for (int look = 0; look < kMostLooks; ++look) {
    // Newton's form of the parabola through the three.
    const double first = (at[1].margin - at[0].margin) / (at[1].time - at[0].time);
    const double second = (at[2].margin - at[1].margin) / (at[2].time - at[1].time);
    const double bend = (second - first) / (at[2].time - at[0].time);
    if (!(bend > 0.0)) return std::nullopt;
    const double time = 0.5 * (at[0].time + at[1].time - first / bend);
    const double deepest = at[0].margin + (time - at[0].time) * (first + bend * (time - at[1].time));
    if (!(time > at[0].time && time < at[2].time) || time == at[1].time) return std::nullopt;
    if (!(deepest < kNear * largest)) return std::nullopt;
    const Sample found{time, sign * margin_at(f, island, a_switch, time)};
    const std::size_t after = time < at[1].time ? 1 : 2;
    const Sample& before = at[after - 1];
    if (found.margin < -kRounding * largest)
      return Leaving{a_switch, before.time, found.time, before.margin, found.margin};
    if (!(found.margin > 0.0 && found.margin < 0.9 * lowest)) return std::nullopt;
    lowest = found.margin;
    at = after == 1 ? std::array<Sample, 3>{at[0], found, at[1]} : std::array<Sample, 3>{at[1], found, at[2]};
  }
  return std::nullopt;
}

void SwitchSearch::find_leaving(Flights& f, Island& island, double& first) {
  list(f, island);
  const int parts = parts_of(f, island);
  const double width = island.end - island.start;
  const auto time_of = [&](int s) {
    if (s == 0) return island.start;
    return s == parts ? island.end : island.start + width * s / parts;
  };
  const auto last = static_cast<std::size_t>(parts);
  if (margins_.size() <= last) margins_.resize(last + 1);
  for (int s = 0; s <= parts; ++s) sample(f, island, time_of(s), margins_[static_cast<std::size_t>(s)]);

  leaving_.clear();
  double earliest = island.end;  // by when a switch has left
  for (std::size_t k = 0; k < listed_.size(); ++k) {
    const Switch a_switch = listed_[k];
    const auto at = [&](int s) { return Sample{time_of(s), margins_[static_cast<std::size_t>(s)][k]}; };
    bool seen = at(0).margin > 0.0;
    bool left = false;
    for (int s = 1; s <= parts && !left; ++s) {
      const Sample before = at(s - 1);
      const Sample now = at(s);
      left = before.margin > 0.0 && now.margin <= 0.0;
      seen = seen || now.margin > 0.0;
      if (left) {
        leaving_.push_back({a_switch, before.time, now.time, before.margin, now.margin});
      } else if (s < parts && before.time < earliest) {
        const auto dipped = dip(f, island, a_switch, {before, now, at(s + 1)});
        if (dipped) leaving_.push_back(*dipped);
        left = dipped.has_value();
      }
      if (left) earliest = std::min(earliest, leaving_.back().after);
    }
    if (seen || !(margins_[last][k] < 0.0)) continue;
    // A push out of a penetration may have left a slack string too long, though its ends approach.
    const auto* joint = std::get_if<JointIndex>(&a_switch);
    if (joint != nullptr && released_at_[static_cast<std::size_t>(*joint)] == f.epoch + island.start) continue;
    const bool on = is_on(f, a_switch);
    set_on(f, a_switch, !on);
    f.forget(island);
    const double margin = margin_at(f, island, a_switch, time_of(1));
    set_on(f, a_switch, on);
    f.forget(island);
    if ((on ? margin : -margin) < 0.0) {
      first = island.start;
      island.switching = a_switch;
    }
  }
}

// Each root that is found rules out all switches that are still in their state then.
void SwitchSearch::find_roots(Flights& f, Island& island, double& first) {
  while (!leaving_.empty()) {
    const Leaving next = leaving_.front();
    const double sign = is_on(f, next.a_switch) ? 1.0 : -1.0;
    const double root = bracketed_root([&](double t) { return sign * margin_at(f, island, next.a_switch, t); },
                                       next.before, next.margin_before, next.after, next.margin_after);
    if (root < first || (root == first && !island.switching)) {
      first = root;
      island.switching = next.a_switch;
    }
    leaving_.erase(leaving_.begin());
    if (leaving_.empty()) break;
    listed_.clear();
    for (const Leaving& other : leaving_) listed_.push_back(other.a_switch);
    sample(f, island, first, margins_at_first_);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < leaving_.size(); ++k) {
      const bool later =
          leaving_[k].before >= first || (leaving_[k].after > first && margins_at_first_[k] > 0.0);
      if (!later) leaving_[kept++] = leaving_[k];
    }
    leaving_.resize(kept);
  }
}

}  // namespace carom
