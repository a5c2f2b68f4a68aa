#include "physics/step/contact_work.h"

#include <algorithm>
#include <utility>

#include "physics/contact/contact_velocity.h"
#include "physics/dynamics/integrators/integrators.h"
#include "physics/math/vectors.h"
#include "physics/step/apply_impact.h"
#include "physics/step/contact_arms.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// Normals of contacts of one pair are the same within this.
constexpr double kOneNormal = 1e-9;

// m: where a body is while contact forces act on it for `passed` s, such that their moment is what they change
// of its angular momentum about the origin. Where they lead to themselves is left out, as in arm_start().
Vec2 mean_place(World& world, double passed, const GuessedFlight& flight, BodyIndex body) {
  const Vec2 from = world.state.position(body);
  const Vec2 straight = passed * world.state.v.col(body).head<2>();
  if (!choice_of(kIntegrators, world.method.integrator).exact_under_gravity)
    return from + arms_of(world.method.integrator).along * straight;
  const Vec2 by_contacts = 0.5 * passed * passed * flight.by.col(body).head<2>();
  const Vec2 bend = world.trajectories.at(body, passed).head<2>() - from - straight - by_contacts;
  return from + 0.5 * straight + bend / 3.0;
}

// Whether bodies land here: a contact is new, or open by more than a method of order 1 leaves where a surface
// turns away.
bool is_landing(const World& world, const FoundContacts& found, int i) {
  if (found.is_new(i)) return true;
  const Contacts& c = found.contacts;
  double touching = touch_tolerance(world, c.a[i], c.b[i]);
  if (choice_of(kIntegrators, world.method.integrator).order == 1)
    touching += found.press[static_cast<std::size_t>(i)] * world.method.step * world.method.step;
  return c.gap[i] > touching;
}

// J: what contact impulses take along the normals, along the tangents and from rolling.
struct Losses {
  double normal = 0.0;
  double tangential = 0.0;
  double rolling = 0.0;

  [[nodiscard]] Losses positive() const {
    return {std::max(0.0, normal), std::max(0.0, tangential), std::max(0.0, rolling)};
  }
  Losses& operator+=(const Losses& other) {
    normal += other.normal;
    tangential += other.tangential;
    rolling += other.rolling;
    return *this;
  }
};

Losses losses_of(const Contacts& c, int i, const Eigen::Matrix3Xd& mean) {
  const RowVelocity u = contact_velocity(c, i, mean);
  return {-c.normal_impulse[i] * u.normal, -c.tangential_impulse[i] * u.tangential,
          -c.rolling_impulse[i] * u.spin};
}

// The end of the contacts from i on that are of one pair and have one normal.
int end_of_hit(const Contacts& c, int i) {
  int end = i + 1;
  while (end < c.size() && c.a[end] == c.a[i] && c.b[end] == c.b[i] &&
         (c.normal[end] - c.normal[i]).norm() <= kOneNormal)
    ++end;
  return end;
}

// What stops a pair along one normal, at one contact or more.
struct StoppedHit {
  BodyIndex a;
  BodyIndex b;
  Contact contact;                // in the middle of the normal impulses
  std::optional<double> closing;  // m/s, the fastest, if it is an impact
  Impact impact;

  // That of these contacts.
  StoppedHit(const FoundContacts& found, int from, int end, const std::vector<std::optional<double>>& closings,
             const Eigen::Matrix3Xd& mean)
      : a(found.contacts.a[from]), b(found.contacts.b[from]) {
    const Contacts& c = found.contacts;
    contact = {c.gap[from], c.normal[from], Vec2::Zero()};
    for (int i = from; i < end; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (c.normal_impulse[i] == 0.0) continue;
      if (closings[k]) closing = std::max(closing.value_or(*closings[k]), *closings[k]);
      const Losses lost = losses_of(c, i, mean).positive();
      impact.normal += c.normal_impulse[i];
      impact.tangential += c.tangential_impulse[i];
      impact.lost_to_restitution += lost.normal;
      impact.lost_to_friction += lost.tangential;
      contact.point += c.normal_impulse[i] * found.point[k];
    }
    contact.point /= impact.normal;
  }
};

