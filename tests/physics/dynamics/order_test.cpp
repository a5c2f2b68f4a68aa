#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <type_traits>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/run/run_setup.h"
#include "tests/support/scenes.h"

// The order of every method through impacts, and what takes its place where there is no step.
namespace carom {
namespace {

using test::disc;
using test::setup_with;
using test::wall;

struct Trial {
  const char* name;
  RunSetup setup;
  int body;     // whose position is compared
  double time;  // s, well away from impacts
  int impacts;  // at least
};

// Gravity and quadratic drag in a box; the disc always moves.
Trial drag_in_a_box() {
  RunSetup s =
      setup_with({wall("floor", {0.0, -0.1}, 2.4, 0.2), wall("left", {-1.1, 1.25}, 0.2, 2.5),
                  wall("right", {1.1, 1.25}, 0.2, 2.5), disc("disc", {0.0, 1.0}, {13.0, 3.0}, 0.05, 0.5)},
                 0.9);
  s.scene.forces.gravity = {0.0, -60.0};
  s.scene.forces.quadratic_drag = 0.12;
  return {"drag in a box", s, 3, 1.6, 5};
}

// A damped spring pulls a disc at a wall, which it meets over and over, with friction and drag.
Trial spring_and_wall() {
  RunSetup s = setup_with({wall("wall", {0.0, -0.5}, 4.0, 1.0), disc("disc", {0.3, 0.9}, {0.5, 0.0}, 0.1, 0.7)},
                          0.95, 0.1);
  Spring spring;
  spring.body = "disc";
  spring.anchor = {0.0, -0.1};
  spring.stiffness = 30.0;
  spring.damping = 0.05;
  spring.rest_length = 0.05;
  s.scene.forces.springs = {spring};
  s.scene.forces.linear_drag = 0.02;
  return {"spring and wall", s, 1, 2.5, 5};
}

// A spring pulls a disc onto a table that vibrates and rises.
Trial moving_wall() {
  RunSetup s = setup_with(
      {wall("table", {0.0, -0.5}, 4.0, 1.0), disc("disc", {0.3, 0.9}, {0.5, 0.0}, 0.1, 0.7)}, 0.9, 0.1);
  s.scene.bodies[0].fixed = false;
  s.scene.bodies[0].drive = Drive{{0.02, 0.05}, {0.0, 0.02}, 9.0, 0.4};
  Spring spring;
  spring.body = "disc";
  spring.anchor = {0.0, -0.1};
  spring.stiffness = 40.0;
  spring.rest_length = 0.05;
  s.scene.forces.springs = {spring};
  s.scene.forces.quadratic_drag = 0.05;
  return {"moving wall", s, 1, 2.5, 5};
}

std::vector<Trial> trials() { return {drag_in_a_box(), spring_and_wall(), moving_wall()}; }

// The same with the compared body thrown a little faster each time. The error's constant depends on
// where in their steps the impacts fall; over several throws this evens out.
std::vector<Trial> throws_of(const Trial& t) {
  std::vector<Trial> all(8, t);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].setup.scene.bodies[t.body].velocity += static_cast<double>(i) * Vec2(0.05, 0.11);
  }
  return all;
}

// Where the body is, at the end and at earlier moments on the grid of all steps that are used here.
constexpr int kMoments = 32;
struct Result {
  Eigen::Vector4d where;  // position and velocity at the end
  Eigen::Matrix4Xd moments = Eigen::Matrix4Xd::Zero(4, kMoments);
  std::vector<double> impact_times;
  std::int64_t impacts;
  std::int64_t evaluations;
  std::int64_t rejected;
};

Result run(const Trial& t, IntegratorId id, double step, double tolerance = 1e-9) {
  RunSetup s = t.setup;
  s.method.integrator = id;
  s.method.step = step;
  s.method.tolerance = tolerance;
  Simulation simulation(s);
  Result r;
  const auto look = [&] {
    Eigen::Vector4d where;
    where << simulation.state().position(t.body), simulation.state().velocity(t.body);
    return where;
  };
  for (int i = 0; i < kMoments; ++i) {
    simulation.advance_to(t.time * (i + 1) / kMoments, [&] {
      for (const ImpactRecord& impact : simulation.last_impacts()) r.impact_times.push_back(impact.time);
    });
    r.moments.col(i) = look();
  }
  r.where = look();
  r.impacts = simulation.impact_count();
  r.evaluations = simulation.evaluations();
  r.rejected = simulation.rejected_steps();
  return r;
}

