#include "physics/dynamics/trajectories.h"
#include "physics/math/roots.h"

// One-sided springs and strings: the moments at which they start and stop to act.
namespace carom {

double Trajectories::recheck_switches(int k) {
  double released = 0.0;
  const Island& island = islands_[k];
  for (const int i : members_of(island)) {
    for (const int spring : field_.switching_springs(i)) {
      const double margin = margin_at(island, spring, island.start);
      if (margin != 0.0 && (margin > 0.0) != field_.engaged(spring))
        released += flip(island, spring, island.start);
    }
  }
  return released;
}

void Trajectories::set_on(int a_switch, bool on) {
  if (is_joint(a_switch)) {
    joints_.set_taut(a_switch - field_.springs(), on);
  } else {
    field_.set_engaged(a_switch, on);
  }
}

// The energy in J that is gone with a spring. A string that becomes taut jerks.
double Trajectories::flip(const Island& island, int a_switch, double time) {
  if (is_joint(a_switch)) {
    set_on(a_switch, !is_on(a_switch));
    if (is_on(a_switch)) {
      lost_to_joints_ += apply_taut_impulse(island);
      if (!is_on(a_switch)) released_at_[a_switch - field_.springs()] = epoch_ + time;
    }
    forget(island);
    return 0.0;
  }
  const Motion body = at(field_.spring_body(a_switch), time);
  const int other = field_.spring_other(a_switch);
  const Motion end = other >= 0 ? at(other, time) : field_.spring_end(a_switch, epoch_ + time);
  const double length = (body - end).head<2>().norm();
  const double before = field_.spring_energy(a_switch, length);
  field_.set_engaged(a_switch, !field_.engaged(a_switch));
  return before - field_.spring_energy(a_switch, length);
}

// > 0 where it acts, < 0 where it doesn't: in N the tension of a taut string, in m the stretch of a slack one.
double Trajectories::margin_at(const Island& island, int a_switch, double time) {
  if (is_joint(a_switch)) {
    const int joint = a_switch - field_.springs();
    const Motions& y = group_at(island, time);
    if (!joints_.taut(joint)) return joints_.overstretch(island.group, joint, epoch_ + time, y);
    (void)rates_of(island, time, y);
    return joints_.tension(island.group, joint);
  }
  const int other = field_.spring_other(a_switch);
  const Motion body = at(field_.spring_body(a_switch), time);
  return field_.switch_margin(a_switch, body,
                              other >= 0 ? at(other, time) : field_.spring_end(a_switch, epoch_ + time));
}

bool Trajectories::follows_switches(const Island& island) {
  std::int64_t most = kMostSwitchWork + kMostSwitchWorkPerBody * static_cast<std::int64_t>(bodies().size());
  if (switches_missed_since_ >= 0.0) most /= 50;
  if (flight_work_ <= most) return true;
  if (switches_missed_since_ < 0.0) switches_missed_since_ = epoch_ + island.start;
  return false;
}

void Trajectories::list_switches(const Island& island) {
  switches_.clear();
  for (const int i : members_of(island)) {
    for (const int spring : field_.switching_springs(i)) {
      // A spring between two members is theirs both.
      if (field_.spring_body(spring) == i || island.group < 0) switches_.push_back(spring);
    }
  }
  if (island.group < 0) return;
  for (const int joint : joints_.strings(island.group)) switches_.push_back(field_.springs() + joint);
}

// The margins of all listed switches at one time, > 0 where they are in the state that they are said to be in:
// one motion of the group serves them all.
void Trajectories::look_at_switches(const Island& island, double time, std::vector<double>& margins) {
  margins.clear();
  bool pulled = false;  // the tensions at this time are known
  for (const int a_switch : switches_) {
    const bool on = is_on(a_switch);
    double margin = 0.0;
    if (is_joint(a_switch) && on) {
      if (!pulled) (void)rates_of(island, time, group_at(island, time));
      pulled = true;
      margin = joints_.tension(island.group, a_switch - field_.springs());
    } else {
      margin = margin_at(island, a_switch, time);
    }
    margins.push_back(on ? margin : -margin);
  }
}

// Ends the trajectory at the first moment at which a one-sided spring or a string of the island starts or stops
// to act. The switch must first be seen in the state that it is said to be in: just after a switch its margin
// is zero within rounding. One that is out of that state all along switches at once, if it is then in its
// state: it was due together with another switch of the island. The trajectory is looked at in quarters: what
// engages and lets go within less is not resolved by the step either.
void Trajectories::find_switch(Island& island) {
  const int quarters = static_cast<int>(margins_.size()) - 1;
  const double width = island.end - island.start;
  const auto time_of = [&](int s) {
    if (s == 0) return island.start;
    return s == quarters ? island.end : island.start + width * s / quarters;
  };
  list_switches(island);
  for (int s = 0; s <= quarters; ++s)
    look_at_switches(island, time_of(s), margins_[static_cast<std::size_t>(s)]);

  leaving_.clear();
  double first = island.end;
  for (std::size_t k = 0; k < switches_.size(); ++k) {
    const int a_switch = switches_[k];
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
    if (is_joint(a_switch) && released_at_[a_switch - field_.springs()] == epoch_ + island.start) continue;
    const bool on = is_on(a_switch);
    set_on(a_switch, !on);
    forget(island);
    const double margin = margin_at(island, a_switch, time_of(1));
    set_on(a_switch, on);
    forget(island);
    if ((on ? margin : -margin) < 0.0) {
      first = island.start;
      island.switching = a_switch;
    }
  }

  // Each root that is found rules out all switches that are still in their state then.
  while (!leaving_.empty()) {
    const Leaving next = leaving_.front();
    const double sign = is_on(next.a_switch) ? 1.0 : -1.0;
    const double root = bracketed_root([&](double t) { return sign * margin_at(island, next.a_switch, t); },
                                       next.before, next.margin_before, next.after, next.margin_after);
    if (root < first || (root == first && island.switching < 0)) {
      first = root;
      island.switching = next.a_switch;
    }
    leaving_.erase(leaving_.begin());
    if (leaving_.empty()) break;
    switches_.clear();
    for (const Leaving& other : leaving_) switches_.push_back(other.a_switch);
    look_at_switches(island, first, margins_at_first_);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < leaving_.size(); ++k) {
      const bool later =
          leaving_[k].before >= first || (leaving_[k].after > first && margins_at_first_[k] > 0.0);
      if (!later) leaving_[kept++] = leaving_[k];
    }
    leaving_.resize(kept);
  }
  if (island.switching < 0) return;
  for (const int i : members_of(island)) at_end_.col(i) = at(i, first);
  island.end = first;
}

}  // namespace carom
