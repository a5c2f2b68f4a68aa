#include "physics/step/contact_turning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "physics/collision/corner_on_face.h"
#include "physics/collision/pair_contact.h"
#include "physics/contact/contact_velocity.h"
#include "physics/model/convex.h"
#include "physics/step/contact_arms.h"
#include "physics/step/internal_edges.h"
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

// A body in the step.
struct Flown {
  Pose end;
  Eigen::Vector3d moved;  // m and rad
  Vec2 mean;              // m: where the arms of all forces on the body start
  bool goes_on;           // see GuessedFlight
};

Flown flown(const World& world, double h, const GuessedFlight& flight, BodyIndex body) {
  const Eigen::Vector3d from = world.trajectories.at_start(body).head<3>();
  const Eigen::Vector3d to = flight.position.col(body);
  return {flight.pose[static_cast<std::size_t>(body)], to - from, arm_start(world, h, flight, body),
          flight.goes_on[static_cast<std::size_t>(body)] != 0};
}

bool moved(const World& world, int ka, const Flown& a, int kb, const Flown& b) {
  const double size_a = world.shapes().size[ka];
  const double size_b = world.shapes().size[kb];
  const double turned = std::abs(a.moved[2]) * size_a + std::abs(b.moved[2]) * size_b;
  return (a.moved - b.moved).head<2>().norm() + turned > kStill * (size_a + size_b);
}

void set_arms(Contacts& c, int i, const Vec2& point, const Flown& a, const Flown& b) {
  c.arm_a[i] = point - a.mean;
  c.arm_b[i] = point - b.mean;
}

// A contact at the step's end, as guessed.
struct GuessedEnd {
  Vec2 point;  // m
  Vec2 normal;
  double gap = 0.0;  // m
};

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

// m: from a point to the nearest corner of this part of a body.
double from_corner(const World& world, BodyIndex body, ShapeIndex part, const Vec2& point) {
  const Geometry& g = world.shapes();
  double nearest = std::numeric_limits<double>::infinity();
  if (g.shapes.core[part] == Core::kHalfPlane) return nearest;
  const Pose pose = g.part_pose(body, part, pose_at_start(world, body));
  const Vec2 at = pose.turned_back(Vec2(point - pose.position));
  const Corner* corner = g.shapes.corners_of(part);
  for (int k = 0; k < g.shapes.corners[part]; ++k) nearest = std::min(nearest, (corner[k].vertex - at).norm());
  return nearest;
}

// Whether one of these parts is round where they touch, and the other isn't a disc as well: the contact may
// turn far, about a corner.
bool may_turn_far(const Geometry& g, const ShapePair& parts) {
  const bool discs = g.shapes.core[parts.a] == Core::kPoint && g.shapes.core[parts.b] == Core::kPoint;
  return !discs && g.shapes.rounding[parts.a] + g.shapes.rounding[parts.b] > 0.0;
}

// Where two parts touch at the end, as guessed: in all points, and in those where nothing continues a surface.
struct EndPoints {
  Manifold all, bare;
};
// Whether a contact has come over a seam: another part continues the surface there.
bool slides_on(const EndPoints& end, std::uint32_t id) {
  return point_with(end.bare, id) < 0 && (end.bare.count == 0 || point_with(end.all, id) >= 0);
}