// Sums of squares over the moments that come after at least five impacts of the reference and are well away
// from any.
struct Errors {
  double sum = 0.0;
  int count = 0;
  void add(const Trial& t, const Result& r, const Result& exact) {
    for (int i = 0; i < kMoments; ++i) {
      const double moment = t.time * (i + 1) / kMoments;
      int before = 0;
      bool near = false;
      for (const double impact : exact.impact_times) {
        before += impact < moment ? 1 : 0;
        near = near || std::abs(impact - moment) < 0.015 * t.time;
      }
      if (before < 5 || near) continue;
      sum += (r.moments.col(i) - exact.moments.col(i)).squaredNorm();
      ++count;
    }
  }
  [[nodiscard]] double rms() const { return std::sqrt(sum / count); }
};

// Steps that differ by a factor of two agree to 3e-12, most of it rounding: the reference's own error is far
// below.
std::vector<Result> references(const Trial& t) {
  static std::map<std::string, std::vector<Result>> known;
  auto& results = known[t.name];
  if (!results.empty()) return results;
  for (const Trial& one : throws_of(t)) {
    const Result coarse = run(one, IntegratorId::kDormandPrince, t.time / 4096);
    results.push_back(run(one, IntegratorId::kDormandPrince, t.time / 8192));
    EXPECT_LT((coarse.where - results.back().where).norm(), 1e-12) << t.name;
    EXPECT_GE(results.back().impacts, t.impacts) << t.name;
  }
  return results;
}

constexpr double kFloor = 1e-14;  // m, m/s: rounding of these scenes

template <class Id>
class Method : public testing::Test {
 protected:
  static constexpr IntegratorId kId = Id::value;
  static constexpr IntegratorChoice kChoice = choice_of(kIntegrators, kId);
};

template <IntegratorId kId>
using As = std::integral_constant<IntegratorId, kId>;
struct Names {
  template <class Id>
  static std::string GetName(int /*index*/) {
    std::string name(choice_of(kIntegrators, Id::value).name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
  }
};
using Stepping =
    testing::Types<As<IntegratorId::kExplicitEuler>, As<IntegratorId::kSemiImplicitEuler>,
                   As<IntegratorId::kVelocityVerlet>, As<IntegratorId::kRk4>, As<IntegratorId::kDormandPrince>>;
using Adaptive = testing::Types<As<IntegratorId::kAdaptiveDormandPrince>>;
using All =
    testing::Types<As<IntegratorId::kExplicitEuler>, As<IntegratorId::kSemiImplicitEuler>,
                   As<IntegratorId::kVelocityVerlet>, As<IntegratorId::kRk4>, As<IntegratorId::kDormandPrince>,
                   As<IntegratorId::kAdaptiveDormandPrince>, As<IntegratorId::kExactFlight>>;
template <class Id>
class SteppingMethod : public Method<Id> {};
template <class Id>
class AdaptiveMethod : public Method<Id> {};
TYPED_TEST_SUITE(Method, All, Names);
TYPED_TEST_SUITE(SteppingMethod, Stepping, Names);
TYPED_TEST_SUITE(AdaptiveMethod, Adaptive, Names);

TEST(Methods, AreAllTried) { EXPECT_EQ(kIntegrators.size(), 7U); }

TYPED_TEST(SteppingMethod, KeepsItsOrderThroughImpacts) {
  for (const Trial& t : trials()) {
    const std::vector<Trial> throws = throws_of(t);
    const std::vector<Result> exact = references(t);
    // Steps over a factor of 16, a quarter of an octave apart: the constant of the error changes with the
    // places of the impacts within their steps, and only many steps tell the order in spite of it.
    std::vector<std::pair<double, double>> points;
    const std::map<int, int> steps_a_moment = {{1, 128}, {2, 16}, {4, 8}, {5, 6}};
    const int coarsest = steps_a_moment.at(this->kChoice.order);
    for (int i = 0; i <= 12; ++i) {
      const double h = t.time / kMoments / std::round(coarsest * std::exp2(0.25 * i));
      Errors errors;
      for (std::size_t k = 0; k < throws.size(); ++k) errors.add(t, run(throws[k], this->kId, h), exact[k]);
      const double error = errors.rms();
      if (error > 100.0 * kFloor) points.emplace_back(std::log(h), std::log(error));
    }
    ASSERT_GE(points.size(), 8U) << t.name;
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const auto& [x, y] : points) sx += x, sy += y, sxx += x * x, sxy += x * y;
    const double n = static_cast<double>(points.size());
    const double order = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    this->RecordProperty(t.name, fmt::format("{:.3f}", order));
    EXPECT_NEAR(order, this->kChoice.order, 0.15)
        << t.name
        << fmt::format(", h = {:.2g} to {:.2g} s, errors {:.2g} to {:.2g}", std::exp(points.front().first),
                       std::exp(points.back().first), std::exp(points.front().second),
                       std::exp(points.back().second));
  }
}

