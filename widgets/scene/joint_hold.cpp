#include "widgets/scene/joint_hold.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

#include "physics/scene/scene.h"

namespace carom {
namespace {

constexpr double kRounding = 1e-13;  // of lengths and places
constexpr int kSteps = 60;           // of Gauss and Newton
constexpr double kAllowed = 1e-9;    // of the speeds: less against a joint is rounding

const Body* named(std::span<const Body> bodies, const std::string& name) {
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; });
  return name.empty() || found == bodies.end() ? nullptr : &*found;
}

bool at_one_place(const Joint& joint) {
  return joint.kind == JointKind::kPin || joint.kind == JointKind::kWeld;
}

Vec2 end_of(const Hold& hold, std::span<const Body> bodies) {
  const Body& body = bodies[hold.body];
  return body.position + turned_by(body.angle, hold.point);
}

Vec2 velocity_of(const Body& body, const Vec2& place) {
  return body.velocity + body.spin * crossed(place - body.position);
}

// m, below which two lengths are the same.
double rounding(const Hold& hold, std::span<const Body> bodies) {
  return kRounding * (hold.length + hold.anchor.norm() + end_of(hold, bodies).norm());
}

// What the other end is: at rest in the plane, or on a body.
void fix_other_end(Hold& hold, const Body* other) {
  const Vec2& local = hold.at_body ? hold.joint.anchor : hold.joint.point;
  hold.velocity = Vec2::Zero();
  hold.anchor = local;
  if (other == nullptr) return;
  hold.anchor = other->position + turned_by(other->angle, local);
  hold.velocity = velocity_of(*other, hold.anchor);
  hold.turned = other->angle;
}

// The rows a·x = b that the holds demand of a change of all places, or of all velocities.
struct Rows {
  std::vector<Vec2> a;
  std::vector<double> b;

  void add(const Vec2& direction, double value) {
    a.push_back(direction);
    b.push_back(value);
  }
  // The least x.
  [[nodiscard]] Vec2 solution() const {
    const auto n = static_cast<Eigen::Index>(a.size());
    Eigen::MatrixX2d matrix(n, 2);
    Eigen::VectorXd right(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      matrix.row(i) = a[static_cast<std::size_t>(i)].transpose();
      right[i] = b[static_cast<std::size_t>(i)];
    }
    return matrix.completeOrthogonalDecomposition().solve(right);
  }
};

Vec2 along(const Hold& hold, std::span<const Body> bodies) {
  const Vec2 line = end_of(hold, bodies) - hold.anchor;
  return line.norm() > 0.0 ? Vec2(line.normalized()) : Vec2(Vec2::UnitX());
}

Rows missing_places(std::span<const Hold> holds, std::span<const Body> bodies) {
  Rows rows;
  for (const Hold& hold : holds) {
    const Vec2 apart = end_of(hold, bodies) - hold.anchor;
    if (at_one_place(hold.joint)) {
      rows.add(Vec2::UnitX(), -apart.x());
      rows.add(Vec2::UnitY(), -apart.y());
    } else if (hold.joint.kind == JointKind::kRod || apart.norm() > hold.length) {
      rows.add(along(hold, bodies), hold.length - apart.norm());
    }
  }
  return rows;
}

void turn_about(std::vector<Body>& bodies, const Vec2& place, double angle) {
  for (Body& body : bodies) {
    body.position = place + turned_by(angle, body.position - place);
    body.velocity = turned_by(angle, body.velocity);
    body.angle += angle;
  }
}

// Edited bodies that move as one, and what holds them; holds count the members.
struct HeldGroup {
  std::vector<std::size_t> members;
  std::vector<Hold> holds;

  [[nodiscard]] std::vector<Body> of(std::span<const Body> bodies) const {
    std::vector<Body> own;
    for (const std::size_t member : members) own.push_back(bodies[member]);
    return own;
  }
  void put(std::span<const Body> own, std::vector<Body>& bodies) const {
    for (std::size_t k = 0; k < members.size(); ++k) bodies[members[k]] = own[k];
  }
};

std::vector<HeldGroup> groups_of(std::span<const Hold> holds) {
  std::vector<HeldGroup> groups;
  for (const Hold& hold : holds) {
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const HeldGroup& each) { return each.members == hold.moves; });
    if (group == groups.end()) group = groups.insert(group, {hold.moves, {}});
    Hold& own = group->holds.emplace_back(hold);
    own.body = static_cast<std::size_t>(std::lower_bound(hold.moves.begin(), hold.moves.end(), hold.body) -
                                        hold.moves.begin());
  }
  return groups;
}

