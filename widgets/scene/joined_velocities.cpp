#include "widgets/scene/joined_velocities.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "physics/math/vectors.h"
#include "physics/scene/edit_rules.h"

namespace carom {
namespace {

constexpr double kAllowed = 1e-9;  // of the speeds: less against a joint is rounding

// An end of a joint: on the plane, on a body that keeps its velocity, or on one that changes.
struct End {
  Vec2 place = Vec2::Zero();     // m
  Vec2 arm = Vec2::Zero();       // m, from the body's centre
  Vec2 velocity = Vec2::Zero();  // m/s
  double spin = 0.0;             // rad/s
  bool turns = true;             // is on no point
  Eigen::Index column = -1;      // the first of three of a body that changes
};

struct Rows {
  std::span<const Body> bodies;
  Eigen::MatrixXd left{};   // J
  Eigen::VectorXd right{};  // what J Δv has to be

  // Demands that `direction` · (velocity of a - velocity of b) + `turn` (spin of a - spin of b) vanish.
  void add(const End& a, const End& b, const Vec2& direction, double turn) {
    const Eigen::Index row = right.size();
    left.conservativeResize(row + 1, 3 * static_cast<Eigen::Index>(bodies.size()));
    left.row(row).setZero();
    right.conservativeResize(row + 1);
    right[row] = -direction.dot(a.velocity - b.velocity) - turn * (a.spin - b.spin);
    put(row, a, direction, turn);
    put(row, b, -direction, -turn);
  }

 private:
  void put(Eigen::Index row, const End& end, const Vec2& direction, double turn) {
    if (end.column < 0) return;
    left.row(row).segment<2>(end.column) = direction.transpose();
    left(row, end.column + 2) = direction.dot(crossed(end.arm)) + turn;
  }
};

End end_on(std::span<const Body> all, std::span<const Body> bodies, const std::string& name,
           const Vec2& point) {
  End end;
  end.place = point;
  if (name.empty()) return end;
  const auto is_it = [&](const Body& body) { return body.name == name; };
  const auto changes = std::find_if(bodies.begin(), bodies.end(), is_it);
  const auto stays = std::find_if(all.begin(), all.end(), is_it);
  if (changes == bodies.end() && stays == all.end()) return end;
  const Body& body = changes != bodies.end() ? *changes : *stays;
  end.arm = turned_by(body.angle, point);
  end.place = body.position + end.arm;
  end.velocity = body.velocity + body.spin * crossed(end.arm);
  end.spin = body.spin;
  end.turns = inertia_of(body) > 0.0;
  if (changes != bodies.end() && !has_infinite_mass(body)) end.column = 3 * (changes - bodies.begin());
  return end;
}

// A weld turns no point.
void add_rows(const Joint& joint, const End& a, const End& b, Rows& rows) {
  if (joint.kind == JointKind::kRod) {
    rows.add(a, b, (a.place - b.place).normalized(), 0.0);
    return;
  }
  rows.add(a, b, Vec2::UnitX(), 0.0);
  rows.add(a, b, Vec2::UnitY(), 0.0);
  if (joint.kind == JointKind::kWeld && a.turns && b.turns) rows.add(a, b, Vec2::Zero(), 1.0);
}

// M^(-1/2), by columns; 0 of a body that does not move, and of the turning of a point.
Eigen::VectorXd mobility(std::span<const Body> bodies) {
  Eigen::VectorXd roots = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(bodies.size()));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (has_infinite_mass(bodies[i])) continue;
    const double mass = 1.0 / std::sqrt(mass_of(bodies[i]));
    const double inertia = inertia_of(bodies[i]);
    const double turning = inertia > 0.0 ? 1.0 / std::sqrt(inertia) : 0.0;
    roots.segment<3>(3 * static_cast<Eigen::Index>(i)) = Eigen::Vector3d(mass, mass, turning);
  }
  return roots;
}

// The moving bodies at the ends of a joint, and all that rods, pins and welds join to them.
std::vector<Body> joined_to(const Scene& scene, const Joint& first) {
  std::unordered_map<std::string, const Body*> moving;
  for (const Body& body : scene.bodies) {
    if (!has_infinite_mass(body)) moving.emplace(body.name, &body);
  }
  std::vector<Body> found;
  const auto take = [&](const std::string& name) {
    const auto at = moving.find(name);
    if (at == moving.end()) return;
    found.push_back(*at->second);
    moving.erase(at);
  };
  take(first.body);
  take(first.to);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::string name = found[i].name;
    for (const Joint& joint : scene.joints) {
      if (joint.kind == JointKind::kString) continue;
      if (joint.body == name) take(joint.to);
      if (joint.to == name) take(joint.body);
    }
  }
  return found;
}

}  // namespace

std::vector<std::size_t> hold_joined_velocities(const Scene& scene, std::span<Body> bodies) {
  Rows rows{bodies};
  const std::vector<Body> all = all_bodies(scene);
  std::vector<std::size_t> broken;
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const Joint& joint = scene.joints[i];
    const End a = end_on(all, bodies, joint.body, joint.point);
    const End b = end_on(all, bodies, joint.to, joint.anchor);
    if (joint.kind == JointKind::kString || (a.column < 0 && b.column < 0) || a.column == b.column) continue;
    const Eigen::Index before = rows.right.size();
    add_rows(joint, a, b, rows);
    const double speed = a.velocity.norm() + b.velocity.norm() + std::abs(a.spin) + std::abs(b.spin);
    const double wrong = rows.right.tail(rows.right.size() - before).cwiseAbs().maxCoeff();
    if (wrong > kAllowed * speed) broken.push_back(i);
  }
  if (broken.empty()) return broken;
  const Eigen::VectorXd roots = mobility(bodies);
  const Eigen::MatrixXd scaled = rows.left * roots.asDiagonal();
  const Eigen::VectorXd change =
      roots.asDiagonal() * scaled.completeOrthogonalDecomposition().solve(rows.right);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto at = 3 * static_cast<Eigen::Index>(i);
    if (has_infinite_mass(bodies[i])) continue;
    bodies[i].velocity += change.segment<2>(at);
    bodies[i].spin += change[at + 2];
  }
  return broken;
}

std::vector<Body> as_joined(const Scene& scene, const Joint& joint) {
  if (joint.kind == JointKind::kString) return {};
  const std::vector<Body> before = joined_to(scene, joint);
  std::vector<Body> bodies = before;
  if (hold_joined_velocities(scene, bodies).empty()) return {};
  std::vector<Body> changed;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].velocity != before[i].velocity || bodies[i].spin != before[i].spin)
      changed.push_back(bodies[i]);
  }
  return changed;
}

SceneEdits with_joined(const Scene& scene, SceneEdits edits) {
  SceneEdits held;
  for (const SceneEdit& edit : edits) {
    const auto* moved = std::get_if<Replace<Joint>>(&edit);
    const Joint* before = moved == nullptr ? nullptr : part_of(scene.joints, moved->part.id);
    if (before == nullptr) continue;
    if (before->point == moved->part.point && before->anchor == moved->part.anchor) continue;
    Scene after = scene;
    apply_edits(after, {edit});
    const Joint& joint = *part_of(after.joints, moved->part.id);
    for (const Body& body : as_joined(after, joint)) held.emplace_back(Replace<Body>{body});
  }
  edits.insert(edits.end(), held.begin(), held.end());
  return edits;
}

}  // namespace carom
