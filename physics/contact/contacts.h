#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/model/index.h"
#include "physics/scene/scene.h"

namespace carom {

// The resting contacts of one (sub-)step, one array per quantity, in an order that the caller keeps from step
// to step. With r the contact point minus the body's centre, u = (v_B + ω_B×r_B) - (v_A + ω_A×r_A) is the
// relative velocity and w = ω_B - ω_A the relative spin; t is n turned by +90°. The impulse +λ acts on B, -λ
// on A.
struct Contacts {
  std::vector<BodyIndex> a, b;           // bodies
  std::vector<Vec2> normal;              // unit vectors from A to B
  std::vector<Vec2> arm_a, arm_b;        // r_A and r_B, m
  std::vector<double> gap;               // m, negative for a penetration
  std::vector<double> target;            // b_n: least normal velocity after the solve, m/s
  std::vector<double> slip_target;       // b_t: the tangential velocity after the solve that is no slip, m/s
  std::vector<double> static_friction;   // μ_s, dimensionless; holds while the contact sticks
  std::vector<double> kinetic_friction;  // μ_k, dimensionless; holds while it slides
  std::vector<double> rolling;           // ρ >= 0: |M| <= ρ λ_n, m
  std::vector<std::uint8_t> sticks;  // in: static friction applies; out: the contact sticks after this solve
  std::vector<double> normal_impulse, tangential_impulse;  // N s; in: the guess, out: the solution
  std::vector<double> rolling_impulse;                     // N m s; likewise

  [[nodiscard]] int size() const { return static_cast<int>(a.size()); }
  [[nodiscard]] bool rubs(int i) const { return static_friction[i] > 0.0; }  // μ_s >= μ_k

  // New entries are frictionless, without impulse, and touch at targets 0.
  void resize(int n) {
    const auto count = static_cast<std::size_t>(n);
    a.resize(count);
    b.resize(count);
    for (auto* vectors : {&normal, &arm_a, &arm_b}) vectors->resize(count, Vec2::Zero());
    for (auto* numbers : {&gap, &target, &slip_target, &static_friction, &kinetic_friction, &rolling,
                          &normal_impulse, &tangential_impulse, &rolling_impulse}) {
      numbers->resize(count, 0.0);
    }
    sticks.resize(count, 0);
  }
};

}  // namespace carom
