#include "widgets/scene/new_body.h"

#include <gtest/gtest.h>
#include <vector>

namespace carom {
namespace {

Body point_of(double mass) {
  Body point;
  point.name = "point";
  point.shape = Disc{0.0};
  point.mass = mass;
  return point;
}

TEST(NewBody, TheFirstOneHasARoundMass) {
  for (const double radius : {0.1, 0.137, 0.2, 3.0}) {
    const Body disc = new_body({}, Disc{radius}, Vec2::Zero());
    EXPECT_FALSE(disc.mass) << "its size can change at one density";
    EXPECT_DOUBLE_EQ(mass_of(disc), 1.0) << radius;
  }
  EXPECT_DOUBLE_EQ(mass_of(new_body({}, Box{0.3, 0.7}, Vec2::Zero())), 1.0);
}

TEST(NewBody, TheRoundMassIsNearThatOfOthers) {
  const std::vector<std::pair<double, double>> cases = {{0.03, 0.02}, {0.04, 0.05},    {3.1, 2.0},
                                                        {3.3, 5.0},   {800.0, 1000.0}, {1.0, 1.0}};
  for (const auto& [other, round] : cases)
    EXPECT_DOUBLE_EQ(mass_of(new_body(std::vector{point_of(other)}, Disc{0.1}, Vec2::Zero())), round) << other;
}

TEST(NewBody, OthersHaveTheDensityOfTheFirst) {
  Body floor;
  floor.name = "floor";
  floor.shape = Wall{};
  floor.fixed = true;
  const Body first = new_body(std::vector{floor}, Disc{0.1}, Vec2::Zero());
  EXPECT_DOUBLE_EQ(mass_of(first), 1.0);
  EXPECT_DOUBLE_EQ(mass_of(new_body(std::vector{floor, first}, Disc{0.2}, Vec2::Zero())), 4.0);
}

}  // namespace
}  // namespace carom
