#include <algorithm>
#include <cctype>
#include <gtest/gtest.h>
#include <limits>
#include <ostream>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/run/run_setup.h"
#include "tests/support/contact_references.h"
#include "tests/support/scenes.h"

namespace carom {

namespace test {

// Name of a failing test's parameter.
void PrintTo(const ContactReference& reference, std::ostream* out) { *out << reference.name; }

}  // namespace test

namespace {

using test::ContactReference;
using test::kContactReferences;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// A gap counts as closed within 16ε of its scale, and each of up to kFewSteps steps rounds the positions once.
constexpr double kGapRounding = 32.0;
constexpr int kFewSteps = 8;

RunSetup scene_of(const ContactReference& c) {
  Body a;
  a.name = "a";
  if (c.disc_radius > 0.0) {
    a.shape = Disc{c.disc_radius};
  } else {
    a.shape = Box{c.box[0], c.box[1]};
  }
  a.position = {c.a[0], c.a[1]};
  a.angle = c.angle;
  a.fixed = c.fixed;
  if (c.kinematic) {
    a.drive = Drive{{c.a[2], c.a[3]}, {c.swing[0], c.swing[1]}, c.swing[2], c.swing[3]};
  } else {
    a.velocity = {c.a[2], c.a[3]};
  }
  RunSetup s = test::setup_with({a, test::disc("b", {c.b[0], c.b[1]}, {c.b[2], c.b[3]}, c.b_radius)});
  s.scene.forces.gravity = {0.0, -c.gravity};
  return s;
}

// m: the sum of all lengths from which a gap is computed.
double scale(const ContactReference& c) {
  double sum = c.b_radius + c.disc_radius + c.box[0] + c.box[1] + std::abs(c.swing[0]) + std::abs(c.swing[1]);
  for (int i = 0; i < 2; ++i) {
    sum += std::abs(c.a[i]) + std::abs(c.b[i]) + (std::abs(c.a[i + 2]) + std::abs(c.b[i + 2])) * c.until;
  }
  return sum + c.gravity * c.until * c.until;
}

// Euler's methods have order 1: a parabola is not exact for them.
bool is_exact(IntegratorId id, const ContactReference& c) {
  return c.gravity == 0.0 || (id != IntegratorId::kExplicitEuler && id != IntegratorId::kSemiImplicitEuler);
}

class ContactReferences : public testing::TestWithParam<ContactReference> {};

// Against roots in 100 digits: the first impact occurs at its time, within the uncertainty from the gap's
// rounding; a near miss is no impact. Under every integrator that is exact for the motion, in a few steps and
// in one.
TEST_P(ContactReferences, FirstImpact) {
  const ContactReference& c = GetParam();
  for (const IntegratorChoice& integrator : kIntegrators) {
    if (!is_exact(integrator.id, c)) continue;
    for (const int steps : {1, kFewSteps}) {
      const double step = std::min(c.until / steps, 1.0);
      RunSetup s = scene_of(c);
      s.method.integrator = integrator.id;
      s.method.impacts = ImpactsId::kLocated;
      s.method.step = step;
      Simulation simulation(s);
      while (simulation.time() < c.until * (1.0 - 1e-9) && simulation.last_impacts().empty()) simulation.step();

      const std::string what = std::string(integrator.name) + ", step " + std::to_string(step);
      const bool met = !simulation.last_impacts().empty();
      ASSERT_EQ(met, c.time >= 0.0) << what;
      if (!met) continue;
      const double rounding = kGapRounding * kEpsilon * scale(c);
      const ImpactRecord& impact = simulation.last_impacts().front();
      EXPECT_NEAR(impact.time, c.time, rounding / c.closing + 4.0 * kEpsilon * c.until) << what;
      // Where rounding shifts the gap, the speed of a grazing contact has changed a little.
      EXPECT_NEAR(impact.closing_speed, c.closing, 1e-4 * c.closing) << what;
    }
  }
}

std::string test_name(const testing::TestParamInfo<ContactReference>& reference) {
  std::string name = reference.param.name;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char x) { return std::isalnum(x) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, ContactReferences, testing::ValuesIn(kContactReferences), test_name);

}  // namespace
}  // namespace carom
