#include "physics/dynamics/switch_search.h"

#include "physics/math/roots.h"

namespace carom {
namespace {

using Island = Flights::Island;

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
      if (f.field.spring_body(spring) == i || island.group < 0) listed_.emplace_back(spring);
    }
  }
  if (island.group < 0) return;
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
// state: it was due together with another switch of the island. The trajectory is sampled in quarters: what
// starts and stops acting within less is not resolved by the step either.
void SwitchSearch::end_at_first(Flights& f, Island& island) {
  const bool strings = island.group >= 0 && !f.joints.strings(island.group).empty();
  if (!f.field.has_switching_springs() && !strings) return;
  if (!may_follow(f, island)) return;
  double first = island.end;
  find_leaving(f, island, first);
  find_roots(f, island, first);
  if (!island.switching) return;
  for (const BodyIndex i : f.members_of(island)) f.at_end.col(i) = f.at(i, first);
  island.end = first;
}

void SwitchSearch::find_leaving(Flights& f, Island& island, double& first) {
  const int quarters = static_cast<int>(margins_.size()) - 1;
  const double width = island.end - island.start;
  const auto time_of = [&](int s) {
    if (s == 0) return island.start;
    return s == quarters ? island.end : island.start + width * s / quarters;
  };
  list(f, island);
  for (int s = 0; s <= quarters; ++s) sample(f, island, time_of(s), margins_[static_cast<std::size_t>(s)]);

  leaving_.clear();
  for (std::size_t k = 0; k < listed_.size(); ++k) {
    const Switch a_switch = listed_[k];
    bool seen = margins_[0][k] > 0.0;
    int left = 0;
    for (int s = 1; s <= quarters && left == 0; ++s) {
      const auto at = static_cast<std::size_t>(s);
      if (margins_[at - 1][k] > 0.0 && margins_[at][k] <= 0.0) left = s;
      seen = seen || margins_[at][k] > 0.0;
    }
    if (left > 0) {
      const auto at = static_cast<std::size_t>(left);
      leaving_.push_back({a_switch, time_of(left - 1), time_of(left), margins_[at - 1][k], margins_[at][k]});
    }
    if (seen || !(margins_.back()[k] < 0.0)) continue;
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