TYPED_TEST(AdaptiveMethod, ErrorFollowsTheTolerance) {
  for (const Trial& t : trials()) {
    const Eigen::Vector4d exact = references(t)[0].where;
    double last = 1.0;
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const Result r = run(t, this->kId, 0.05, tolerance);
      const double error = (r.where - exact).norm();
      EXPECT_LT(error, 2000.0 * tolerance) << t.name << ", " << tolerance;
      EXPECT_LT(error, 0.2 * last) << t.name << ", " << tolerance;
      last = error;
    }
    // What is looked at in between leaves no trace.
    EXPECT_EQ(run(t, this->kId, 0.05, 1e-8).where, run(t, this->kId, 0.05 + 0.05 / 3, 1e-8).where) << t.name;
  }
}

TYPED_TEST(Method, CountsWhatItEvaluates) {
  RunSetup s = setup_with({disc("d", {0, 0}, {7, 9})});
  s.scene.forces.gravity = {0.0, -9.81};
  s.method = {.integrator = this->kId, .impacts = ImpactsId::kStepEnd, .step = 0.01};
  if (this->kChoice.order > 0) s.scene.forces.linear_drag = 0.1;
  Simulation simulation(s);
  for (int i = 0; i < 100; ++i) simulation.step();
  if (!this->kChoice.adaptive) {
    EXPECT_EQ(simulation.evaluations(), 100 * this->kChoice.evaluations);
    EXPECT_EQ(simulation.rejected_steps(), 0);
  } else {
    EXPECT_GT(simulation.evaluations(), 0);
  }
}

// Discs under gravity between walls: every method that is exact there is, at any step.
TYPED_TEST(Method, IsExactUnderGravityIfItsTableSaysSo) {
  RunSetup s = setup_with({wall("floor", {0.0, -0.1}, 2.4, 0.2), wall("left", {-1.1, 1.25}, 0.2, 2.5),
                           wall("right", {1.1, 1.25}, 0.2, 2.5), disc("a", {0.0, 1.0}, {2.0, 3.0}, 0.1, 0.5),
                           disc("b", {0.5, 1.7}, {-1.0, 0.0}, 0.2, 1.0)},
                          0.9);
  s.scene.forces.gravity = {0.0, -9.81};
  const Trial t{"gravity", s, 3, 1.5, 5};
  const Result exact = run(t, IntegratorId::kExactFlight, 0.01);
  EXPECT_GE(exact.impacts, 5);
  for (const double h : {0.1, 0.01, 0.0037}) {
    const double error = (run(t, this->kId, h).where - exact.where).norm();
    if (this->kChoice.exact_under_gravity) {
      EXPECT_LT(error, 1e-11) << h;
    } else {
      EXPECT_GT(error, 1e-4) << h;
    }
  }
}

// Of the triangle wave that a disc makes in an empty box there is a formula.
TYPED_TEST(Method, StraightFlightIsExact) {
  RunSetup s = setup_with(test::room(1.0, 0.5));
  s.scene.bodies.push_back(disc("d", {0.1, 0.2}, {1.7, 0.9}, 0.25));
  s.method = {.integrator = this->kId, .step = 0.013};
  Simulation simulation(s);
  simulation.advance_to(100.0);
  const auto folded = [](double x) {
    const double phase = std::fmod(std::fmod(x + 0.75, 3.0) + 3.0, 3.0);
    return (phase < 1.5 ? phase : 3.0 - phase) - 0.75;
  };
  EXPECT_NEAR(simulation.state().position(4).x(), folded(0.1 + 170.0), 1e-11);
  EXPECT_NEAR(simulation.state().position(4).y(), folded(0.2 + 90.0), 1e-11);
  EXPECT_GT(simulation.impact_count(), 150);
}

}  // namespace
}  // namespace carom
