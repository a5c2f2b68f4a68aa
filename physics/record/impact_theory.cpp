#include "physics/record/impact_theory.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/ledger/totals.h"
#include "physics/math/vectors.h"

namespace carom {
namespace {

constexpr double kCentral = 1e-12;  // of the arm: a lever below it is rounding
constexpr double kGain = 1e-12;     // of the kinetic energy: a gain below it is rounding

// One of two bodies: arm r (m) from its centre to the contact.
struct Side {
  BodyIndex body;
  double inverse_mass;     // 1/kg
  double inverse_inertia;  // 1/(kg m²)
  Vec2 r;

  // How fast the contact point gets along `to` by a unit impulse along `by`, 1/kg.
  [[nodiscard]] double answer(const Vec2& by, const Vec2& to) const {
    return inverse_mass * by.dot(to) + inverse_inertia * cross(r, by) * cross(r, to);
  }
  [[nodiscard]] Vec2 velocity(const Eigen::Matrix3Xd& v) const {
    return v.col(body).head<2>() + v.col(body)[2] * crossed(r);
  }
  void push(Eigen::Matrix3Xd& v, const Vec2& j) const {
    v.col(body).head<2>() += inverse_mass * j;
    v.col(body)[2] += inverse_inertia * cross(r, j);
  }
  [[nodiscard]] bool is_central(const Vec2& n) const {
    return inverse_inertia == 0.0 || std::abs(cross(r, n)) <= kCentral * r.norm();
  }
};

// The contact of one impact.
struct Pair {
  Side a;
  Side b;
  Vec2 n;
  Vec2 t;

