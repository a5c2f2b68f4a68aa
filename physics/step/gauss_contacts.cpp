#include "physics/step/gauss_contacts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "physics/math/vectors.h"
#include "physics/step/gauss_modes.h"

namespace carom {
namespace {

// Rounds in which contacts change their mode at the start; more where they may be at the limit of static
// friction before they slip.
constexpr int kMostModes = 4;
constexpr int kMostModesAtLimits = 8;
// Of a step: parts that begin and end at one time differ by less.
constexpr double kSameTime = 1e-9;

}  // namespace

void GaussContacts::clear() {
  all_.clear();
  improved_.clear();
}

void GaussContacts::begin_part(double time, double step_length) {
  breaks_.clear();
  std::copy_if(next_.begin(), next_.end(), std::back_inserter(breaks_),
               [&](const GaussBreak& b) { return std::abs(b.time - time) <= kSameTime * step_length; });
  next_.clear();
}

double GaussContacts::improve(World& world, double h, const Neighbours& neighbours, double tolerance,
                              double slip_speed, const Islands& islands, double least, FoundContacts& found) {
  const GaussStep step{world, h, least, neighbours, tolerance, slip_speed, found, breaks_};
  clear();
  h_ = h;
  improved_.assign(static_cast<std::size_t>(found.contacts.size()), 0);
  double ends = h;
  join(step.world, step.found.contacts, islands);
  for (const std::vector<int>& contacts : joined_) {
    if (contacts.empty() || !island_.begin(step, contacts)) continue;
    if (settle(step, ends)) {
      enter(step);
    } else {
      island_.put_back(step);
    }
  }
  if (ends < h) note_breaks(step, ends);
  return ends;
}

void GaussContacts::note_breaks(const GaussStep& step, double ends) {
  next_.clear();
  for (const GaussContact& c : all_) {
    if (c.breaks_at > 0.0 && c.breaks_at <= ends)
      next_.push_back({step.world.trajectories.epoch() + ends, c.a, c.b,
                       step.found.id[static_cast<std::size_t>(c.contact)], c.breaks_to});
  }
}

// Lists the contacts of each island with those of all to which joints join its bodies.
void GaussContacts::join(const World& world, const Contacts& found, const Islands& islands) {
  const Trajectories& trajectories = world.trajectories;
  joined_.resize(static_cast<std::size_t>(islands.size()));
  joined_of_.assign(trajectories.islands().size(), -1);
  for (int k = 0; k < islands.size(); ++k) {
    const std::span<const int> contacts = islands.of(k);
    std::vector<int>& own = joined_[static_cast<std::size_t>(k)];
    own.assign(contacts.begin(), contacts.end());
    for (const int i : contacts) {
      for (const BodyIndex body : {found.a[i], found.b[i]}) {
        if (!trajectories.is_jointed(body)) continue;
        int& at = joined_of_[trajectories.island_of(body)];
        if (at >= 0 && at != k) move_contacts(at, k);
        at = k;
      }
    }
  }
}

// Those of an earlier island to a later one.
void GaussContacts::move_contacts(int from, int to) {
  std::vector<int>& source = joined_[static_cast<std::size_t>(from)];
  std::vector<int>& target = joined_[static_cast<std::size_t>(to)];
  target.insert(target.end(), source.begin(), source.end());
  source.clear();
  std::replace(joined_of_.begin(), joined_of_.end(), from, to);
}

// Finds modes that hold from the start for as long as they are to, and their forces. `ends` becomes no later
// than they do.
bool GaussContacts::settle(const GaussStep& step, double& ends) {
  const Contacts& found = step.found.contacts;
  const bool have_limits = std::any_of(island_.contacts().begin(), island_.contacts().end(), [&](int i) {
    return found.static_friction[i] > found.kinetic_friction[i];
  });
  const int most = have_limits ? kMostModesAtLimits : kMostModes;
  for (int round = 0; round < most; ++round) {
    while (!island_.solve(step)) {
      if (!island_.take_back(step) || !ask_less(island_)) return false;
    }
    double until = step.h;
    if (change_modes(step, island_, until)) continue;
    if (until < step.least || !stay_open(step, island_)) return false;
    ends = std::min(ends, until);
    return true;
  }
  return false;
}

void GaussContacts::enter(const GaussStep& step) {
  Contacts& found = step.found.contacts;
  island_.share_friction(step);
  for (const GaussContact& c : island_.closed()) {
    improved_[static_cast<std::size_t>(c.contact)] = 1;
    found.normal_impulse[c.contact] = 0.5 * step.h * (c.at[0].normal_force + c.at[1].normal_force);
    found.tangential_impulse[c.contact] = 0.5 * step.h * (c.at[0].tangential_force + c.at[1].tangential_force);
    found.normal[c.contact] = (c.at[0].normal + c.at[1].normal).normalized();
    found.sticks[c.contact] = c.sticks || c.at_limit ? 1 : 0;
    if (c.presses) all_.push_back(c);
    if (c.comes_back)
      step.found.landings.push_back({c.a, c.b, step.found.id[static_cast<std::size_t>(c.contact)]});
  }
}

void GaussContacts::record(World& world, double passed) const {
  Ledger& ledger = world.sums.ledger;
  for (const GaussContact& c : all_) {
    for (const std::size_t k : {0U, 1U}) {
      const GaussContact::AtPoint& at = c.at[k];
      const double time = h_ * gauss_share_until(k, passed / h_);  // s
      if (!c.sticks) ledger.lost_to_friction -= time * at.tangential_force * at.slip;
      const Vec2 j = time * (at.normal_force * at.normal + at.tangential_force * crossed(at.normal));
      for (const auto& [body, sign] : {std::pair(c.a, -1.0), std::pair(c.b, 1.0)}) {
        world.record_angular_momentum(body, at.point, body == c.a ? at.arm_a : at.arm_b, sign * j, 0.0);
        if (!world.infinite_mass(body)) continue;
        ledger.momentum_to_walls += sign * j;
        ledger.put_in_by_drives -=
            sign * j.dot(world.trajectories.at(body, kGaussPoints[k] * h_).segment<2>(3));
      }
    }
  }
}

}  // namespace carom
