#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/run/run_setup.h"
#include "tests/hard_cases/stress_scenes.h"

// Slopes at the limit of friction, rolling and sliding, a swinging table.
namespace carom::stress {
namespace {

constexpr double kPercent = 100.0;

// A slope through the origin that falls to the right by `angle`.
struct Slope {
  explicit Slope(double tangent)
      : angle(std::atan(tangent)),
        down(std::cos(angle), -std::sin(angle)),
        up(std::sin(angle), std::cos(angle)) {}
  [[nodiscard]] Body surface() const { return half_plane("slope", {0, 0}, -angle); }

  double angle;  // rad
  Vec2 down;     // unit, along the slope
  Vec2 up;       // unit, outward normal
};

// A flat box, released at rest on a slope of `share` times its friction: its distance and speed down the
// slope.
struct Slid {
  double distance;      // m
  double speed;         // m/s
  double acceleration;  // m/s², by theory
};
Slid slide(const StressSetting& setting, double share, double time) {
  constexpr double kFriction = 0.5;
  constexpr double kHeight = 0.4;  // m
  const Slope slope(share * kFriction);
  Body block = box("block", 0.5 * kHeight * slope.up, 1.0, kHeight);
  block.angle = -slope.angle;
  const Simulation simulation = run(scene(setting, {slope.surface(), block}, 0.0, kFriction), time);
  const Vec2 moved = simulation.state().position(1) - block.position;
  return {moved.dot(slope.down), simulation.state().velocity(1).dot(slope.down),
          kGravity * (std::sin(slope.angle) - kFriction * std::cos(slope.angle))};
}

std::vector<double> incline_below(const StressSetting& s) { return {slide(s, 0.995, 60.0).distance}; }
constexpr StressFigure kBelowFigures[] = {
    {"creep in 60 s", "m", kRest, "theory: tan θ < μ_s holds it; less than 1e-6 m is asked for"}};

std::vector<double> incline_above(const StressSetting& s) {
  constexpr double kTime = 10.0;
  const Slid slid = slide(s, 1.005, kTime);
  return {kPercent * (slid.speed / (slid.acceleration * kTime) - 1.0)};
}
constexpr StressFigure kAboveFigures[] = {
    {"error of the acceleration", "%", 0.1, "theory: a = g(sin θ - μ cos θ); 0.1 % is asked for"}};

// A disc released on a slope: speed v and slip v + R ω after `time`, measured and by theory.
std::vector<double> rolling_threshold(const StressSetting& setting) {
  constexpr double kFriction = 0.2;
  constexpr double kRadius = 0.1;  // m
  constexpr double kTime = 2.0;    // s
  const auto roll = [&](const Slope& slope) -> Vec2 {
    const Body body = disc("disc", kRadius * slope.up, kRadius);
    const Simulation simulation = run(scene(setting, {slope.surface(), body}, 0.0, kFriction), kTime);
    const double v = simulation.state().velocity(1).dot(slope.down);
    return {v, v + kRadius * simulation.state().v(2, 1)};
  };
  const Slope rolling(3.0 * kFriction * 0.99);
  const Vec2 below = roll(rolling);
  const double rolled = 2.0 / 3.0 * kGravity * std::sin(rolling.angle) * kTime;
  const Slope slipping(3.0 * kFriction * 1.01);
  const Vec2 above = roll(slipping);
  const double weight = kGravity * kTime;
  const double slid = weight * (std::sin(slipping.angle) - kFriction * std::cos(slipping.angle));
  const double slip = weight * (std::sin(slipping.angle) - 3.0 * kFriction * std::cos(slipping.angle));
  return {kPercent * (below.x() / rolled - 1.0), kPercent * below.y() / rolled,
          kPercent * (above.x() / slid - 1.0), kPercent * (above.y() / slip - 1.0)};
}
constexpr StressFigure kRollingFigures[] = {
    {"1 % below: error of the acceleration", "%", 0.1, "theory: a = (2/3) g sin θ; 0.1 % is asked for"},
    {"1 % below: slip over speed", "%", 0.1, "theory: it rolls where tan θ < 3 μ_s; 0.1 % is asked for"},
    {"1 % above: error of the acceleration", "%", 0.1, "theory: a = g(sin θ - μ cos θ); 0.1 % is asked for"},
    {"1 % above: error of the slip", "%", 0.1,
     "theory: the slip grows by g(sin θ - 3 μ cos θ); 0.1 % is asked for"},
};

// A wedge of half angle α lies with its lower face on a slope that falls by α. On its upper face, which rises
// by α, lies a block 100 times heavier. Block and wedge are both at the limit tan α = μ, because on either
// face the force is the weight, straight down.
std::vector<double> wedge(const StressSetting& setting) {
  constexpr double kFriction = 0.5;
  constexpr double kThin = 0.1;    // m, half of the thin end
  constexpr double kHeight = 0.4;  // m, of the block
  const Slope slope(0.99 * kFriction);
  const double half = kThin + std::tan(slope.angle);
  const Body wedge = plate("wedge", {{0.0, -kThin}, {1.0, -half}, {1.0, half}, {0.0, kThin}}, 1.0);
  const Vec2 normal(-std::sin(slope.angle), std::cos(slope.angle));
  Body block = box("block", Vec2(0.5, 0.5 * (kThin + half)) + 0.5 * kHeight * normal, 1.0, kHeight, 100.0);
  block.angle = slope.angle;
  const Body ground = half_plane("ground", {0.0, -kThin}, -slope.angle);
  const Simulation simulation = run(scene(setting, {ground, wedge, block}, 0.0, kFriction), 10.0);
  return {(simulation.state().position(1) - wedge.position).norm(),
          (simulation.state().position(2) - block.position).norm()};
}
constexpr std::string_view kJammed = "theory: tan α < μ_s on both faces; less than 1e-6 m is rest";
constexpr StressFigure kWedgeFigures[] = {
    {"creep of the wedge", "m", kRest, kJammed},
    {"creep of the block", "m", kRest, kJammed},
};

constexpr double kDiscRadius = 0.25;  // m
constexpr double kGrip = 0.3;

// A disc placed on a floor with this velocity and spin.
Simulation disc_on_floor(const StressSetting& setting, double velocity, double spin, double rolling,
                         double time) {
  Body body = disc("disc", {0.0, kDiscRadius}, kDiscRadius);
  body.velocity = {velocity, 0.0};
  body.spin = spin;
  RunSetup s = scene(setting, {half_plane("floor", {0, 0}), body}, 0.0, kGrip);
  s.scene.materials[0].rolling_resistance = rolling;
  return run(s, time);
}

std::vector<double> spinning_disc(const StressSetting& setting) {
  constexpr double kSpin = 20.0;  // rad/s
  constexpr double kRolled = kDiscRadius * kSpin / 3.0;
  const Simulation rolls = disc_on_floor(setting, 0.0, -kSpin, 0.0, 3.0);
  const Simulation stops = disc_on_floor(setting, 0.0, -kSpin, 0.05, 10.0);
  return {rolls.state().v(0, 1) - kRolled, kDiscRadius * rolls.state().v(2, 1) + kRolled,
          std::max(stops.state().velocity(1).norm(), kDiscRadius * std::abs(stops.state().v(2, 1)))};
}
constexpr StressFigure kSpinningFigures[] = {
    {"error of the final speed", "m/s", kRounding,
     "theory: Rω₀/3 whatever the friction does: the angular momentum about the floor is kept; 1e-9 is "
     "rounding"},
    {"error of the final spin at the rim", "m/s", kRounding, "theory: rolling; 1e-9 m/s is rounding"},
    {"speed left with rolling resistance 0.05", "m/s", kRounding,
     "theory: v/(c g/1.5) = 5.1 s of rolling and it stands; 1e-9 m/s is rounding"},
};

std::vector<double> slide_to_roll(const StressSetting& setting) {
  constexpr double kSpeed = 3.0;  // m/s
  const Simulation rolls = disc_on_floor(setting, kSpeed, 0.0, 0.0, 3.0);
  return {rolls.state().v(0, 1) - 2.0 / 3.0 * kSpeed};
}
constexpr StressFigure kSlideFigures[] = {{"error of the final speed", "m/s", kRounding,
                                           "theory: 2v₀/3 whatever the friction does: the angular momentum "
                                           "about the floor is kept; 1e-9 is rounding"}};

// A box at rest on a table that swings up and down by A sin ωt with Aω²/g = 0.9: it never lifts off.
constexpr double kSwing = 0.9;
std::vector<double> driven_table(const StressSetting& setting) {
  constexpr double kThickness = 0.2;  // m, of table and box
  const double omega = 2.0 * 2.0 * std::numbers::pi;
  const double amplitude = kSwing * kGravity / (omega * omega);
  Body table = box("table", {0.0, 0.0}, 2.0, kThickness);
  table.mass.reset();
  table.drive =
      Drive{.amplitude = {0.0, amplitude}, .angular_frequency = omega, .phase = -0.5 * std::numbers::pi};
  const Body body = box("box", {0.0, kThickness - amplitude}, 0.4, kThickness);
  Simulation simulation(scene(setting, {table, body}, 0.5, kGrip));
  double gap = 0.0;
  double overlap = 0.0;
  double difference = 0.0;
  simulation.advance_to(10.0, [&] {
    const State& now = simulation.state();
    const double above = now.q(1, 1) - now.q(1, 0) - kThickness;
    gap = std::max(gap, above);
    overlap = std::max(overlap, -above);
    difference = std::max(difference, std::abs(now.v(1, 1) - now.v(1, 0)));
  });
  return {gap, overlap, difference};
}
// The largest relative acceleration opens or closes this much within one step, at order 1 in the velocity.
double within_a_step(const Method& method) {
  return 0.5 * (1.0 + kSwing) * kGravity * method.step * method.step;
}
double in_a_step(const Method& method) { return (1.0 + kSwing) * kGravity * method.step; }
constexpr std::string_view kRides =
    "theory: pressed all the time; what (1 + Aω²/g) g moves within one step is the order of the method";
constexpr StressFigure kTableFigures[] = {
    {"largest gap", "m", kNoLimit, kRides, within_a_step},
    {"largest overlap", "m", kNoLimit, kRides, within_a_step},
    {"largest difference of the velocities", "m/s", kNoLimit, kRides, in_a_step},
};

constexpr StressCase kCases[] = {
    {"incline-below", "a block on a slope of 0.995 times its friction for 60 s", incline_below, kBelowFigures},
    {"incline-above", "a block on a slope of 1.005 times its friction for 10 s", incline_above, kAboveFigures},
    {"rolling-threshold", "a disc on slopes 1 % below and above where it stops rolling", rolling_threshold,
     kRollingFigures},
    {"wedge", "a wedge under a block 100 times heavier, both faces at 0.99 of the friction, for 10 s", wedge,
     kWedgeFigures},
    {"spinning-disc", "a disc set spinning on a floor, without and with rolling resistance", spinning_disc,
     kSpinningFigures},
    {"slide-to-roll", "a disc set sliding on a floor", slide_to_roll, kSlideFigures},
    {"driven-table", "a box at rest on a table that swings with Aω²/g = 0.9, for 10 s", driven_table,
     kTableFigures},
};

}  // namespace

std::span<const StressCase> friction() { return kCases; }

}  // namespace carom::stress
