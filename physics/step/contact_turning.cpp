#include "physics/step/contact_turning.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "physics/contact/contact_velocity.h"
#include "physics/step/contact_arms.h"
#include "physics/step/contact_at_end.h"
#include "physics/step/neighbours.h"
#include "physics/step/pair_motion.h"

namespace carom {
namespace {

// Relative to the size: bodies that move less against each other don't turn their contacts.
constexpr double kStill = 1e-11;
// Relative to the smaller body: gaps at the end that are left. Where many contacts hold each other they cannot
// all close, and would push each other to and fro for ever.
constexpr double kLeft = 1e-11;
// Of what presses a contact in a step: the fastest that an overlap may part it.
constexpr double kMostParting = 0.5;
// Likewise: a contact that closes faster at the end under the guessed forces hits, and keeps its normal.
constexpr double kMostClosing = 0.5;
// Of the size, and in rad: if guessed forces change the path or the angle of a body in a step by more, they are
// those of an impact, which don't go on, and tell nothing of where its contacts will be.
constexpr double kMostGuessed = 0.05;
// Times what presses a contact in a step: likewise, for the change of a body's speed.
constexpr double kMostSudden = 30.0;

// Cosine: beyond, the guess has led a disc through what it touches, not off a corner.
constexpr double kThrough = -0.5;

Flown flown(const World& world, double h, const GuessedFlight& flight, BodyIndex body) {
  const Eigen::Vector3d from = world.trajectories.at_start(body).head<3>();
  const Eigen::Vector3d to = flight.position.col(body);
  return {body, flight.pose[static_cast<std::size_t>(body)], to - from, arm_start(world, h, flight, body),
          flight.goes_on[static_cast<std::size_t>(body)] != 0};
}

bool moved(const World& world, const Flown& a, const Flown& b) {
  const double size_a = world.shapes().size[a.body];
  const double size_b = world.shapes().size[b.body];
  const double turned = std::abs(a.moved[2]) * size_a + std::abs(b.moved[2]) * size_b;
  return (a.moved - b.moved).head<2>().norm() + turned > kStill * (size_a + size_b);
}

void set_arms(Contacts& c, int i, const Vec2& point, const Flown& a, const Flown& b) {
  c.arm_a[i] = point - a.mean;
  c.arm_b[i] = point - b.mean;
}

// m/s: the velocities of contact i at the step's end, as guessed.
RowVelocity end_velocity(const Contacts& c, int i, const Vec2& point, const Vec2& normal, const Flown& a,
                         const Flown& b, const Eigen::Matrix3Xd& velocity) {
  return contact_velocity(normal, point - a.end.position, point - b.end.position, velocity.col(c.a[i]),
                          velocity.col(c.b[i]));
}

// Whether what is round runs off a corner: without the contact's own guessed force (m/s², of the pair along the
// normal) it would be off its surface at the end, and part from it.
bool leaves(const Contacts& c, int i, const GuessedEnd& end, double own, double h, const Flown& a,
            const Flown& b, const Eigen::Matrix3Xd& velocity) {
  const double parting = end_velocity(c, i, end.point, end.normal, a, b, velocity).normal;
  const double turned = end.normal.dot(c.normal[i]);
  const double along_end = own * turned;
  return turned > kThrough && end.gap - 0.5 * along_end * h * h > 0.0 && parting - along_end * h > 0.0;
}

// Puts contact i where the moments of forces are taken, `along` the way to the end, and its targets to what
// the end asks for. Its arms start where those of all others of its bodies do, also where nothing moves: else
// their moments would not balance. Returns how fast the contact parts at the end, as guessed (m/s).
double turn_contact(Contacts& c, int i, const Vec2& start, const GuessedEnd& end, const Flown& a,
                    const Flown& b, const Eigen::Matrix3Xd& velocity, double along) {
  const RowVelocity at_end = end_velocity(c, i, end.point, end.normal, a, b, velocity);
  c.normal[i] = ((1.0 - along) * c.normal[i] + along * end.normal).normalized();
  set_arms(c, i, start + along * (end.point - start), a, b);
  const RowVelocity middle = contact_velocity(c, i, velocity);
  c.target[i] += middle.normal - at_end.normal;
  c.slip_target[i] = middle.tangential - at_end.tangential;
  return at_end.normal;
}

}  // namespace

void note_going_on(const World& world, double h, GuessedFlight& flight) {
  flight.goes_on.assign(static_cast<std::size_t>(world.bodies()), 1);
  for (BodyIndex i{0}; i < world.bodies(); ++i) {
    if (world.infinite_mass(i)) continue;
    const Eigen::Vector3d change = flight.velocity.col(i) - world.trajectories.at_start(i).segment<3>(3);
    const double size = world.shapes().size[i];
    flight.goes_on[static_cast<std::size_t>(i)] =
        h * change.head<2>().norm() <= kMostGuessed * size && h * std::abs(change[2]) <= kMostGuessed &&
        change.head<2>().norm() + std::abs(change[2]) * size <= kMostSudden * h * flight.press[i];
  }
}

void turn_contacts(World& world, double h, const GuessedFlight& flight, const Neighbours& neighbours,
                   FoundContacts& found) {
  Contacts& c = found.contacts;
  const Geometry& shapes = world.shapes();
  const StepArms arms = arms_of(world.method.integrator);
  std::fill(found.returns.begin(), found.returns.end(), 0.0);
  for (int first = 0, last = 0; first < c.size(); first = last) {
    const BodyIndex ka = c.a[first];
    const BodyIndex kb = c.b[first];
    while (last < c.size() && c.a[last] == ka && c.b[last] == kb) ++last;
    const Flown a = flown(world, h, flight, ka);
    const Flown b = flown(world, h, flight, kb);
    const bool goes_on = a.goes_on && b.goes_on;
    const bool turns = moved(world, a, b);
    ContactsAtEnd ends(world, found, flight, a, b, neighbours.of_pair(world, ka, kb));
    for (int i = first; i < last; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const bool round = may_turn_far(shapes, parts_at(shapes, ka, kb, found.id[k]));
      if (!goes_on && !round) {
        set_arms(c, i, found.point[k], a, b);
        continue;
      }
      const double allowed = c.target[i];
      std::optional<GuessedEnd> at;
      if (turns) {
        ends.look(i);
        at = ends.same();
      }
      const double press = (std::max(found.press[k], 0.0) + turning_press(world, c, i)) * h;
      const bool turns_far = !goes_on || (at && at->normal.dot(c.normal[i]) <= kLeastCosine);
      const double own = found.guess[k][0] * (world.mass().inverse_mass[ka] + world.mass().inverse_mass[kb]);
      if (round && at && turns_far && leaves(c, i, *at, own, h, a, b, flight.velocity)) {
        turn_contact(c, i, found.point[k], *at, a, b, flight.velocity, arms.along);
        continue;
      }
      if (!goes_on) {
        set_arms(c, i, found.point[k], a, b);
        continue;
      }
      // Where another contact still holds what comes onto this one, nothing presses this one yet.
      const double held = std::max(press, h * std::max(flight.press[ka], flight.press[kb]));
      GuessedEnd guess{found.point[k] + 0.5 * (a.moved + b.moved).head<2>(), c.normal[i], c.gap[i]};
      if (turns) guess = ends.carried();
      if (at && at->normal.dot(c.normal[i]) > kLeastCosine &&
          end_velocity(c, i, at->point, at->normal, a, b, flight.velocity).normal >= -kMostClosing * held)
        guess = *at;
      const double parting = turn_contact(c, i, found.point[k], guess, a, b, flight.velocity, arms.along);
      if (found.is_new(i) || !std::isfinite(allowed)) continue;
      // The gap at the end if the contact did not part or close there.
      const double off = guess.gap - arms.reach * h * parting;
      const double most = kLeft * smaller_size(world, ka, kb);
      const double returns = off - std::clamp(off, -most, most);
      found.returns[k] = std::min(-returns / std::max(h, world.method.step), kMostParting * press);
      c.target[i] += found.returns[k] - allowed;
    }
  }
}

}  // namespace carom