  Pair(const JumpMoment& moment, const ImpactRecord& record)
      : a(side(moment, record, record.a)),
        b(side(moment, record, record.b)),
        n(record.normal),
        t(crossed(record.normal)) {}
  static Side side(const JumpMoment& moment, const ImpactRecord& record, BodyIndex body) {
    const MassProperties& mass = moment.compiled->model.mass;
    return {body, mass.inverse_mass[body], mass.inverse_inertia[body],
            record.point - moment.before().position(body)};
  }
  [[nodiscard]] double k(const Vec2& by, const Vec2& to) const { return a.answer(by, to) + b.answer(by, to); }
  [[nodiscard]] Vec2 u(const Eigen::Matrix3Xd& v) const { return b.velocity(v) - a.velocity(v); }
  void push(Eigen::Matrix3Xd& v, const Vec2& j) const {
    a.push(v, -j);
    b.push(v, j);
  }
};

// The impulse (j_n, j_t) of an off-centre impact with friction; nothing if the slip stops on the way.
std::optional<Vec2> rubbing_impulse(const Pair& pair, const Vec2& u, const SurfaceLaw& material,
                                    ImpactLawId law) {
  const double k_nn = pair.k(pair.n, pair.n);
  const double k_nt = pair.k(pair.n, pair.t);
  const double k_tt = pair.k(pair.t, pair.t);
  const double mu = material.kinetic_friction;
  const double change = -(1.0 + material.restitution) * u.x();
  const double determinant = k_nn * k_tt - k_nt * k_nt;
  const Vec2 held = Vec2(k_tt * change + k_nt * u.y(), -k_nn * u.y() - k_nt * change) / determinant;
  if (law == ImpactLawId::kNewton && std::abs(held.y()) <= mu * held.x()) return held;
  const bool stays = u.y() == 0.0 && std::abs(k_nt) <= std::max(mu, material.static_friction) * k_tt;
  if (law == ImpactLawId::kEnergetic && stays) return held;
  const double s = std::copysign(1.0, u.y());
  const double stiffness = k_nn - s * mu * k_nt;
  if (!(stiffness > 0.0) || u.y() == 0.0) return std::nullopt;
  const double j = change / stiffness;
  if (s * (u.y() + k_nt * j - s * mu * k_tt * j) < 0.0) return std::nullopt;
  return Vec2(j, -s * mu * j);
}

// The impulse (j_n, j_t) on b.
std::optional<Vec2> impulse(const Pair& pair, const Vec2& u, const SurfaceLaw& material, ImpactLawId law) {
  const double mu = material.kinetic_friction;
  const bool central = pair.a.is_central(pair.n) && pair.b.is_central(pair.n);
  if (mu > 0.0 && !central) return rubbing_impulse(pair, u, material, law);
  const double j = -(1.0 + material.restitution) * u.x() / pair.k(pair.n, pair.n);
  const double stop = -(1.0 + material.tangential_restitution) * u.y() / pair.k(pair.t, pair.t);
  return Vec2(j, mu > 0.0 ? std::clamp(stop, -mu * j, mu * j) : 0.0);
}

// The material of a body, unless it has several.
std::optional<int> material_of(const Model& model, BodyIndex body) {
  std::optional<int> found = model.surfaces.material[model.shapes.first_part(body)];
  const int first = *found;
  model.shapes.each_part(body, [&](ShapeIndex part) {
    if (model.surfaces.material[part] != first) found.reset();
  });
  return found;
}

const SurfaceLaw* material_between(const Model& model, const ImpactRecord& record) {
  const bool known = material_of(model, record.a) && material_of(model, record.b);
  return known ? &model.surfaces.between(model.shapes.first_parts(record.a, record.b)) : nullptr;
}

// Whether joints act on a body that can move, beside the weld of the two if they stick.
bool has_joints(const JumpMoment& moment, const ImpactRecord& record, bool sticks) {
  const auto acts_on = [&](const Joint& joint, BodyIndex body) {
    const std::string& name = moment.compiled->scene.bodies[static_cast<std::size_t>(body)].name;
    return !moment.compiled->model.infinite_mass(body) && (joint.body == name || joint.to == name);
  };
  const std::vector<Joint>& joints = moment.joints;
  const auto count = std::count_if(joints.begin(), joints.end(), [&](const Joint& joint) {
    return acts_on(joint, record.a) || acts_on(joint, record.b);
  });
  return count > (sticks ? 1 : 0);
}

// One velocity and one spin for both, with the momentum and angular momentum that they have.
void stick(const JumpMoment& moment, const Pair& pair, Eigen::Matrix3Xd& v) {
  const Model& model = moment.compiled->model;
  const BodyIndex a = pair.a.body;
  const BodyIndex b = pair.b.body;
  const Vec2 x_a = moment.before().position(a);
  const Vec2 x_b = moment.before().position(b);
  Vec2 centre;
  Vec2 velocity;
  double spin = 0.0;
  if (model.infinite_mass(a) || model.infinite_mass(b)) {
    const int base = model.infinite_mass(a) ? a : b;
    centre = moment.before().position(base);
    velocity = v.col(base).head<2>();
    spin = v(2, base);
  } else {
    const double m_a = model.mass.mass[a];
    const double m_b = model.mass.mass[b];
    centre = (m_a * x_a + m_b * x_b) / (m_a + m_b);
    velocity = (m_a * v.col(a).head<2>() + m_b * v.col(b).head<2>()) / (m_a + m_b);
    const Vec2 arm = x_b - x_a;
    const double reduced = m_a * m_b / (m_a + m_b);
    const double own = model.mass.inertia[a] * v.col(a)[2] + model.mass.inertia[b] * v.col(b)[2];
    const double turning = own + reduced * cross(arm, Vec2(v.col(b).head<2>() - v.col(a).head<2>()));
    spin = turning / (model.mass.inertia[a] + model.mass.inertia[b] + reduced * arm.squaredNorm());
  }
  for (const BodyIndex i : {a, b}) {
    v.col(i).head<2>() = velocity + spin * crossed(Vec2(moment.before().position(i) - centre));
    v.col(i)[2] = spin;
  }
}

NoTheory follow_one(const JumpMoment& moment, const ImpactRecord& record, Eigen::Matrix3Xd& v) {
  const Model& model = moment.compiled->model;
  const SurfaceLaw* material = material_between(model, record);
  if (material == nullptr) return NoTheory::kMaterials;
  if (has_joints(moment, record, material->sticks)) return NoTheory::kJoints;
  const Pair pair(moment, record);
  if (material->sticks) {
    stick(moment, pair, v);
    return NoTheory::kNone;
  }
  const Vec2 u = pair.u(v);
  const auto j = impulse(pair, {u.dot(pair.n), u.dot(pair.t)}, *material, model.impact_law);
  if (!j) return NoTheory::kSlipStops;
  pair.push(v, j->x() * pair.n + j->y() * pair.t);
  return NoTheory::kNone;
}

double kinetic_energy_of(const Model& model, const Eigen::Matrix3Xd& v) {
  State state;
  state.v = v;
  state.q = Eigen::Matrix3Xd::Zero(3, v.cols());
  return kinetic_energy(state, model.mass);
}

// Whether all pairs of surfaces have one e, so that it does not matter which contacts take part.
bool has_one_restitution(const Model& model) {
  const std::vector<SurfaceLaw>& pairs = model.surfaces.pairs;
  return std::all_of(pairs.begin(), pairs.end(),
                     [&](const SurfaceLaw& m) { return m.restitution == pairs.front().restitution; });
}

NoTheory follow_at_once(const JumpMoment& moment, std::span<const ImpactRecord> records, Eigen::Matrix3Xd& v) {
  const Model& model = moment.compiled->model;
  const bool all = model.several_impacts == SeveralImpactsId::kSimultaneous;
  if (all && !has_one_restitution(model)) return NoTheory::kRestitution;
  std::vector<Pair> pairs;
  const auto count = static_cast<Eigen::Index>(records.size());
  Eigen::VectorXd change(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const ImpactRecord& record = records[static_cast<std::size_t>(i)];
    const SurfaceLaw* material = material_between(model, record);
    if (material == nullptr) return NoTheory::kMaterials;
    if (has_joints(moment, record, false)) return NoTheory::kJoints;
    if (material->kinetic_friction > 0.0) return NoTheory::kFrictionAtOnce;
    pairs.emplace_back(moment, record);
    const double u = pairs.back().u(v).dot(pairs.back().n);
    change[i] = -u - material->restitution * std::min(u, 0.0);
  }
  Eigen::MatrixXd k(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    Eigen::Matrix3Xd unit = Eigen::Matrix3Xd::Zero(3, v.cols());
    pairs[static_cast<std::size_t>(i)].push(unit, pairs[static_cast<std::size_t>(i)].n);
    for (Eigen::Index row = 0; row < count; ++row) {
      const Pair& pair = pairs[static_cast<std::size_t>(row)];
      k(row, i) = pair.u(unit).dot(pair.n);
    }
  }
  const Eigen::VectorXd j = k.completeOrthogonalDecomposition().solve(change);
  const double before = kinetic_energy_of(model, v);
  for (Eigen::Index i = 0; i < count; ++i)
    pairs[static_cast<std::size_t>(i)].push(v, j[i] * pairs[static_cast<std::size_t>(i)].n);
  const bool gains = kinetic_energy_of(model, v) > (1.0 + kGain) * before;
  return gains || (k * j - change).norm() > kGain * change.norm() ? NoTheory::kRestitution : NoTheory::kNone;
}

}  // namespace

ImpactTheory theory_of(const JumpMoment& moment) {
  ImpactTheory theory;
  theory.v = moment.before().v;
  const std::span<const ImpactRecord> records(moment.records);
  for (std::size_t begin = 0; begin < records.size() && theory.why_not == NoTheory::kNone;) {
    // Of impacts at once the first one has all of the motion.
    std::size_t end = begin + 1;
    while (end < records.size() && moment.jumps[end].before.v == moment.jumps[end].after.v) ++end;
    theory.why_not = end - begin == 1 ? follow_one(moment, records[begin], theory.v)
                                      : follow_at_once(moment, records.subspan(begin, end - begin), theory.v);
    begin = end;
  }
  return theory;
}

}  // namespace carom
