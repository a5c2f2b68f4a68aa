
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "physics/math/vectors.h"
#include "physics/scene/drive.h"
#include "physics/scene/range_check.h"
#include "physics/scene/value_checks.h"

namespace carom {
namespace {

// Relative tolerance of lengths, coordinates and speeds: that of a file with some seven digits.
constexpr double kSlack = 1e-6;

// Coupled joints are solved together, at a cost that grows with the cube of their number.
constexpr int kMostJointedTogether = 500;

// Groups of bodies that joints connect: a union-find forest of body indices.
class Groups {
 public:
  explicit Groups(std::size_t bodies) : above_(bodies), joints_(bodies, 0) {
    std::iota(above_.begin(), above_.end(), std::size_t{0});
  }
  // Adds a joint between `a` and `b`; returns the number of joints in their group.
  int join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    if (a != b) {
      above_[b] = a;
      joints_[a] += joints_[b];
    }
    return ++joints_[a];
  }

 private:
  std::size_t root(std::size_t i) {
    for (; above_[i] != i; i = above_[i]) above_[i] = above_[above_[i]];
    return i;
  }
  std::vector<std::size_t> above_;
  std::vector<int> joints_;  // by root
};

std::string_view name_of_kind(JointKind kind) { return kind == JointKind::kPin ? "pin" : "weld"; }

// The angle of a weld at the start, and its rate; a point-like body has none.
void check_weld(const std::string& at, const Joint& joint, const Body& body, const Body* other) {
  if (inertia_of(body) == 0.0 || (other != nullptr && inertia_of(*other) == 0.0)) return;
  const double angle = body.angle - (other != nullptr ? other->angle : 0.0);
  if (joint.angle && std::abs(angle - *joint.angle) > kSlack * (1.0 + std::abs(angle))) {
    refuse_by(Rule::kJointedStart, at + "/angle",
              fmt::format("{} of bodies that are turned by {} rad", *joint.angle, angle),
              "their angle, or no \"angle\"");
  }
  const double other_spin = other != nullptr ? other->spin : 0.0;
  const double against = std::abs(body.spin - other_spin);
  // Of bodies that hardly turn, beside their speeds.
  const double speeds = body.velocity.norm() + (other != nullptr ? other->velocity.norm() : 0.0);
  if (against > kSlack * (std::abs(body.spin) + std::abs(other_spin)) &&
      against * bounding_radius(body.shape) > kSlack * speeds) {
    refuse_by(Rule::kJointedStart, at,
              fmt::format("a weld of bodies that turn against each other at {} rad/s", body.spin - other_spin),
              "equal spins");
  }
}

// Positions and velocities of the ends at the start.
void check_start(const std::string& at, const Joint& joint, const Body& body, const Body* other, double time) {
  Body plane;
  plane.fixed = true;
  const Body a = moved_by_drive(body, time);
  const Body b = other != nullptr ? moved_by_drive(*other, time) : plane;
  const Vec2 arm_a = turned_by(a.angle, joint.point);
  const Vec2 arm_b = turned_by(b.angle, joint.anchor);
  const Vec2 d = a.position + arm_a - b.position - arm_b;
  const Vec2 u = a.velocity + a.spin * crossed(arm_a) - b.velocity - b.spin * crossed(arm_b);
  const double distance = d.norm();
  const double speeds =
      a.velocity.norm() + b.velocity.norm() + std::abs(a.spin) * arm_a.norm() + std::abs(b.spin) * arm_b.norm();
  if (joint.kind == JointKind::kPin || joint.kind == JointKind::kWeld) {
    const std::string_view kind = name_of_kind(joint.kind);
    const double size = a.position.norm() + b.position.norm() + arm_a.norm() + arm_b.norm();
    if (distance > kSlack * size)
      refuse_by(Rule::kJointedStart, at, fmt::format("a {} whose ends are {} m apart", kind, distance),
                "ends at one place");
    if (u.norm() > kSlack * speeds)
      refuse_by(Rule::kJointedStart, at, fmt::format("a {} whose ends part at {} m/s", kind, u.norm()),
                "ends that move together");
    if (joint.kind == JointKind::kWeld) check_weld(at, joint, body, other);
    return;
  }
  const double length = joint.length.value_or(distance);
  if (!(length >= kLeastPositive)) {
    refuse_by(Rule::kJointedStart, at, "a length of 0, as the ends are at one place",
              "ends that are apart, a \"length\" for a string, or a pin");
  }
  const bool rod = joint.kind == JointKind::kRod;
  if (distance > (1.0 + kSlack) * length || (rod && distance < (1.0 - kSlack) * length)) {
    refuse_by(Rule::kJointedStart, at + "/length",
              fmt::format("{} for ends that are {} m apart", length, distance),
              rod ? "their distance, or no \"length\"" : "their distance or more");
  }
  if (!rod) return;
  const double rate = d.dot(u) / distance;
  if (std::abs(rate) > kSlack * speeds) {
    refuse_by(Rule::kJointedStart, at,
              fmt::format("a rod whose ends {} at {} m/s", rate > 0.0 ? "part" : "close", std::abs(rate)),
              "velocities and spins that keep its length");
  }
}

}  // namespace

void check_joints(const Scene& scene, const std::vector<Body>& bodies, const RunBegin& begin) {
  NamedBodies named;
  for (const Body& b : bodies) named.emplace(b.name, &b);
  check_count("/links", scene.joints.size(), kMostJoints, "links");
  std::unordered_set<std::string> names;
  Groups groups(bodies.size());
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const Joint& joint = scene.joints[i];
    const std::string at = fmt::format("/links/{}", i);
    check_fields(at, joint);
    if (!joint.name.empty()) check_own_name(names, at + "/name", joint.name);
    const Body* body = &movable_body(named, at + "/body", joint.body);
    const Body* other = nullptr;
    if (!joint.to.empty()) {
      other = &named_body(named, at + "/to", joint.to);
      if (joint.to == joint.body)
        refuse_by(Rule::kReferences, at + "/to", "the link's own body", "another body");
    }
    const auto index = [&](const Body* b) { return static_cast<std::size_t>(b - bodies.data()); };
    const bool between = other != nullptr && !has_infinite_mass(*other);
    const int together = groups.join(index(body), index(between ? other : body));
    if (!begin.goes_on && together > kMostJointedTogether) {
      refuse_by(Rule::kCountInAll, at,
                fmt::format("link {} of bodies that are linked with one another", together),
                fmt::format("up to {} of them", kMostJointedTogether));
    }
    if (joint.length && (joint.kind == JointKind::kPin || joint.kind == JointKind::kWeld))
      refuse_value(at + "/length", fmt::format("the length of a {}", name_of_kind(joint.kind)), "none");
    if (joint.angle && joint.kind != JointKind::kWeld)
      refuse_value(at + "/angle", "the angle of what turns", "none but a weld's");
    if (!begin.goes_on) check_start(at, joint, *body, other, begin.time);
  }
}

}  // namespace carom
