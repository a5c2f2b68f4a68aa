#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "physics/contact/contact_solver.h"
#include "tests/support/contact_scenes.h"

// Random islands against slow but simple references in long double.
namespace carom {
namespace {

using test::ContactScene;
using Real = long double;

// The rows of the Jacobian of one contact, written out from the definition of u; 6 columns: A, then B.
struct Rows {
  std::array<Real, 6> normal, tangential, spin;
};

Rows jacobian(const Contacts& c, int i) {
  const Real nx = c.normal[i].x();
  const Real ny = c.normal[i].y();
  const auto row = [&](Real dx, Real dy) {
    const auto turn = [&](const Vec2& arm) { return Real{arm.x()} * dy - Real{arm.y()} * dx; };
    return std::array<Real, 6>{-dx, -dy, -turn(c.arm_a[i]), dx, dy, turn(c.arm_b[i])};
  };
  return {row(nx, ny), row(-ny, nx), {0.0L, 0.0L, -1.0L, 0.0L, 0.0L, 1.0L}};
}

// Velocities in long double, and the effect of an impulse along a row.
class LongMotion {
 public:
  LongMotion(const ContactScene& s) : scene_(s), v_(3 * s.position.size()) {
    for (std::size_t k = 0; k < v_.size(); ++k) v_[k] = s.v(k % 3, k / 3);
  }
  [[nodiscard]] Real along(const std::array<Real, 6>& row, int c) const {
    Real sum = 0.0L;
    for (int k = 0; k < 6; ++k) sum += row[k] * v_[index(c, k)];
    return sum;
  }
  void push(const std::array<Real, 6>& row, int c, Real impulse) {
    for (int k = 0; k < 6; ++k) v_[index(c, k)] += inverse(c, k) * row[k] * impulse;
  }
  [[nodiscard]] Real k(const std::array<Real, 6>& row, int c) const {
    Real sum = 0.0L;
    for (int i = 0; i < 6; ++i) sum += row[i] * row[i] * inverse(c, i);
    return sum;
  }
  [[nodiscard]] Real operator()(int body, int axis) const { return v_[3 * body + axis]; }