// In rising order.
std::vector<std::size_t> coupled_to(std::size_t body, std::span<const Body> bodies,
                                    std::span<const Joint> joints) {
  std::vector<bool> in(bodies.size(), false);
  in[body] = true;
  for (bool more = true; std::exchange(more, false);) {
    for (const Joint& joint : joints) {
      const Body* a = named(bodies, joint.body);
      const Body* b = named(bodies, joint.to);
      if (a == nullptr || b == nullptr) continue;
      const auto of_a = static_cast<std::size_t>(a - bodies.data());
      const auto of_b = static_cast<std::size_t>(b - bodies.data());
      if (in[of_a] == in[of_b]) continue;
      in[of_a] = in[of_b] = more = true;
    }
  }
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < in.size(); ++i) {
    if (in[i]) found.push_back(i);
  }
  return found;
}

// A move of pinned bodies, as a turn about the first pin.
void swing(std::vector<Body>& bodies, std::span<const Body> from, const Hold& pin, const Vec2& grip) {
  const Vec2 moved = bodies[0].position - from[0].position;
  bodies.assign(from.begin(), from.end());
  const Vec2 before = grip - pin.anchor;
  const Vec2 after = before + moved;
  turn_about(bodies, pin.anchor, std::atan2(cross(before, after), before.dot(after)));
}

bool hold_velocities_as_one(std::vector<Body>& bodies, std::span<const Hold> holds) {
  Rows rows;
  double wrong = 0.0;
  double speed = 0.0;
  for (const Hold& hold : holds) {
    const Body& body = bodies[hold.body];
    if (has_infinite_mass(body) || hold.joint.kind == JointKind::kString) continue;
    const Vec2 relative = velocity_of(body, end_of(hold, bodies)) - hold.velocity;
    const Vec2 line = along(hold, bodies);
    const bool rod = hold.joint.kind == JointKind::kRod;
    if (rod) {
      rows.add(line, -line.dot(relative));
    } else {
      rows.add(Vec2::UnitX(), -relative.x());
      rows.add(Vec2::UnitY(), -relative.y());
    }
    wrong = std::max(wrong, rod ? std::abs(line.dot(relative)) : relative.norm());
    speed = std::max(speed, body.velocity.norm() + hold.velocity.norm());
  }
  if (wrong <= kAllowed * speed) return false;
  const Vec2 change = rows.solution();
  for (Body& body : bodies) {
    if (!has_infinite_mass(body)) body.velocity += change;
  }
  return true;
}

std::optional<std::vector<Body>> held_as_one(std::span<const Body> from, std::span<const Body> wanted,
                                             std::span<const Hold> holds, const Vec2& grip) {
  std::vector<Body> bodies(wanted.begin(), wanted.end());
  const auto pin = std::find_if(holds.begin(), holds.end(),
                                [](const Hold& hold) { return hold.joint.kind == JointKind::kPin; });
  const bool moves = from[0].angle == wanted[0].angle && from[0].position != wanted[0].position;
  if (pin != holds.end() && moves) swing(bodies, from, *pin, grip);
  for (int step = 0; step < kSteps; ++step) {
    const Rows rows = missing_places(holds, bodies);
    if (rows.a.empty()) break;
    const Vec2 change = rows.solution();
    for (Body& body : bodies) body.position += change;
    if (change.norm() <= 0.1 * kRounding * bodies[0].position.norm()) break;
  }
  if (!std::all_of(holds.begin(), holds.end(), [&](const Hold& hold) { return keeps(hold, bodies); })) {
    return std::nullopt;
  }
  hold_velocities_as_one(bodies, holds);
  return bodies;
}

}  // namespace

std::string name_for_people(const Joint& joint, std::span<const Joint> joints) {
  if (!joint.name.empty()) return joint.name;
  std::string name(name_of(kJointNames, joint.kind));
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  int number = 0;
  for (const Joint& other : joints) {
    if (other.kind == joint.kind) ++number;
    if (&other == &joint) break;
  }
  return name + " " + std::to_string(number);
}

std::vector<Body> followers_of(std::span<const Body> bodies, const Surroundings& neighbours) {
  std::vector<Body> followers;
  const auto comes = [&](const std::string& name) {
    return named(bodies, name) != nullptr || named(followers, name) != nullptr;
  };
  for (bool more = true; std::exchange(more, false);) {
    for (const Joint& joint : neighbours.joints) {
      if (!at_one_place(joint) || joint.to.empty() || comes(joint.body) == comes(joint.to)) continue;
      const Body* other = named(neighbours.bodies, comes(joint.body) ? joint.to : joint.body);
      if (other == nullptr || (joint.kind == JointKind::kPin && has_infinite_mass(*other))) continue;
      followers.push_back(*other);
      more = true;
    }
  }
  return followers;
}

