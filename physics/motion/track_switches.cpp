#include "physics/collision/time_of_impact.h"
#include "physics/motion/tracks.h"

// One-sided springs and strings: the moments at which they start and stop to act.
namespace carom {

double Tracks::recheck_switches(int k) {
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

void Tracks::set_on(int a_switch, bool on) {
  if (is_link(a_switch)) {
    links_.set_taut(a_switch - field_.springs(), on);
  } else {
    field_.set_engaged(a_switch, on);
  }
}

// The energy in J that is gone with a spring. A string that becomes taut jerks.
double Tracks::flip(const Island& island, int a_switch, double time) {
  if (is_link(a_switch)) {
    set_on(a_switch, !is_on(a_switch));
    if (is_on(a_switch)) {
      lost_to_links_ += jerk(island);
      if (!is_on(a_switch)) let_go_at_[a_switch - field_.springs()] = epoch_ + time;
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
double Tracks::margin_at(const Island& island, int a_switch, double time) {
  if (is_link(a_switch)) {
    const int link = a_switch - field_.springs();
    const Motions& y = group_at(island, time);
    if (!links_.taut(link)) return links_.overstretch(island.group, link, epoch_ + time, y);
    (void)rates_of(island, time, y);
    return links_.tension(island.group, link);
  }
  const int other = field_.spring_other(a_switch);
  const Motion body = at(field_.spring_body(a_switch), time);
  return field_.switch_margin(a_switch, body,
                              other >= 0 ? at(other, time) : field_.spring_end(a_switch, epoch_ + time));
}

// Ends the track at the first moment at which a one-sided spring or a string of the island starts or stops to
// act. The switch must first be seen in the state that it is said to be in: just after a switch its margin is
// zero within rounding. One that is out of that state all along switches at once, if it is then in its state:
// it was due together with another switch of the island. The track is looked at in quarters: what engages and
// lets go within less is not resolved by the step either.
void Tracks::find_switch(Island& island) {
  constexpr int kQuarters = 4;
  const double width = island.end - island.start;
  double first = island.end;
  const auto look_at = [&](int a_switch) {
    const double sign = is_on(a_switch) ? 1.0 : -1.0;
    const auto margin = [&](double t) { return sign * margin_at(island, a_switch, t); };
    double before = island.start;
    double margin_before = margin(before);
    bool seen = margin_before > 0.0;
    for (int s = 1; s <= kQuarters; ++s) {
      const double t = s == kQuarters ? island.end : island.start + width * s / kQuarters;
      const double m = margin(t);
      if (margin_before > 0.0 && m <= 0.0) {
        const double root = bracketed_root(margin, before, margin_before, t, m);
        if (root < first || (root == first && island.switching < 0)) {
          first = root;
          island.switching = a_switch;
        }
        break;
      }
      before = t;
      margin_before = m;
      seen = seen || m > 0.0;
    }
    if (seen || !(margin_before < 0.0)) return;
    // A push out of an overlap may have left a slack string too long, though its ends approach.
    if (is_link(a_switch) && let_go_at_[a_switch - field_.springs()] == epoch_ + island.start) return;
    const bool on = is_on(a_switch);
    set_on(a_switch, !on);
    forget(island);
    const bool belongs_there = margin(island.start + width / kQuarters) < 0.0;
    set_on(a_switch, on);
    forget(island);
    if (belongs_there) {
      first = island.start;
      island.switching = a_switch;
    }
  };
  for (const int i : members_of(island)) {
    for (const int spring : field_.switching_springs(i)) {
      // A spring between two members is theirs both.
      if (field_.spring_body(spring) == i || island.group < 0) look_at(spring);
    }
  }
  if (island.group >= 0) {
    for (const int link : links_.strings(island.group)) look_at(field_.springs() + link);
  }
  if (island.switching < 0) return;
  for (const int i : members_of(island)) at_end_.col(i) = at(i, first);
  island.end = first;
}

}  // namespace carom