// Contact i at the end: in the same features, a corner on the line of its face, which it has come to the end of
// or which goes on as another part, or what has rolled on from a face to the round corner beside it. Nothing if
// it is none of these.
std::optional<GuessedEnd> same_at_end(const World& world, const FoundContacts& found, int i, const Flown& a,
                                      const Flown& b, const EndPoints& end) {
  const Geometry& g = world.shapes();
  const auto k = static_cast<std::size_t>(i);
  const std::uint32_t id = found.id[k];
  const auto guess = [&](int point) {
    const ManifoldPoint& at = end.bare.points[static_cast<std::size_t>(point)];
    return GuessedEnd{at.point, end.bare.normal, at.gap};
  };
  if (const int point = point_with(end.bare, id); point >= 0) return guess(point);
  const bool over_seam = slides_on(end, id);
  const BodyIndex body_a = found.contacts.a[i];
  const BodyIndex body_b = found.contacts.b[i];
  const auto halfway = [&](BodyIndex body, const Flown& flown) {
    return g.pose(body, world.trajectories.at_start(body).head<3>() + 0.5 * flown.moved);
  };
  const auto corner = corner_on_face(g, body_a, halfway(body_a, a), body_b, halfway(body_b, b), id);
  const double size = g.size[body_a] + g.size[body_b];
  if (corner && (over_seam || is_over_face(g, body_a, a.end, body_b, b.end, *corner, kFlush * size))) {
    const Contact contact = contact_on_line(g, body_a, a.end, body_b, b.end, *corner);
    return GuessedEnd{contact.point, contact.normal, contact.gap};
  }
  if (over_seam || end.bare.count != 1) return std::nullopt;
  const double turned = std::abs(a.moved[2]) * g.size[body_a] + std::abs(b.moved[2]) * g.size[body_b];
  const double way = (a.moved - b.moved).head<2>().norm() + turned;
  const Vec2 start = found.point[k] + 0.5 * (a.moved + b.moved).head<2>();
  const bool is_near = (end.bare.points[0].point - start).norm() <= way;
  if (may_turn_far(g, parts_at(g, body_a, body_b, id)) && is_near) return guess(0);
  return std::nullopt;
}

// A contact that keeps its normal: its point moves with the disc, with the corner that slides on over a seam,
// or as its bodies do on average. Without `moves`, both bodies move alike.
GuessedEnd carried(const World& world, const Contacts& c, int i, std::uint32_t id, const Vec2& start,
                   const Flown& a, const Flown& b, bool moves, bool slides_on) {
  GuessedEnd end{start, c.normal[i], c.gap[i]};
  if (!moves) {
    end.point += 0.5 * (a.moved + b.moved).head<2>();
  } else {
    const Vec2 by_a = a.moved.head<2>() + a.moved[2] * crossed(c.arm_a[i]);
    const Vec2 by_b = b.moved.head<2>() + b.moved[2] * crossed(c.arm_b[i]);
    end.gap += (by_b - by_a).dot(c.normal[i]);
    const Geometry& g = world.shapes();
    if (g.is_disc(c.a[i]) != g.is_disc(c.b[i])) {
      end.point += (g.is_disc(c.a[i]) ? a : b).moved.head<2>();
    } else if (!slides_on) {
      end.point += 0.5 * (by_a + by_b);
    } else {
      const ShapePair parts = parts_at(g, c.a[i], c.b[i], id);
      const bool of_a = from_corner(world, c.a[i], parts.a, start) < from_corner(world, c.b[i], parts.b, start);
      end.point += of_a ? by_a : by_b;
    }
  }
  return end;
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
    const auto is_round = [&](int i) {
      return may_turn_far(shapes, parts_at(shapes, ka, kb, found.id[static_cast<std::size_t>(i)]));
    };
    const bool turns = moved(world, ka, a, kb, b);
    EndPoints end;
    for (int i = first; i < last; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const bool round = is_round(i);
      if (!goes_on && !round) {
        set_arms(c, i, found.point[k], a, b);
        continue;
      }
      const double allowed = c.target[i];
      if (turns && (i == first || parts_of(found.id[k]) != parts_of(found.id[k - 1]))) {
        end.all =
            manifold_of(shapes, ka, a.end, kb, b.end, found.id[k], std::numeric_limits<double>::infinity());
        // Where a neighbour continues the surface, the contact does not turn about the edge.
        const auto pose = [&](BodyIndex body) { return flight.pose[static_cast<std::size_t>(body)]; };
        const auto others = neighbours.of_pair(world, ka, kb);
        end.bare = exposed_points(world, ka, kb, end.all, others, pose, [](const ManifoldPoint&) {});
        if (end.bare.count == 0 && end.all.count == 1 &&
            turns_about_corner(world, ka, kb, c.normal[i], end.all.contact(0), others, pose))
          end.bare = end.all;
      }
      const std::optional<GuessedEnd> at =
          turns ? same_at_end(world, found, i, a, b, end) : std::optional<GuessedEnd>();
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
      GuessedEnd guess =
          carried(world, c, i, found.id[k], found.point[k], a, b, turns, turns && slides_on(end, found.id[k]));
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
