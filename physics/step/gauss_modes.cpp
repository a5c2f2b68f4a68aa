#include "physics/step/gauss_modes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/math/roots.h"
#include "physics/model/pair_size.h"

namespace carom {
namespace {

// When contacts are looked at on the way, of the step.
constexpr std::array<double, 3> kTimes{kGaussPoints[0], 0.5, kGaussPoints[1]};
// Of the step: a mode that ends before this part has not begun, and one that ends after the rest holds.
constexpr double kAtOnce = 1e-6;
// Of the largest force of an island: forces beyond a limit by less are at it.
constexpr double kAtLimit = 1e-7;
// Relative to the size: contacts without a force may be closed so far by rounding.
constexpr double kOpen = 1e-9;
// Times what is rounding: motions that are more.
constexpr double kSeen = 4.0;
constexpr double kBegins = 256.0;  // as a rate at the start
// Times the gaps on the way by the step: the fastest slip that has no other cause.
constexpr double kOnTheWay = 16.0;

// How the polynomial that is 0 at the start, with as many derivatives as `power` is above 1, begins: its first
// coefficient, of t^power, from its values at kTimes.
double beginning(const std::array<double, 3>& values, int power) {
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    double weight = 1.0 / std::pow(kTimes[i], power);
    const double other = kTimes[(i + 1) % 3];
    const double third = kTimes[(i + 2) % 3];
    weight *= other / (other - kTimes[i]) * third / (third - kTimes[i]);
    sum += weight * values[i];
  }
  return sum;
}

// The part of a step in which a margin is positive that has these values at the Gauss points and is linear; 0
// if not at the start. Margins within `rounding` of 0 are so.
double part_held(double first, double second, double rounding) {
  const double start = gauss_share(0, 0.0) * first + gauss_share(1, 0.0) * second;
  const double end = gauss_share(0, 1.0) * first + gauss_share(1, 1.0) * second;
  if (end >= -rounding) return start >= -rounding ? 1.0 : 0.0;
  return start > 0.0 ? start / (start - end) : 0.0;
}

// m/s: how fast the gaps that an island is left with are closed.
double closing(const GaussStep& step, const GaussIsland& island) {
  double most = 0.0;
  for (const GaussContact& c : island.closed()) {
    if (c.presses) most = std::max(most, std::abs(c.end.gap - c.start.gap) / step.h);
  }
  return most;
}

// s: the first of the sampled times at which a contact slips against its direction, the first of all if it
// begins so; 0: none. One that others may hold moves with them as they close their gaps.
double slips_back(const GaussStep& step, const GaussIsland& island, const GaussContact& c) {
  const std::array<double, 3> slips{c.at[0].slip, c.halfway.slip, c.at[1].slip};
  const double rounding =
      closed_within(step, c.a, c.b, c.at[0].point) / step.h + (c.at_limit ? closing(step, island) : 0.0);
  const auto against = [&](double slip) { return c.slips * slip < -kSeen * rounding; };
  const auto first = std::find_if(slips.begin(), slips.end(), against);
  if (first != slips.end()) return kTimes[static_cast<std::size_t>(first - slips.begin())] * step.h;
  if (against(c.end.slip)) return step.h;
  if (c.broke_away || c.slips * c.start.slip > step.slip_speed) return 0.0;
  const double gains =
      beginning({slips[0] - c.start.slip, slips[1] - c.start.slip, slips[2] - c.start.slip}, 1);
  return c.slips * gains < -kBegins * rounding ? kTimes[0] * step.h : 0.0;
}

// s: when a contact stops slipping that slips against its direction at `wrong`, on the present flights.
double slip_ends(const GaussStep& step, const GaussContact& c, double wrong) {
  Trajectories& trajectories = step.world.trajectories;
  const auto slip = [&](double time) {
    Contact contact;
    RowVelocity velocity{};
    const auto at = [&](BodyIndex body) {
      return posed(step.world, body, trajectories.kinematics(body, time));
    };
    (void)find_contact(step, c, at(c.a), at(c.b), contact, velocity);
    return c.slips * velocity.tangential;
  };
  return bracketed_root(slip, 0.0, c.slips * c.start.slip, wrong, slip(wrong));
}

// Whether a contact that does not press closes from the start on.
bool begins_to_close(const GaussStep& step, const GaussContact& c, double rounding) {
  if (std::abs(c.start.parting) > step.tolerance) return false;
  const std::array<double, 3> gaps{c.at[0].gap, c.halfway.gap, c.at[1].gap};
  const auto opened = [&](std::size_t i) {
    return gaps[i] - c.start.gap - kTimes[i] * step.h * c.start.parting;
  };
  return beginning({opened(0), opened(1), opened(2)}, 2) < -kBegins * rounding;
}

// Whether one that closes opens first: it comes back as a landing.
bool comes_back(const GaussStep& step, const GaussContact& c) {
  const double rounding = closed_within(step, c.a, c.b, c.at[0].point);
  return step.is_of_few() && step.least < step.h && c.at[0].gap > c.start.gap + kSeen * rounding &&
         !begins_to_close(step, c, rounding);
}

// N
double largest_force(const GaussIsland& island) {
  double largest = 0.0;
  for (const GaussContact& c : island.closed())
    largest = std::max({largest, c.at[0].normal_force, c.at[1].normal_force});
  return largest;
}

// N: up to which the contacts of a face stick, at the Gauss points.
std::array<double, 2> most_friction(const GaussStep& step, const GaussIsland& island, int face) {
  std::array<double, 2> most{};
  for (const GaussContact& c : island.closed()) {
    if (c.face != face || !c.presses) continue;
    for (const std::size_t k : {0U, 1U})
      most[k] += step.found.contacts.static_friction[c.contact] * c.at[k].normal_force;
  }
  return most;
}

// m: how far the contacts that press are open or closed in between, where linear forces can't do more.
double gaps_on_the_way(const GaussIsland& island) {
  double most = 0.0;
  for (const GaussContact& c : island.closed()) {
    if (!c.presses) continue;
    for (const double gap : {c.at[0].gap, c.halfway.gap, c.at[1].gap, c.end.gap})
      most = std::max(most, std::abs(gap - c.start.gap));
  }
  return most;
}

// Whether a contact that others were to hold still slips.
bool slips_on(const GaussStep& step, const GaussIsland& island, const GaussContact& c) {
  const double slip = std::max(
      {std::abs(c.at[0].slip), std::abs(c.halfway.slip), std::abs(c.at[1].slip), std::abs(c.end.slip)});
  return slip > step.slip_speed + kOnTheWay * gaps_on_the_way(island) / step.h;
}

// Of several contacts that share what fewer would hold, the one of these that presses least.
template <class IsIdle>
GaussContact* idle_contact(GaussIsland& island, const IsIdle& is_idle) {
  if (!island.is_redundant()) return nullptr;
  GaussContact* idle = nullptr;
  const auto mean = [](const GaussContact& c) { return c.at[0].normal_force + c.at[1].normal_force; };
  for (GaussContact& c : island.closed()) {
    if (!c.presses || c.spared || !is_idle(c)) continue;
    if (idle == nullptr || mean(c) < mean(*idle)) idle = &c;
  }
  return idle;
}

void spare(GaussContact& c) {
  c.presses = false;
  c.spared = true;
}

}  // namespace