void move_along(std::vector<Body>& followers, const Body& before, const Body& after) {
  const double turn = after.angle - before.angle;
  for (Body& body : followers) {
    body.position = after.position + turned_by(turn, body.position - before.position);
    body.angle += turn;
    if (has_infinite_mass(body)) continue;
    const double spun = after.spin - before.spin;
    body.velocity = after.velocity + turned_by(turn, body.velocity - before.velocity) +
                    spun * crossed(body.position - after.position);
    body.spin += spun;
  }
}

std::vector<Hold> holds_of(std::span<const Body> bodies, const Surroundings& neighbours) {
  std::vector<Hold> holds;
  for (const Joint& joint : neighbours.joints) {
    const Body* first = named(bodies, joint.body);
    const Body* second = named(bodies, joint.to);
    if ((first == nullptr) == (second == nullptr)) continue;
    const bool at_body = first != nullptr;
    const Body* body = at_body ? first : second;
    const Body* other = named(neighbours.bodies, at_body ? joint.to : joint.body);
    if (other == nullptr && !(at_body && joint.to.empty())) continue;
    Hold hold{.joint = joint,
              .body = static_cast<std::size_t>(body - bodies.data()),
              .moves = coupled_to(static_cast<std::size_t>(body - bodies.data()), bodies, neighbours.joints),
              .at_body = at_body,
              .point = at_body ? joint.point : joint.anchor,
              .anchor = {},
              .length = 0.0,
              .velocity = {},
              .name = name_for_people(joint, neighbours.joints)};
    fix_other_end(hold, other);
    if (!at_one_place(joint)) hold.length = joint.length.value_or(length_of(hold, bodies));
    hold.angle = body->angle - hold.turned;
    holds.push_back(std::move(hold));
  }
  return holds;
}

double length_of(const Hold& hold, std::span<const Body> bodies) {
  return (end_of(hold, bodies) - hold.anchor).norm();
}

bool keeps(const Hold& hold, std::span<const Body> bodies) {
  const double longer = length_of(hold, bodies) - hold.length;
  const double turn = bodies[hold.body].angle - hold.turned - hold.angle;
  if (hold.joint.kind == JointKind::kWeld && std::abs(turn) > kRounding) return false;
  if (hold.joint.kind == JointKind::kString) return longer <= rounding(hold, bodies);
  return std::abs(longer) <= rounding(hold, bodies);
}

std::optional<std::vector<Body>> held(std::span<const Body> from, std::span<const Body> wanted,
                                      std::span<const Hold> holds, const Vec2& grip) {
  std::vector<Body> bodies(wanted.begin(), wanted.end());
  for (const HeldGroup& group : groups_of(holds)) {
    const std::vector<Body> own_from = group.of(from);
    const Vec2 own_grip = group.members[0] == 0 ? grip : own_from[0].position;
    const std::optional<std::vector<Body>> own = held_as_one(own_from, group.of(wanted), group.holds, own_grip);
    if (!own) return std::nullopt;
    group.put(*own, bodies);
  }
  return bodies;
}

bool hold_velocities(std::vector<Body>& bodies, std::span<const Hold> holds) {
  bool changed = false;
  for (const HeldGroup& group : groups_of(holds)) {
    std::vector<Body> own = group.of(bodies);
    if (!hold_velocities_as_one(own, group.holds)) continue;
    group.put(own, bodies);
    changed = true;
  }
  return changed;
}

Joint refitted(const Hold& hold, std::span<const Body> bodies) {
  Joint joint = hold.joint;
  if (keeps(hold, bodies)) return joint;
  if (!at_one_place(joint)) {
    joint.length = length_of(hold, bodies);
    return joint;
  }
  // The other end's place along its body's axes; the plane has none of its own.
  const Vec2 apart = end_of(hold, bodies) - hold.anchor;
  Vec2& other = hold.at_body ? joint.anchor : joint.point;
  other += turned_by(-hold.turned, apart);
  if (joint.angle) {
    const double angle = bodies[hold.body].angle - hold.turned;
    joint.angle = hold.at_body ? angle : -angle;
  }
  return joint;
}

}  // namespace carom