// `place(body)`: where the side that moves is on the mean, in m; with the arm from there, impulses change its
// angular momentum by their moment about the origin.
void record_impulses(World& world, const Contacts& c, int i, double share, const Eigen::Matrix3Xd& mean,
                     const auto& place) {
  const Vec2 j = share * (c.normal_impulse[i] * c.normal[i] + c.tangential_impulse[i] * crossed(c.normal[i]));
  for (const auto& [body, sign] : {std::pair(c.a[i], -1.0), std::pair(c.b[i], 1.0)}) {
    const Vec2& arm = body == c.a[i] ? c.arm_a[i] : c.arm_b[i];
    const double moment = sign * share * c.rolling_impulse[i];
    if (!world.infinite_mass(body)) {
      world.record_angular_momentum(body, Vec2::Zero(), arm, sign * j, moment);
      continue;
    }
    const Vec2 point = body == c.a[i] ? place(c.b[i]) + c.arm_b[i] : place(c.a[i]) + c.arm_a[i];
    world.record_angular_momentum(body, point, arm, sign * j, moment);
    world.sums.ledger.momentum_to_walls += sign * j;
    world.sums.ledger.put_in_by_drives -= sign * j.dot(mean.col(body).template head<2>());
  }
}

}  // namespace

void record_support(World& world, const FoundContacts& found, const GaussContacts& linear, double share,
                    const Eigen::Matrix3Xd& mean, double passed, const GuessedFlight& flight) {
  const Contacts& c = found.contacts;
  // m: from the path of a body to where its contacts' arms start, where those follow the path. They leave out
  // what the contact forces themselves do, which all together do no work there.
  const double bend = arms_of(world.method.integrator).bend * passed * passed / (share * share);
  const auto off = [&](BodyIndex body) -> Vec2 {
    if (world.infinite_mass(body) || flight.goes_on[static_cast<std::size_t>(body)] == 0) return Vec2::Zero();
    return -bend * world.field().contact_acceleration(body).head<2>();
  };
  Losses lost;
  for (int i = 0; i < c.size(); ++i) {
    if (c.normal_impulse[i] == 0.0 || linear.has(i)) continue;
    RowVelocity u = contact_velocity(c, i, mean);
    const Vec2 turning = mean.col(c.b[i])[2] * off(c.b[i]) - mean.col(c.a[i])[2] * off(c.a[i]);
    u.normal -= turning.dot(crossed(c.normal[i]));
    u.tangential += turning.dot(c.normal[i]);
    if (is_landing(world, found, i)) lost.normal -= share * c.normal_impulse[i] * u.normal;
    lost.tangential -= share * c.tangential_impulse[i] * u.tangential;
    lost.rolling -= share * c.rolling_impulse[i] * u.spin;
    record_impulses(world, c, i, share, mean,
                    [&](BodyIndex body) { return mean_place(world, passed, flight, body); });
  }
  // What it is for one contact may be negative, as contacts of one body pass energy on to each other.
  Ledger& ledger = world.sums.ledger;
  ledger.lost_to_restitution += std::max(0.0, lost.normal);
  ledger.lost_to_friction += std::max(0.0, lost.tangential);
  ledger.lost_to_rolling += std::max(0.0, lost.rolling);
}

void record_stops(World& world, const FoundContacts& found, const std::vector<std::optional<double>>& closing,
                  const Eigen::Matrix3Xd& mean, JumpsOfMoment& jumps) {
  const Contacts& c = found.contacts;
  Losses lost;
  Losses positive;
  for (int i = 0; i < c.size(); ++i) {
    if (c.normal_impulse[i] == 0.0) continue;
    const Losses of = losses_of(c, i, mean);
    lost += of;
    positive += of.positive();
    record_impulses(world, c, i, 1.0, mean, [&](BodyIndex body) { return Vec2(world.state.position(body)); });
  }
  // Where normals and tangents are coupled, energy passes from one to the other; only the sum is lost.
  const double all = std::max(0.0, lost.normal + lost.tangential + lost.rolling);
  const double rubbed = std::clamp(lost.tangential, 0.0, all);
  const double rolled = std::clamp(lost.rolling, 0.0, all - rubbed);
  Losses left{all - rubbed - rolled, rubbed, rolled};
  const Losses share{positive.normal > 0.0 ? left.normal / positive.normal : 0.0,
                     positive.tangential > 0.0 ? rubbed / positive.tangential : 0.0, 0.0};
  for (int i = 0; i < c.size();) {
    const int end = end_of_hit(c, i);
    const StoppedHit hit(found, i, end, closing, mean);
    i = end;
    if (!hit.closing) continue;
    Impact impact = hit.impact;
    impact.lost_to_restitution *= share.normal;
    impact.lost_to_friction *= share.tangential;
    left.normal -= impact.lost_to_restitution;
    left.tangential -= impact.lost_to_friction;
    record_impact(world, hit.a, hit.b, hit.contact, impact, *hit.closing, 0.0);
    jumps.add(world);
  }
  Ledger& ledger = world.sums.ledger;
  ledger.lost_to_restitution += left.normal;
  ledger.lost_to_friction += left.tangential;
  ledger.lost_to_rolling += left.rolling;
}

}  // namespace carom
