#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>

#include "physics/impact/impact_law.h"

namespace carom {
namespace {

double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

// A body that is struck at r from its centre; mass 0 stands for one that does not move.
struct Struck {
  Vec2 velocity = Vec2::Zero();
  double spin = 0.0;
  double mass = 0.0;
  double inertia = 0.0;
  Vec2 r = Vec2::Zero();

  [[nodiscard]] Vec2 at_contact() const { return velocity + spin * Vec2(-r.y(), r.x()); }
  void push(const Vec2& j) {
    if (mass == 0.0) return;
    velocity += j / mass;
    spin += cross(r, j) / inertia;
  }
  [[nodiscard]] double energy() const {
    return 0.5 * mass * velocity.squaredNorm() + 0.5 * inertia * spin * spin;
  }
  [[nodiscard]] double fastest() const { return velocity.norm() + std::abs(spin) * r.norm(); }
  [[nodiscard]] double turning() const {  // angular momentum about the contact point
    return cross(-r, mass * velocity) + inertia * spin;
  }
};

struct Case {
  Struck a;
  Struck b;
  Vec2 normal = Vec2(0.0, 1.0);
  SurfaceLaw material = {};

  [[nodiscard]] Vec2 tangent() const { return {-normal.y(), normal.x()}; }
  [[nodiscard]] RelativeVelocity slip() const {
    const Vec2 u = b.at_contact() - a.at_contact();
    return {u.dot(normal), u.dot(tangent())};
  }
  void push(double j_n, double j_t) {
    const Vec2 j = j_n * normal + j_t * tangent();
    a.push(-j);
    b.push(j);
  }
  [[nodiscard]] double energy() const { return a.energy() + b.energy(); }
};

ImpactSide side(const Struck& s, const Vec2& towards) {
  const bool moves = s.mass > 0.0;
  return {
      s.velocity,         s.spin, moves ? 1.0 / s.mass : 0.0, moves ? 1.0 / s.inertia : 0.0, s.r.dot(towards),
      cross(s.r, towards)};
}

Impact resolve(Case& c, ImpactLawId law = ImpactLawId::kEnergetic) {
  ImpactSide a = side(c.a, c.normal);
  ImpactSide b = side(c.b, -c.normal);
  const Impact j = resolve_impact(a, b, c.normal, c.material, law);
  c.a.velocity = a.velocity;
  c.a.spin = a.spin;
  c.b.velocity = b.velocity;
  c.b.spin = b.spin;
  return j;
}

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 random_;
};

// A convex body's contact: on its own side of the centre, within 60° of the normal, as far from the centre as
// one to three radii of gyration.
Struck random_struck(Draw& draw, const Vec2& towards) {
  Struck s;
  const double turn = draw(-1.047, 1.047);
  const double length = draw(0.05, 2.0);
  s.r = length * (std::cos(turn) * towards + std::sin(turn) * Vec2(-towards.y(), towards.x()));
  s.mass = std::exp(draw(-3.0, 3.0));
  s.inertia = s.mass * length * length * draw(0.2, 1.0);
  s.velocity = {draw(-5.0, 5.0), draw(-5.0, 5.0)};
  s.spin = draw(-5.0, 5.0) / length;
  return s;
}

// Approaching; one in four against a body that does not move, one in eight without slip.
Case random_case(Draw& draw) {
  Case c;
  const double angle = draw(0.0, 6.283185307179586);
  c.normal = {std::cos(angle), std::sin(angle)};
  c.a = random_struck(draw, c.normal);
  c.b = random_struck(draw, -c.normal);
  if (draw(0.0, 1.0) < 0.25) {
    c.a.mass = c.a.inertia = c.a.spin = 0.0;
    c.a.velocity = Vec2::Zero();
  }
  RelativeVelocity u = c.slip();
  if (draw(0.0, 1.0) < 0.125) c.b.velocity -= u.tangential * c.tangent();
  if (u.normal > 0.0) c.b.velocity -= 2.0 * u.normal * c.normal;
  const double friction =
      std::array{0.0, draw(0.0, 1.0), draw(0.0, 1.0), draw(0.0, 5.0)}[static_cast<std::size_t>(draw(0.0, 4.0))];
  c.material.kinetic_friction = friction;
  c.material.static_friction = friction * draw(1.0, 1.5);
  c.material.restitution =
      std::array{0.0, 1.0, draw(0.0, 1.0), draw(0.0, 1.0)}[static_cast<std::size_t>(draw(0.0, 4.0))];
  return c;
}

// Routh's path in small equal steps of the normal impulse, on the bodies themselves; the right result gives
// only the size of the step. Off by a few steps.
Impact march(Case c, double step) {
  Impact j;
  const double per_tangent = [&] {
    Case probe = c;
    probe.push(0.0, 1.0);
    return probe.slip().tangential - c.slip().tangential;
  }();
  const double per_normal = [&] {
    Case probe = c;
    probe.push(1.0, 0.0);
    return probe.slip().tangential - c.slip().tangential;
  }();
  const double stopping = -per_normal / per_tangent;  // dj_t/dj_n that keeps the slip
  const SurfaceLaw& m = c.material;
  double compression = 0.0;
  double restitution = 0.0;
  bool compressing = true;
  bool stuck = false;
  bool slipping = c.slip().tangential != 0.0;
  double direction = std::copysign(1.0, c.slip().tangential);
  for (int n = 0; n < 2'000'000; ++n) {
    if (!slipping) {
      stuck = std::abs(stopping) <= m.static_friction;
      direction = -std::copysign(1.0, stopping);
    }
    const RelativeVelocity u = c.slip();
    const double j_t = stuck ? stopping * step : -direction * m.kinetic_friction * step;
    c.push(step, j_t);
    const RelativeVelocity after = c.slip();
    j.normal += step;
    j.tangential += j_t;
    j.lost_to_friction -= 0.5 * j_t * (u.tangential + after.tangential);
    const double work = 0.5 * step * (u.normal + after.normal);
    (compressing ? compression : restitution) += compressing ? -work : work;
    if (after.normal >= 0.0) compressing = false;
    if (!compressing && restitution >= m.restitution * m.restitution * compression) break;
    if (!stuck) slipping = slipping ? after.tangential * direction > 0.0 : true;
  }
  j.lost_to_restitution = compression - restitution;
  return j;
}

TEST(OffCentreImpact, EnergeticLawFollowsRouthsPath) {
  constexpr double kSteps = 20'000.0;
  Draw draw(11);
  int stuck = 0, jammed = 0, reversed = 0;
  for (int i = 0; i < 500; ++i) {
    const Case before = random_case(draw);
    Case c = before;
    const Impact j = resolve(c);
    const Impact reference = march(before, j.normal / kSteps);
    const double size = j.normal * (1.0 + before.material.static_friction);
    const double energy = before.energy();
    ASSERT_NEAR(j.normal, reference.normal, 20.0 / kSteps * size) << "case " << i;
    ASSERT_NEAR(j.tangential, reference.tangential, 20.0 / kSteps * size) << "case " << i;
    ASSERT_NEAR(j.lost_to_restitution, reference.lost_to_restitution, 20.0 / kSteps * energy) << "case " << i;
    ASSERT_NEAR(j.lost_to_friction, reference.lost_to_friction, 20.0 / kSteps * energy) << "case " << i;
    const double slip = before.slip().tangential;
    stuck += std::abs(c.slip().tangential) < 1e-9 ? 1 : 0;
    reversed += slip * c.slip().tangential < 0.0 && std::abs(c.slip().tangential) > 1e-9 ? 1 : 0;
    jammed += j.jammed ? 1 : 0;
  }
  EXPECT_GT(stuck, 50);
  EXPECT_GT(reversed, 20);
  EXPECT_GT(jammed, 5);
}

// Newton's law: of sticking and sliding either way exactly one satisfies it.
TEST(OffCentreImpact, NewtonsLawIsItsOnlySolution) {
  Draw draw(12);
  for (int i = 0; i < 20'000; ++i) {
    const Case before = random_case(draw);
    Case c = before;
    const Impact j = resolve(c, ImpactLawId::kNewton);
    const RelativeVelocity u = before.slip();
    const double mu = before.material.kinetic_friction;
    // Columns of K by unit impulses.
    Case by_n = before, by_t = before;
    by_n.push(1.0, 0.0);
    by_t.push(0.0, 1.0);
    const double nn = by_n.slip().normal - u.normal, tn = by_n.slip().tangential - u.tangential;
    const double nt = by_t.slip().normal - u.normal, tt = by_t.slip().tangential - u.tangential;
    const double change = -(1.0 + before.material.restitution) * u.normal;
    int solutions = 0;
    const auto offer = [&](double j_n, double j_t) {
      ++solutions;
      ASSERT_NEAR(j.normal, j_n, 1e-9 * std::abs(j_n)) << "case " << i;
      ASSERT_NEAR(j.tangential, j_t, 1e-9 * (1.0 + mu) * std::abs(j_n)) << "case " << i;
    };
    const double det = nn * tt - nt * tn;
    const double stick_n = (tt * change + nt * u.tangential) / det;
    const double stick_t = (-tn * change - nn * u.tangential) / det;
    if (mu > 0.0 && std::abs(stick_t) <= mu * stick_n) offer(stick_n, stick_t);
    if (mu == 0.0) offer(change / nn, 0.0);
    for (const double s : {-1.0, 1.0}) {
      const double j_n = change / (nn + s * mu * nt);
      const double slip = u.tangential + tn * j_n + tt * s * mu * j_n;
      if (mu > 0.0 && j_n > 0.0 && s * slip < 0.0) offer(j_n, s * mu * j_n);
    }
    ASSERT_EQ(solutions, 1) << "case " << i;
  }
}

// Every law on a million random impacts: momentum, angular momentum, and the energies by name.
TEST(OffCentreImpact, AMillionRandomOnesKeepTheLaws) {
  Draw draw(13);
  int gained = 0, rubbed = 0;
  double most_gained = 0.0;
  for (int i = 0; i < 1'000'000; ++i) {
    const Case before = random_case(draw);
    const double energy = before.energy();
    const double size = std::sqrt(2.0 * energy * (before.a.mass + before.b.mass));
    const double speed = before.a.fastest() + before.b.fastest();
    const auto holds = [&](ImpactLawId law) {
      Case c = before;
      const Impact j = resolve(c, law);
      const double lost = j.lost_to_restitution + j.lost_to_friction;
      ASSERT_NEAR(energy - c.energy(), lost, 1e-12 * energy) << "case " << i;
      ASSERT_TRUE(c.energy() <= energy * (1.0 + 1e-12) + j.energy_gain) << "case " << i;
      if (before.a.mass > 0.0) {
        const Vec2 p = before.a.mass * before.a.velocity + before.b.mass * before.b.velocity;
        const Vec2 p_after = c.a.mass * c.a.velocity + c.b.mass * c.b.velocity;
        ASSERT_LE((p - p_after).norm(), 1e-12 * size) << "case " << i;
      }
      // Each body's own angular momentum about the contact point, which the impulse cannot change.
      for (const auto& [old_one, new_one] : {std::pair{before.a, c.a}, std::pair{before.b, c.b}}) {
        ASSERT_NEAR(old_one.turning(), new_one.turning(), 1e-12 * size * (1.0 + 4.0 * old_one.r.norm()))
            << "case " << i;
      }
      const RelativeVelocity u = before.slip(), after = c.slip();
      ASSERT_GT(j.normal, 0.0) << "case " << i;
      ASSERT_GE(after.normal, -1e-12 * speed) << "case " << i;
      ASSERT_GE(j.lost_to_restitution, 0.0) << "case " << i;
      const double cone = std::max(before.material.static_friction, before.material.kinetic_friction);
      ASSERT_LE(std::abs(j.tangential), cone * j.normal * (1.0 + 1e-12)) << "case " << i;
      if (law == ImpactLawId::kEnergetic) {
        ASSERT_GE(j.lost_to_friction, 0.0) << "case " << i;
        ASSERT_EQ(j.energy_gain, 0.0) << "case " << i;
      } else {
        ASSERT_NEAR(after.normal, -before.material.restitution * u.normal, 1e-12 * speed) << "case " << i;
        if (before.material.kinetic_friction > 0.0) ++rubbed;
        if (j.energy_gain > 1e-12 * energy) ++gained;
        most_gained = std::max(most_gained, j.energy_gain / energy);
      }
    };
    holds(ImpactLawId::kEnergetic);
    holds(ImpactLawId::kNewton);
    if (HasFatalFailure()) return;
  }
  RecordProperty("rubbing", rubbed);
  RecordProperty("newton_gained", gained);
  RecordProperty("newton_most_gained", fmt::format("{}", most_gained));
  EXPECT_GT(gained, 0);
}

TEST(OffCentreImpact, WithoutFrictionBothLawsAreOne) {
  Draw draw(14);
  for (int i = 0; i < 10'000; ++i) {
    Case energetic = random_case(draw);
    energetic.material.kinetic_friction = energetic.material.static_friction = 0.0;
    Case newton = energetic;
    const Impact j = resolve(energetic);
    const Impact k = resolve(newton, ImpactLawId::kNewton);
    ASSERT_NEAR(j.normal, k.normal, 1e-13 * j.normal) << "case " << i;
    ASSERT_EQ(k.tangential, 0.0);
    ASSERT_EQ(j.tangential, 0.0);
    ASSERT_NEAR(j.lost_to_restitution, k.lost_to_restitution, 1e-13 * energetic.energy()) << "case " << i;
  }
}

// A lever too small to turn anything takes the general way; the central one must be where it leads.
TEST(OffCentreImpact, DiscsAreTheSpecialCase) {
  Draw draw(15);
  for (int i = 0; i < 10'000; ++i) {
    const Case random = random_case(draw);
    ImpactSide a = side(random.a, random.normal), b = side(random.b, -random.normal);
    a.lever = b.lever = 0.0;
    if (relative_velocity(a, b, random.normal).normal >= 0.0) continue;
    for (const ImpactLawId law : {ImpactLawId::kEnergetic, ImpactLawId::kNewton}) {
      ImpactSide a0 = a, b0 = b, a1 = a, b1 = b;
      b1.lever = 1e-200;
      const Impact j = resolve_impact(a0, b0, random.normal, random.material, law);
      const Impact k = resolve_impact(a1, b1, random.normal, random.material, law);
      const double size = j.normal * (1.0 + random.material.kinetic_friction);
      ASSERT_NEAR(j.normal, k.normal, 1e-14 * size) << "case " << i;
      ASSERT_NEAR(j.tangential, k.tangential, 1e-14 * size) << "case " << i;
      const double energy = random.energy();
      ASSERT_NEAR(j.lost_to_restitution, k.lost_to_restitution, 1e-13 * energy) << "case " << i;
      ASSERT_NEAR(j.lost_to_friction, k.lost_to_friction, 1e-13 * energy) << "case " << i;
    }
  }
}

// The energy of a million frictionless elastic impacts of the same two bodies, each at another place, the spins
// and velocities kept: rounding only.
TEST(OffCentreImpact, AMillionElasticOnesDoNotDrift) {
  Draw draw(16);
  Case c;
  c.a = {{0.3, 0.4}, 1.0, 1.0, 0.4, Vec2::Zero()};
  c.b = {{-0.5, 0.2}, -2.0, 2.0, 0.5, Vec2::Zero()};
  const double energy = c.energy();
  for (int i = 0; i < 1'000'000; ++i) {
    const double angle = draw(0.0, 6.283185307179586);
    c.normal = {std::cos(angle), std::sin(angle)};
    c.a.r = {draw(-1.0, 1.0), draw(-1.0, 1.0)};
    c.b.r = {draw(-1.0, 1.0), draw(-1.0, 1.0)};
    if (c.slip().normal > 0.0) c.normal = -c.normal;
    (void)resolve(c);
  }
  EXPECT_NEAR(c.energy() / energy, 1.0, 1e-12);
  RecordProperty("drift", fmt::format("{}", c.energy() / energy - 1.0));
}

// --- closed forms

// A rod of length L and width w struck at d from its centre feels like the mass M/(1 + 12d²/(L² + w²)) there:
// an elastic ball of that mass stops. Struck at the percussion point, the rod's end does not start to move.
TEST(OffCentreImpact, BallOnRod) {
  const double mass = 2.0, length = 1.2, width = 0.1;
  const double inertia = mass * (length * length + width * width) / 12.0;
  const auto strike = [&](double d, double ball) {
    Case c;
    c.a = {{3.0, 0.0}, 0.0, ball, 0.5 * ball * 0.01, {0.1, 0.0}};
    c.b = {Vec2::Zero(), 0.0, mass, inertia, {-0.5 * width, d}};
    c.normal = {1.0, 0.0};
    const Impact j = resolve(c);
    EXPECT_NEAR(j.normal * (1.0 / ball + (1.0 + d * d * mass / inertia) / mass), 2.0 * 3.0, 1e-14);
    return c;
  };
  for (const double d : {0.1, 0.25, -0.6}) {
    const double effective = mass / (1.0 + 12.0 * d * d / (length * length + width * width));
    EXPECT_NEAR(strike(d, effective).a.velocity.x(), 0.0, 1e-14) << d;
  }
  const double from_end = 2.0 * length / 3.0 + width * width / (6.0 * length);
  const Case c = strike(from_end - 0.5 * length, 0.7);
  // The pivot end lies at -L/2 along y: v_x = v - ω y.
  EXPECT_NEAR(c.b.velocity.x() + c.b.spin * 0.5 * length, 0.0, 1e-14);
}

Case falling_rod(double angle, double mass, double length) {
  Case c;  // floor below, the rod's left end touches; the centre lies along (cos, sin) from it
  c.b.mass = mass;
  c.b.inertia = mass * length * length / 12.0;
  c.b.r = -0.5 * length * Vec2(std::cos(angle), std::sin(angle));
  return c;
}

TEST(OffCentreImpact, FallingRod) {
  const double m = 1.5, length = 0.8, v = 2.0;
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const double angle : {0.1, 0.7, 1.2}) {
      Case c = falling_rod(angle, m, length);
      c.b.velocity = {0.0, -v};
      c.material.restitution = e;
      const Impact j = resolve(c);
      const double cosine = std::cos(angle), k = 1.0 + 3.0 * cosine * cosine;
      EXPECT_NEAR(j.normal, (1.0 + e) * m * v / k, 1e-14);
      EXPECT_NEAR(std::abs(c.b.spin), 6.0 * (1.0 + e) * v * cosine / (length * k), 1e-13);
    }
  }
}