 private:
  [[nodiscard]] int body(int c, int k) const { return k < 3 ? scene_.contacts.a[c] : scene_.contacts.b[c]; }
  [[nodiscard]] std::size_t index(int c, int k) const { return 3 * body(c, k) + k % 3; }
  [[nodiscard]] Real inverse(int c, int k) const {
    return k % 3 == 2 ? scene_.mass.inverse_inertia[body(c, k)] : scene_.mass.inverse_mass[body(c, k)];
  }
  const ContactScene& scene_;
  std::vector<Real> v_;
};

bool in_play(const ContactScene& s, int c) {
  return s.mass.inverse_mass[s.contacts.a[c]] > 0.0 || s.mass.inverse_mass[s.contacts.b[c]] > 0.0;
}

// Residual of the contact law, from its definition: how far, in m/s, each contact violates it. `before` has
// the velocities before the solve, `after` the impulses.
double disobedience(const ContactScene& before, const ContactScene& after) {
  LongMotion v(before);
  const Contacts& c = after.contacts;
  for (int i = 0; i < c.size(); ++i) {
    const Rows j = jacobian(c, i);
    v.push(j.normal, i, c.normal_impulse[i]);
    v.push(j.tangential, i, c.tangential_impulse[i]);
    v.push(j.spin, i, c.rolling_impulse[i]);
  }
  Real worst = 0.0L;
  for (int body = 0; body < static_cast<int>(before.position.size()); ++body) {
    for (int axis = 0; axis < 3; ++axis)
      worst = std::max(worst, std::abs(v(body, axis) - Real{after.v(axis, body)}));
  }
  for (int i = 0; i < c.size(); ++i) {
    if (!in_play(before, i)) continue;
    const Rows j = jacobian(c, i);
    const auto term = [&](Real impulse, Real least, Real most, Real velocity, Real k) {
      return std::abs(std::clamp(impulse - velocity / k, least, most) - impulse) * k;
    };
    constexpr Real kNoLimit = std::numeric_limits<Real>::infinity();
    const Real normal = c.normal_impulse[i];
    const Real limit = Real{before.contacts.static_friction[i]} * normal;
    const Real most = Real{c.rolling[i]} * normal;
    worst = std::max(worst,
                     term(normal, 0.0L, kNoLimit, v.along(j.normal, i) - Real{c.target[i]}, v.k(j.normal, i)));
    worst = std::max(
        worst, term(c.tangential_impulse[i], -limit, limit, v.along(j.tangential, i), v.k(j.tangential, i)));
    worst = std::max(worst, Real{c.rolling[i]} *
                                term(c.rolling_impulse[i], -most, most, v.along(j.spin, i), v.k(j.spin, i)));
  }
  return static_cast<double>(worst);
}

// Plain projected Gauss-Seidel from zero impulses until nothing changes; false if it does not converge.
bool reference(const ContactScene& s, LongMotion& v) {
  const Contacts& c = s.contacts;
  std::vector<Real> normal(c.size()), tangential(c.size()), moment(c.size());
  std::vector<Rows> j;
  for (int i = 0; i < c.size(); ++i) j.push_back(jacobian(c, i));
  for (int sweeps = 0; sweeps < 40000; ++sweeps) {
    Real change = 0.0L;
    for (int i = 0; i < c.size(); ++i) {
      if (!in_play(s, i)) continue;
      const auto solve = [&](const std::array<Real, 6>& row, Real& impulse, Real least, Real most,
                             Real target) {
        const Real k = v.k(row, i);
        if (k <= 0.0L) return;
        const Real now = std::clamp(impulse - (v.along(row, i) - target) / k, least, most);
        change = std::max(change, std::abs(now - impulse) * k);
        v.push(row, i, now - impulse);
        impulse = now;
      };
      solve(j[i].normal, normal[i], 0.0L, std::numeric_limits<Real>::infinity(), c.target[i]);
      const Real limit = Real{c.static_friction[i]} * normal[i];
      solve(j[i].tangential, tangential[i], -limit, limit, 0.0L);
      const Real most = Real{c.rolling[i]} * normal[i];
      solve(j[i].spin, moment[i], -most, most, 0.0L);
    }
    if (change < 1e-16L) return true;
  }
  return false;
}

TEST(ContactSolverRandom, VelocitiesAgreeWithASlowReference) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    // For friction above about one half such islands may have several solutions.
    const test::RandomIsland kind{
        .most_contacts = 40, .mass_spread = 1.0, .most_friction = 0.3, .kinematic = seed % 3 == 0};
    const ContactScene before = test::random_island(seed, kind);
    ContactScene after = before;
    const ContactSolverReport report = after.solve({.tolerance = 1e-13, .max_newton = 200});
    LongMotion v(before);
    if (!reference(before, v)) continue;
    ++compared;
    EXPECT_EQ(report.missed_islands, 0) << "seed " << seed;
    for (int body = 0; body < static_cast<int>(before.position.size()); ++body) {
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(after.v(axis, body), static_cast<double>(v(body, axis)), 1e-10) << "seed " << seed;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(ContactSolverRandom, ObeysTheLawsAndAddsNoEnergy) {
  // With a friction of 3 islands jam in many ways.
  const test::RandomIsland kinds[] = {{.most_friction = 0.3},
                                      {.most_friction = 0.8},
                                      {.mass_spread = 7.0, .most_friction = 0.8},
                                      {.most_friction = 3.0}};
  for (const test::RandomIsland& kind : kinds) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      const ContactScene before = test::random_island(seed, kind);
      ContactScene after = before;
      const ContactSolverReport report = after.solve({.tolerance = 1e-12});
      EXPECT_EQ(report.missed_islands, 0) << kind.most_friction << ", seed " << seed;
      EXPECT_NEAR(disobedience(before, after), report.residual, 1e-10 + 1e-9 * report.residual)
          << "seed " << seed;
      EXPECT_LE(after.kinetic_energy(), before.kinetic_energy() * (1.0 + 1e-12)) << "seed " << seed;
    }
  }
}

TEST(ContactSolverRandom, TheSameBytesAgainWhateverTheWorkspaceHeld) {
  ContactWorkspace used;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    ContactScene one = test::random_island(seed, {});
    ContactScene two = one;
    one.solve({.tolerance = 1e-12});
    solve_contacts(two.mass, two.contacts, two.v, {.tolerance = 1e-12}, used);
    EXPECT_EQ(one.v, two.v) << "seed " << seed;
    EXPECT_EQ(one.contacts.normal_impulse, two.contacts.normal_impulse) << "seed " << seed;
    EXPECT_EQ(one.contacts.rolling_impulse, two.contacts.rolling_impulse) << "seed " << seed;
  }
}

TEST(ContactSolverRandom, IslandsDoNotFeelOneAnother) {
  // One scene alone, and together with another that is far away: the same bytes.
  int more = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    ContactScene alone = test::random_island(seed, {});
    ContactScene both = alone;
    const ContactScene other = test::random_island(seed + 1000, {});
    const int bodies = static_cast<int>(alone.position.size());
    for (int i = 0; i < static_cast<int>(other.position.size()); ++i) {
      both.body(other.position[i], 0.0, 0.0, other.v.col(i));
      both.mass.inverse_mass[bodies + i] = other.mass.inverse_mass[i];
      both.mass.inverse_inertia[bodies + i] = other.mass.inverse_inertia[i];
    }
    for (int c = 0; c < other.contacts.size(); ++c) {
      both.contact(bodies + other.contacts.a[c], bodies + other.contacts.b[c],
                   other.position[other.contacts.a[c]] + other.contacts.arm_a[c], other.contacts.normal[c],
                   other.contacts.static_friction[c]);
    }
    const ContactSolverReport one = alone.solve();
    const ContactSolverReport two = both.solve();
    more += two.islands - one.islands;
    EXPECT_EQ(Eigen::Matrix3Xd(both.v.leftCols(bodies)), alone.v) << "seed " << seed;
  }
  EXPECT_GT(more, 20);
}

}  // namespace
}  // namespace carom
