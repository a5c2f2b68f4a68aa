#include "physics/impact/impact_law.h"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace carom {
namespace {

double real(double low, double high) {
  return low + (high - low) * static_cast<double>(*rc::gen::inRange<std::int64_t>(0, 1LL << 40)) * 0x1p-40;
}

// Two discs that touch at the origin, A behind it along the normal, B before it.
struct Pair {
  ImpactSide a;
  ImpactSide b;
  Vec2 normal;
  SurfaceLaw material;
};

ImpactSide random_side() {
  ImpactSide s;
  const double radius = real(0.01, 2.0);
  s.velocity = {real(-5.0, 5.0), real(-5.0, 5.0)};
  s.spin = real(-20.0, 20.0);
  s.inverse_mass = 1.0 / std::exp(real(-5.0, 5.0));
  s.inverse_inertia = s.inverse_mass / (0.5 * radius * radius);
  s.arm = radius;
  return s;
}

Pair random_pair() {
  const double angle = real(0.0, 6.283185307179586);
  Pair p{random_side(), random_side(), {std::cos(angle), std::sin(angle)}, {}};
  p.material.restitution = real(0.0, 1.0);
  p.material.tangential_restitution = real(-1.0, 1.0);
  p.material.kinetic_friction = *rc::gen::element(0.0, 0.1, 0.5, 3.0);
  return p;
}

Vec2 momentum(const Pair& p) { return p.a.velocity / p.a.inverse_mass + p.b.velocity / p.b.inverse_mass; }

double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

double angular_momentum(const Pair& p) {
  return cross(-p.a.arm * p.normal, p.a.velocity) / p.a.inverse_mass + p.a.spin / p.a.inverse_inertia +
         cross(p.b.arm * p.normal, p.b.velocity) / p.b.inverse_mass + p.b.spin / p.b.inverse_inertia;
}

double energy(const Pair& p) {
  const auto one = [](const ImpactSide& s) {
    return 0.5 * s.velocity.squaredNorm() / s.inverse_mass + 0.5 * s.spin * s.spin / s.inverse_inertia;
  };
  return one(p.a) + one(p.b);
}

TEST(ImpactLaw, RandomImpactsKeepTheLaws) {
  setenv("RC_PARAMS", "seed=1", 0);  // the same impacts in every run, unless others are asked for
  EXPECT_TRUE(rc::check("momentum, angular momentum, energy, cone", [] {
    Pair p = random_pair();
    const Pair before = p;
    const RelativeVelocity u = relative_velocity(p.a, p.b, p.normal);
    const Impact j = resolve_impact(p.a, p.b, p.normal, p.material);
    if (u.normal >= 0.0) {
      RC_ASSERT(j.normal == 0.0 && p.a.velocity == before.a.velocity && p.b.spin == before.b.spin);
      return;
    }
    const RelativeVelocity after = relative_velocity(p.a, p.b, p.normal);
    const double e = p.material.restitution;
    const double scale = energy(before);
    const double p_scale = std::sqrt(2.0 * scale * (1.0 / before.a.inverse_mass + 1.0 / before.b.inverse_mass));
    RC_ASSERT(std::abs(after.normal + e * u.normal) <= 1e-12 * (1.0 + std::abs(u.normal)));
    RC_ASSERT((momentum(p) - momentum(before)).norm() <= 1e-13 * p_scale);
    RC_ASSERT(std::abs(angular_momentum(p) - angular_momentum(before)) <= 1e-12 * p_scale * 2.0);
    const double reduced = 1.0 / (p.a.inverse_mass + p.b.inverse_mass);
    const double loss = 0.5 * reduced * (1.0 - e * e) * u.normal * u.normal;
    RC_ASSERT(std::abs(j.lost_to_restitution - loss) <= 1e-12 * scale);
    RC_ASSERT(std::abs(energy(before) - energy(p) - j.lost_to_restitution - j.lost_to_friction) <=
              1e-12 * scale);
    RC_ASSERT(energy(p) <= energy(before) * (1.0 + 1e-12));
    RC_ASSERT(j.normal > 0.0);
    RC_ASSERT(std::abs(j.tangential) <= p.material.kinetic_friction * j.normal * (1.0 + 1e-15));
    // Friction acts against the slip, and reverses it by e_t at the most.
    RC_ASSERT(j.tangential * u.tangential <= 0.0);
  }));
}

// A disc of radius R on a floor below it; slip s = v + Rω at its lowest point, normal from floor to disc.
struct Bounce {
  double v;
  double surface;  // Rω
};

Bounce bounce(double v, double surface, double down, double radius, double inertia_factor,
              const SurfaceLaw& m) {
  ImpactSide floor;
  ImpactSide ball;
  ball.velocity = {v, -down};
  ball.spin = surface / radius;
  ball.inverse_mass = 1.0 / 0.3;
  ball.inverse_inertia = ball.inverse_mass / (inertia_factor * radius * radius);
  ball.arm = radius;
  (void)resolve_impact(floor, ball, {0.0, 1.0}, m);
  EXPECT_NEAR(ball.velocity.y(), m.restitution * down, 1e-14);
  return {ball.velocity.x(), ball.spin * radius};
}

// Garwin, American Journal of Physics 37 (1969) 88, with β = I/mR²:
// v' = v - β(1+e_t)s/(1+β), Rω' = Rω - (1+e_t)s/(1+β).
TEST(ImpactLaw, Superball) {
  SurfaceLaw m{0.9, 1.0, 100.0, 100.0};
  for (const double et : {0.0, 0.5, 1.0}) {
    m.tangential_restitution = et;
    for (const double beta : {0.5, 0.4}) {
      const double v = 1.3, w = -0.4, s = v + w;
      const Bounce b = bounce(v, w, 2.0, 0.7, beta, m);
      EXPECT_NEAR(b.v, v - beta * (1.0 + et) * s / (1.0 + beta), 1e-14);
      EXPECT_NEAR(b.surface, w - (1.0 + et) * s / (1.0 + beta), 1e-14);
    }
  }
  const Bounce b = bounce(1.3, -0.4, 2.0, 0.7, 0.5, m);
  EXPECT_NEAR(b.v, (1.3 - 2.0 * -0.4) / 3.0, 1e-14);
  EXPECT_NEAR(b.surface, -(4.0 * 1.3 + -0.4) / 3.0, 1e-14);
}

// Slips throughout if |s| > 3 μ (1+e) v_n for a disc, else v' = (v - βRω)/(1+β).
TEST(ImpactLaw, RoughBounce) {
  const SurfaceLaw m{0.8, 0.0, 0.3, 0.2};
  const double down = 1.5;
  const double limit = 3.0 * 0.2 * 1.8 * down;
  for (const double s :
       {0.2 * limit, 0.999 * limit, 1.001 * limit, 3.0 * limit, -0.999 * limit, -1.001 * limit}) {
    const double w = 0.3, v = s - w;
    const Bounce b = bounce(v, w, down, 0.25, 0.5, m);
    if (std::abs(s) > limit) {
      EXPECT_NEAR(b.v, v - std::copysign(0.2 * 1.8 * down, s), 1e-14) << s;
      EXPECT_GT(std::abs(b.v + b.surface), 1e-4) << s;
    } else {
      EXPECT_NEAR(b.v, (v - 0.5 * w) / 1.5, 1e-14) << s;
      EXPECT_NEAR(b.v + b.surface, 0.0, 1e-14) << s;
    }
  }
}

}  // namespace
}  // namespace carom
