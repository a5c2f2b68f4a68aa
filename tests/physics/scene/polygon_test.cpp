#include "physics/scene/polygon.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "physics/scene/scene.h"
#include "tests/support/draws.h"

namespace carom {
namespace {

using test::Draws;

const std::vector<Vec2> kL = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
const std::vector<Vec2> kU = {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
const std::vector<Vec2> kCross = {{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2},
                                  {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};

// Centroid and second moment over area by exact fractions: Green's sums over the integer corners.
TEST(Polygon, MomentsOfConcaveShapes) {
  struct Known {
    std::vector<Vec2> vertices;
    Vec2 centroid;
    double second_over_area;
  };
  for (const auto& [vertices, centroid, second] :
       {Known{kL, {1.1, 1.1}, 217.0 / 150.0}, Known{kU, {1.5, 0.9}, 181.0 / 150.0},
        Known{kCross, {1.5, 1.5}, 29.0 / 30.0}}) {
    const PlateMoments m = moments_of(vertices, 0.0);
    EXPECT_NEAR(m.area, 5.0, 1e-14);
    EXPECT_NEAR((m.centroid - centroid).norm(), 0.0, 1e-15);
    EXPECT_NEAR(m.second_moment / m.area, second, 1e-14);
    EXPECT_NEAR(inertia_per_mass(Polygon{vertices}), second, 1e-14);
    // Turned, and the other way round.
    std::vector<Vec2> turned(vertices.rbegin(), vertices.rend());
    for (Vec2& v : turned) v = turned_by(0.7, v) + Vec2(100.0, -30.0);
    EXPECT_NEAR(inertia_per_mass(Polygon{turned}), second, 1e-11);
  }
}

TEST(Polygon, AnOpenChainMustNotMeetItself) {
  const std::vector<Vec2> chain = {{0, 0}, {4, 0}, {4, 2}, {1, 2}};
  EXPECT_FALSE(crosses(chain, Vec2(1, 1)));
  EXPECT_FALSE(crosses(chain, Vec2(0, 5))) << "it may go straight on, or turn either way";
  EXPECT_FALSE(crosses(chain, Vec2(-3, 2)));
  EXPECT_TRUE(crosses(chain, Vec2(1, -1)));
  EXPECT_TRUE(crosses(chain, Vec2(1, 0))) << "it touches";
  EXPECT_TRUE(crosses(chain, Vec2(0, 0)));
  EXPECT_TRUE(crosses(chain, Vec2(2, 2))) << "straight back";
  EXPECT_FALSE(crosses(std::vector<Vec2>{{0, 0}}, Vec2(1, 1)));
}

double turn_at(const std::vector<Vec2>& v, std::size_t k) {
  const Vec2& a = v[(k + v.size() - 1) % v.size()];
  const Vec2& b = v[(k + 1) % v.size()];
  return cross(v[k] - a, b - v[k]);
}

void expect_pieces_of(const std::vector<Vec2>& vertices) {
  const std::vector<std::vector<Vec2>> pieces = convex_pieces(vertices);
  std::size_t reentrant = 0;
  for (std::size_t k = 0; k < vertices.size(); ++k) reentrant += turn_at(vertices, k) > 0.0 ? 0 : 1;
  EXPECT_LE(pieces.size(), 2 * reentrant + 1);
  const PlateMoments whole = moments_of(vertices, 0.0);
  double area = 0.0;
  double second = 0.0;
  Vec2 first = Vec2::Zero();
  for (const std::vector<Vec2>& piece : pieces) {
    ASSERT_LE(piece.size(), static_cast<std::size_t>(kMostVertices));
    for (std::size_t k = 0; k < piece.size(); ++k) EXPECT_GT(turn_at(piece, k), 0.0);
    const PlateMoments m = moments_of(piece, 0.0);
    area += m.area;
    first += m.area * m.centroid;
    second += m.second_moment + m.area * (m.centroid - whole.centroid).squaredNorm();
  }
  EXPECT_NEAR(area, whole.area, 1e-8 * whole.area);
  EXPECT_NEAR((first / area - whole.centroid).norm(), 0.0, 1e-8 * std::sqrt(whole.area));
  EXPECT_NEAR(second, whole.second_moment, 1e-7 * whole.second_moment);
}

TEST(Polygon, IsTakenApartIntoConvexPieces) {
  EXPECT_EQ(convex_pieces(kL).size(), 2U);
  EXPECT_EQ(convex_pieces(kU).size(), 3U);
  EXPECT_LE(convex_pieces(kCross).size(), 5U);
  for (const auto& vertices : {kL, kU, kCross}) expect_pieces_of(vertices);
  const std::vector<Vec2> convex = {{0, 0}, {1, 0}, {0, 1}};
  EXPECT_EQ(convex_pieces(convex), std::vector<std::vector<Vec2>>{convex});
}

// Corners at rising angles about a point, at any distance: no edges cross.
TEST(Polygon, RandomStarsAreTakenApart) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Draws draws(seed);
    const int corners = 4 + static_cast<int>(draws.between(0.0, 60.0));
    std::vector<Vec2> vertices;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + draws.between(0.0, 0.9)) / corners;
      vertices.emplace_back(draws.between(0.2, 2.0) * direction_at(angle));
    }
    ASSERT_FALSE(fault_of(vertices, 0.0).has_value()) << seed << ": " << *fault_of(vertices, 0.0);
    SCOPED_TRACE(seed);
    expect_pieces_of(tidied(vertices));
  }
}

TEST(Polygon, EdgesMayNotCross) {
  const auto fault = [](const std::vector<Vec2>& v, double rounding = 0.0) {
    return fault_of(v, rounding).value_or("");
  };
  EXPECT_NE(fault({{0, 0}, {1, 1}, {1, 0}, {0, 1}}).find("edges that cross"), std::string::npos);
  // An edge through another's corner, and a corner on an edge.
  EXPECT_NE(fault({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}).find("edges that cross"), std::string::npos);
  // Out and straight back.
  EXPECT_NE(fault({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 5}, {2, 2.5}, {0, 2}}), "");
  EXPECT_EQ(fault(kL), "");
  EXPECT_NE(fault(kL, 0.1).find("reentrant corner at [1, 1] of a rounded polygon"), std::string::npos);
}

}  // namespace
}  // namespace carom