bool closes(const GaussStep& step, const GaussContact& c, double off) {
  const double rounding = std::max(closed_within(step, c.a, c.b, c.at[0].point), off);
  const std::array<double, 3> gaps{c.at[0].gap, c.halfway.gap, c.at[1].gap};
  const double least = std::min(c.end.gap, *std::min_element(gaps.begin(), gaps.end()));
  if (least < std::min(c.start.gap, 0.0) - kSeen * rounding) return true;
  return begins_to_close(step, c, rounding);
}

bool ask_less(GaussIsland& island) {
  if (!island.is_redundant()) return false;
  bool any = false;
  for (GaussContact& c : island.closed()) {
    if (!c.presses || !c.sticks || c.held_still) continue;
    c.sticks = false;
    c.slips = 0.0;
    c.held_still = any = true;
  }
  if (any) return true;
  GaussContact* idle = idle_contact(island, [](const GaussContact&) { return true; });
  if (idle != nullptr) spare(*idle);
  return idle != nullptr;
}

bool change_modes(const GaussStep& step, GaussIsland& island, double& ends) {
  bool changed = false;
  const auto enter = [&](double part, const auto& change) {
    if (part <= kAtOnce) {
      change();
      changed = true;
    } else if (part < 1.0 - kAtOnce) {
      ends = std::min(ends, part * step.h);
    }
  };
  const double rounding = kAtLimit * largest_force(island);
  const auto lets_go = [&](const GaussContact& c) {
    return part_held(c.at[0].normal_force, c.at[1].normal_force, rounding) < 1.0;
  };
  if (GaussContact* idle = idle_contact(island, lets_go)) {
    spare(*idle);
    return true;
  }
  for (GaussContact& c : island.closed()) {
    if (!c.presses) {
      const bool meets = closes(step, c, c.spared ? gaps_on_the_way(island) : 0.0);
      c.comes_back = meets && comes_back(step, c);
      if (meets && !c.comes_back) {
        c.presses = true;
        changed = true;
      }
      continue;
    }
    const double first = c.at[0].normal_force;
    const double second = c.at[1].normal_force;
    enter(part_held(first, second, rounding), [&] { c.presses = false; });
    if (!c.presses || !step.found.contacts.rubs(c.contact)) continue;
    const auto set_face = [&](bool sticks, double slips, bool at_limit) {
      for (GaussContact& other : island.closed()) {
        if (other.face != c.face) continue;
        other.sticks = sticks;
        other.slips = slips;
        other.at_limit = at_limit;
      }
    };
    if (c.held_still) {
      if (!c.sticks && slips_on(step, island, c)) enter(0.0, [&] { set_face(true, 0.0, false); });
    } else if (c.holds) {
      const std::array<double, 2> most = most_friction(step, island, c.face);
      for (const double sign : {1.0, -1.0}) {
        const double part = part_held(most[0] - sign * c.at[0].tangential_force,
                                      most[1] - sign * c.at[1].tangential_force, rounding);
        // The body may still be held by others: kinetic friction acts where it does slip.
        const bool larger =
            step.found.contacts.static_friction[c.contact] > step.found.contacts.kinetic_friction[c.contact];
        // Breaking away within a part that can't be divided waits for its end.
        if (step.is_of_few() && part > kAtOnce && step.least >= step.h) continue;
        enter(part, [&] { set_face(false, -sign, larger); });
        if (part < 1.0) island.note_break(c.face, part * step.h, -sign);
      }
    } else if (const double wrong = c.sticks ? 0.0 : slips_back(step, island, c); wrong > 0.0) {
      const bool slid = c.slips * c.start.slip > step.slip_speed;
      enter(slid ? slip_ends(step, c, wrong) / step.h : 0.0, [&] { set_face(true, 0.0, false); });
    } else if (c.at_limit && c.slips * c.end.slip > kSeen * step.tolerance) {
      enter(0.0, [&] { set_face(false, c.slips, false); });
    }
  }
  return changed;
}

bool stay_open(const GaussStep& step, const GaussIsland& island) {
  const Contacts& found = step.found.contacts;
  const std::vector<GaussContact>& closed = island.closed();
  return std::none_of(island.contacts().begin(), island.contacts().end(), [&](int i) {
    const bool may_close = std::any_of(closed.begin(), closed.end(), [&](const GaussContact& c) {
      return c.contact == i && (c.presses || c.comes_back);
    });
    if (may_close) return false;
    Contact contact;
    RowVelocity velocity;
    if (!find_contact(step.world, found.a[i], island.at_end(found.a[i]), found.b[i], island.at_end(found.b[i]),
                      step.found.id[static_cast<std::size_t>(i)], contact, velocity))
      return false;
    const double size = pair_size(step.world.shapes(), found.a[i], found.b[i]);
    return contact.gap < std::min(found.gap[i], 0.0) - kOpen * size;
  });
}

}  // namespace carom