// Painlevé's rod at tan θ = 2: friction drives the tip into the floor iff μ > 4/3.
TEST(OffCentreImpact, PainlevesRod) {
  const double angle = std::atan(2.0), m = 1.0, length = 1.0;
  const auto slide_in = [&](double mu, double down, double slip, double e) {
    Case c = falling_rod(angle, m, length);
    c.b.velocity = {slip, -down};
    c.material.kinetic_friction = c.material.static_friction = mu;
    c.material.restitution = e;
    return c;
  };
  // Of the two directions of slip one jams; by the touching end being the left one it is the leftward one.
  for (const double slip : {-3.0, 3.0}) {
    for (const double mu : {1.33, 1.34, 2.0, 1e3, 1e9}) {
      for (const double down : {0.0, 1e-300, 1e-20, 1e-9, 1.0}) {
        for (const double e : {0.0, 0.5, 1.0}) {
          const Case before = slide_in(mu, down, slip, e);
          Case c = before;
          const Impact j = resolve(c);
          const std::string where = fmt::format("slip {} mu {} down {} e {}", slip, mu, down, e);
          const bool jam = slip < 0.0 && mu > 4.0 / 3.0;
          EXPECT_EQ(j.jammed, jam) << where;
          EXPECT_LE(c.energy(), before.energy() * (1.0 + 1e-15)) << where;
          EXPECT_NEAR(before.energy() - c.energy(), j.lost_to_restitution + j.lost_to_friction,
                      1e-13 * before.energy())
              << where;
          EXPECT_EQ(j.normal == 0.0, down == 0.0 && !jam) << where;
          EXPECT_TRUE(!jam || std::abs(c.slip().tangential) < 1e-14) << where;
          EXPECT_GE(c.slip().normal, -1e-14) << where;
        }
      }
    }
  }
  // The impact without collision itself, with e = 0: the tip stops, so the rod turns about it, and angular
  // momentum about the tip is kept: ω (1/3) m L² = m |v| (L/2) sin θ.
  Case c = slide_in(2.0, 0.0, -3.0, 0.0);
  const Impact j = resolve(c);
  EXPECT_TRUE(j.jammed);
  EXPECT_NEAR(c.b.spin, 1.5 * 3.0 * std::sin(angle) / length, 1e-14);
}

// Two closing speeds that are next to nothing beside the slip: the same result, and without a jam next to none.
TEST(OffCentreImpact, IsContinuousInTheClosingSpeed) {
  Draw draw(17);
  int jammed = 0;
  for (int i = 0; i < 2'000; ++i) {
    const Case random = random_case(draw);
    const double speed = std::abs(random.slip().tangential);
    if (speed < 1e-6) continue;
    const auto at = [&](double closing) {
      Case c = random;
      c.b.velocity -= (c.slip().normal + closing * speed) * c.normal;
      return resolve(c);
    };
    const Impact slow = at(1e-12);
    const Impact slower = at(1e-13);
    const double size = speed / (1.0 / random.b.mass + random.b.r.squaredNorm() / random.b.inertia);
    ASSERT_EQ(slow.jammed, slower.jammed) << "case " << i;
    ASSERT_NEAR(slow.tangential, slower.tangential, 1e-6 * size) << "case " << i;
    ASSERT_TRUE(slow.jammed || slow.normal < 1e-6 * size) << "case " << i;
    jammed += slow.jammed ? 1 : 0;
  }
  EXPECT_GT(jammed, 10);
}

}  // namespace
}  // namespace carom
