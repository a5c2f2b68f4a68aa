#pragma once

#include <span>
#include <string>
#include <vector>

#include "physics/run/simulation.h"
#include "physics/scene/scene.h"
#include "tests/hard_cases/stress.h"

// Tools of the cases to build scenes and read figures from runs.
namespace carom::stress {

// The cases of the suite by theme.
[[nodiscard]] std::span<const StressCase> stacks();
[[nodiscard]] std::span<const StressCase> piles();
[[nodiscard]] std::span<const StressCase> friction();
[[nodiscard]] std::span<const StressCase> impacts();
[[nodiscard]] std::span<const StressCase> rods();
[[nodiscard]] std::span<const StressCase> integrators();

inline constexpr double kGravity = 9.81;  // m/s²
// m: a body that moves less is at rest. A block on an incline below the friction cone may creep this far.
inline constexpr double kRest = 1e-6;
// m and m/s: counts as rounding in scenes of metres and metres a second; the tolerance of a contact solve.
inline constexpr double kRounding = 1e-9;

// The half-plane whose surface passes through `point`, turned by `angle` from a floor.
[[nodiscard]] Body half_plane(const std::string& name, Vec2 point, double angle = 0.0);
[[nodiscard]] Body box(const std::string& name, Vec2 position, double width, double height, double mass = 1.0);
[[nodiscard]] Body disc(const std::string& name, Vec2 position, double radius, double mass = 1.0);
// A homogeneous convex plate with these corners in the plane, at rest.
[[nodiscard]] Body plate(const std::string& name, const std::vector<Vec2>& corners, double mass);
// With one material and one coefficient of friction.
[[nodiscard]] RunSetup scene(const StressSetting& setting, std::vector<Body> bodies, double restitution,
                             double friction, double gravity = kGravity);
// Runs it up to `time` (s).
[[nodiscard]] Simulation run(const RunSetup& setup, double time);

// m, of all pairs that penetrate now; zero if there are none.
struct Penetrations {
  double largest = 0.0;
  double mean = 0.0;
};
[[nodiscard]] Penetrations penetrations_of(const Simulation& simulation);

// kg, of all moving bodies.
[[nodiscard]] double moving_mass(const Simulation& simulation);

// Energy that a scene of falling bodies gains in one step, without that of drives and of pushes out of
// penetrations. Its unit is ½ M g² h², where M is the moving mass: the gain of explicit Euler in a step of
// free fall (x' = x + h v, v' = v - h g). Impacts and friction add nothing to it, so by theory the largest
// gain is 1 under explicit Euler and 0 if gravity is integrated exactly. Resting contacts are of order 1 and
// may also reach 1.
class EnergyRise {
 public:
  explicit EnergyRise(const Simulation& simulation);
  // Call after each step.
  void look(const Simulation& simulation);
  [[nodiscard]] double largest() const { return largest_ / unit_; }

 private:
  double unit_;  // J
  double before_;
  double largest_ = 0.0;  // J
};
// Rounding above that 1.
inline constexpr double kLargestRise = 1.0 + 1e-6;

// The largest energy gain, and the largest penetration (m) at the ends of the steps, of a run up to `time`
// (s).
struct RiseAndOverlap {
  double rise;
  double overlap;
};
[[nodiscard]] RiseAndOverlap look_to(Simulation& simulation, double time);

}  // namespace carom::stress
