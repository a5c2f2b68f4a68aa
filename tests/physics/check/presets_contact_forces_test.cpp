#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <utility>

#include "physics/preset/preset_file.h"
#include "physics/run/simulation.h"
#include "tests/support/source_folder.h"

// What presets of lasting contacts say of contact forces, which no expectation can read.
namespace carom {
namespace {

int index_of(const Simulation& s, const std::string& name) {
  for (std::size_t i = 0; i < s.bodies().size(); ++i) {
    if (s.bodies()[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

// N, normal and tangential, from a to b over all their points.
std::pair<double, double> load(const Simulation& s, const std::string& a, const std::string& b) {
  const int i = index_of(s, a);
  const int j = index_of(s, b);
  std::pair<double, double> sum;
  for (const ContactForce& f : s.contact_forces()) {
    if (f.a != i || f.b != j) continue;
    sum.first += f.normal_force;
    sum.second += f.tangential_force;
  }
  return sum;
}

TEST(PresetsContactForces, EachBoxBearsTheWeightAbove) {
  Simulation s(setup_of(read_preset(test::preset_file("piles/stacked-boxes.json"))));
  const double g = 9.81;
  // To what contact forces are solved, 1e-10 m g and some.
  const double within = 1e-8;
  s.advance_to(0.5);
  EXPECT_NEAR(load(s, "table", "brick-4").first, 4.0 * g, within);
  EXPECT_NEAR(load(s, "brick-4", "brick-3").first, 3.0 * g, within);
  EXPECT_NEAR(load(s, "brick-3", "brick-2").first, 2.0 * g, within);
  EXPECT_NEAR(load(s, "brick-2", "brick-1").first, g, within);
  EXPECT_NEAR(load(s, "brick-2", "brick-1").second, 0.0, within);
  // The pulled pair: the upper one, of 1 kg, is taken along with 10 N / 3 kg by friction alone.
  EXPECT_NEAR(load(s, "floor", "lower").first, 3.0 * g, within);
  EXPECT_NEAR(load(s, "lower", "upper").first, g, within);
  EXPECT_NEAR(load(s, "lower", "upper").second, -10.0 / 3.0, within);
}

}  // namespace
}  // namespace carom
