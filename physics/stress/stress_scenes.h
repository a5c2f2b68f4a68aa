#pragma once

#include <span>
#include <string>
#include <vector>

#include "physics/scene/scene.h"
#include "physics/stress/stress.h"
#include "physics/world/simulation.h"

// What the cases build their scenes from and read off their runs.
namespace carom::stress {

// The cases of the suite by theme.
[[nodiscard]] std::span<const StressCase> stacks();
[[nodiscard]] std::span<const StressCase> piles();
[[nodiscard]] std::span<const StressCase> friction();
[[nodiscard]] std::span<const StressCase> impacts();
[[nodiscard]] std::span<const StressCase> rods();
[[nodiscard]] std::span<const StressCase> integrators();

inline constexpr double kGravity = 9.81;  // m/s²
// m: a body that moves less is at rest. It is what the block on an incline below the friction cone may creep.
inline constexpr double kRest = 1e-6;
// m and m/s: what counts as rounding, of scenes of metres and metres a second; a contact solve is stated to it.
inline constexpr double kRounding = 1e-9;

// The half-plane whose surface passes through `point`, turned by `angle` from a floor.
[[nodiscard]] Body half_plane(const std::string& name, Vec2 point, double angle = 0.0);
[[nodiscard]] Body box(const std::string& name, Vec2 position, double width, double height, double mass = 1.0);
[[nodiscard]] Body disc(const std::string& name, Vec2 position, double radius, double mass = 1.0);
// A homogeneous convex plate with these corners in the plane, at rest.
[[nodiscard]] Body plate(const std::string& name, const std::vector<Vec2>& corners, double mass);
// Of one material with one coefficient of friction.
[[nodiscard]] RunSetup scene(const StressSetting& setting, std::vector<Body> bodies, double restitution,
                             double friction, double gravity = kGravity);
// A run of it up to `time` (s).
[[nodiscard]] Simulation run(const RunSetup& setup, double time);

// m, of all pairs that penetration now; zero if there are none.
struct Penetrations {
  double largest = 0.0;
  double mean = 0.0;
};
[[nodiscard]] Penetrations penetrations_of(const Simulation& simulation);

// kg, of all that moves.
[[nodiscard]] double moving_mass(const Simulation& simulation);

// How much a scene of falling bodies gains in one step, beside what drives and pushes out of penetrations put
// in. Its unit is ½ M g² h², M being the moving mass: what a step of explicit Euler gains in free fall (x' = x
// + h v, v' = v - h g). No impact and no friction adds to it, so by theory the largest is 1 under explicit
// Euler and 0 where gravity is integrated exactly; contacts that last are of order 1 and may use up the same.
class EnergyRise {
 public:
  explicit EnergyRise(const Simulation& simulation);
  // After each step.
  void look(const Simulation& simulation);
  [[nodiscard]] double largest() const { return largest_ / unit_; }

 private:
  double unit_;  // J
  double before_;
  double largest_ = 0.0;  // J
};
// For rounding, beside that 1.
inline constexpr double kLargestRise = 1.0 + 1e-6;

// The largest rise, and the largest penetration (m) at the ends of the steps, of a run up to `time` (s).
struct RiseAndOverlap {
  double rise;
  double overlap;
};
[[nodiscard]] RiseAndOverlap look_to(Simulation& simulation, double time);

}  // namespace carom::stress
