#include "widgets/scene/overlap.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace carom {
namespace {

constexpr double kThin = 1e-9;

Body body_of(const std::string& name, const Shape& shape, const Vec2& at, double angle = 0.0) {
  Body body;
  body.name = name;
  body.shape = shape;
  body.position = at;
  body.angle = angle;
  return body;
}

// Whether a point lies in the body, by more than `slack`.
bool inside(const Body& body, const Vec2& point, double slack) {
  return signed_distance(outline_of(body.shape), turned_by(-body.angle, point - body.position)) < -slack;
}

// Points of the shape's inside or, of a thin wall, along it.
std::vector<Vec2> samples(const Body& body) {
  std::vector<Vec2> points;
  const double reach = std::isfinite(bounding_radius(body.shape)) ? bounding_radius(body.shape) : 1.0;
  constexpr int kCount = 60;
  const bool thin = area(body.shape) == 0.0;
  for (int i = -kCount; i <= kCount; ++i) {
    for (int k = thin ? 0 : -kCount; k <= (thin ? 0 : kCount); ++k) {
      const Vec2 local = reach / kCount * Vec2(i, k);
      if (thin || signed_distance(outline_of(body.shape), local) < 0.0) {
        points.push_back(body.position + turned_by(body.angle, local));
      }
    }
  }
  return points;
}

bool overlap_by_samples(const Body& a, const Body& b, double slack) {
  const bool plane = !std::isfinite(bounding_radius(a.shape));
  const bool thin = area(b.shape) == 0.0;
  const Body& sampled = plane || thin ? b : a;
  const Body& other = plane || thin ? a : b;
  for (const Vec2& point : samples(sampled)) {
    if (inside(other, point, slack)) return true;
  }
  return false;
}

class Shapes {
 public:
  explicit Shapes(unsigned seed) : random_(seed) {}
  double draw(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  // One draw a statement: compilers evaluate arguments in different orders.
  Body body(const std::string& name, int kind, double within) {
    const Shape form = shape(kind);
    const double x = draw(-within, within);
    const double y = draw(-within, within);
    return body_of(name, form, Vec2(x, y), draw(-std::numbers::pi, std::numbers::pi));
  }
  Shape shape(int kind) {
    switch (kind) {
      case 0:
        return Disc{draw(0.1, 0.4)};
      case 1:
        return Box{draw(0.1, 0.9), draw(0.1, 0.9)};
      case 2:
        return Polygon{{{0.0, 0.0}, {draw(0.3, 0.8), 0.0}, {draw(0.0, 0.4), draw(0.2, 0.7)}}, 0.0};
      case 3:
        return Polygon{{{0.0, 0.0}, {draw(0.2, 0.8), draw(0.0, 0.3)}}, draw(0.05, 0.2)};
      case 4:
        return Wall{draw(0.4, 1.2)};
      default:
        return Wall{};
    }
  }

 private:
  std::mt19937 random_;
};

constexpr int kKinds = 6;

TEST(Overlap, EveryPairOfShapesAsSamplingFindsIt) {
  Shapes shapes(1);
  int overlapping = 0;
  for (int a = 0; a < kKinds; ++a) {
    for (int b = 0; b < kKinds; ++b) {
      if (a >= 4 && b >= 4) continue;  // no area to sample
      for (int k = 0; k < 12; ++k) {
        const Body first = shapes.body("a", a, 0.5);
        const Body second = shapes.body("b", b, 0.5);
        const auto found = overlaps_of(std::array{first}, {{second}, {}});
        // An area thinner than the distance between two samples may escape them.
        const double depth = found.empty() ? 0.0 : found[0].depth;
        if (depth == 0.0) {
          EXPECT_FALSE(overlap_by_samples(first, second, kThin)) << a << " " << b << " " << k;
        } else if (depth > 0.06) {
          EXPECT_TRUE(overlap_by_samples(first, second, 0.0)) << a << " " << b << " " << k << " " << depth;
          ++overlapping;
        }
      }
    }
  }
  EXPECT_GT(overlapping, 100);
}

TEST(Overlap, MovedOutTouchesAndLeavesNone) {
  Shapes shapes(2);
  for (int a = 0; a < kKinds; ++a) {
    for (int b = 0; b < kKinds; ++b) {
      if (a == 5 && b == 5) continue;
      for (int k = 0; k < 20; ++k) {
        const Body first = shapes.body("a", a, 0.4);
        const Body second = shapes.body("b", b, 0.4);
        const auto before = overlaps_of(std::array{first}, {{second}, {}});
        const auto out = moved_out(std::array{first}, {{second}, {}});
        if (!out) {
          // Out of a half-plane, or with one, the way may be longer than four times the other body's size.
          EXPECT_TRUE(a == 5 || b == 5) << a << " " << b;
          const double size = bounding_radius(a == 5 ? second.shape : first.shape);
          EXPECT_TRUE(!before.empty() && before[0].depth > 3.9 * size) << a << " " << b << " " << k;
          continue;
        }
        const Vec2 moved = out->front().position - first.position;
        if (before.empty()) {
          EXPECT_LT(moved.norm(), kThin);
          continue;
        }
        EXPECT_TRUE(overlaps_of(*out, {{second}, {}}).empty()) << a << " " << b;
        // The shortest way, and no farther than touching.
        EXPECT_NEAR(moved.norm(), before[0].depth, kThin) << a << " " << b;
        Body back = out->front();
        back.position -= 1e-8 * moved.normalized();
        EXPECT_FALSE(overlaps_of(std::array{back}, {{second}, {}}).empty()) << a << " " << b;
      }
    }
  }
}

TEST(Overlap, AmongSeveralNeighboursThereIsAWayOut) {
  Shapes shapes(3);
  int several = 0;
  for (int k = 0; k < 200; ++k) {
    const Body first = shapes.body("a", k % 5, 0.6);
    Surroundings beside;
    for (int i = 0; i < 6; ++i) beside.bodies.push_back(shapes.body("b" + std::to_string(i), i, 0.9));
    beside.bodies.back().position = Vec2(0.0, -0.5);
    beside.bodies.back().angle = 0.1;
    const auto before = overlaps_of(std::array{first}, beside);
    if (before.size() > 1) ++several;
    const auto out = moved_out(std::array{first}, beside);
    if (!out) continue;
    EXPECT_TRUE(overlaps_of(*out, beside).empty());
    const double moved = (out->front().position - first.position).norm();
    EXPECT_GE(moved, (before.empty() ? 0.0 : before[0].depth) - kThin);
  }
  EXPECT_GT(several, 50);
}

TEST(Overlap, NoRoomInASlotThatIsTooNarrow) {
  Body left = body_of("left", Wall{}, {-0.09, 0.0}, -0.5 * std::numbers::pi);
  Body right = body_of("right", Wall{}, {0.09, 0.0}, 0.5 * std::numbers::pi);
  const Body disc = body_of("disc", Disc{0.1}, {0.0, 0.0});
  EXPECT_FALSE(moved_out(std::array{disc}, {{left, right}, {}}));
  left.position.x() = -0.1;
  right.position.x() = 0.11;
  const auto out = moved_out(std::array{body_of("disc", Disc{0.1}, {-0.05, 0.0})}, {{left, right}, {}});
  ASSERT_TRUE(out);
  EXPECT_NEAR(out->front().position.x(), 0.0, kThin);
}

TEST(Overlap, SeveralBodiesMoveAsOne) {
  const std::vector<Body> pair = {body_of("a", Disc{0.2}, {0.0, 0.1}), body_of("b", Disc{0.1}, {0.5, 0.0})};
  const Body ground = body_of("ground", Wall{}, {0.0, 0.0});
  const auto out = moved_out(pair, {{ground}, {}});
  ASSERT_TRUE(out);
  EXPECT_TRUE((*out)[0].position.isApprox(Vec2(0.0, 0.2), 1e-9));
  EXPECT_TRUE((*out)[1].position.isApprox(Vec2(0.5, 0.1), 1e-9));
}

TEST(Overlap, WhatCannotCollideMayOverlap) {
  Body a = body_of("a", Disc{0.2}, {0.0, 0.0});
  Body b = body_of("b", Box{0.2, 0.2}, {0.1, 0.0});
  EXPECT_EQ(overlaps_of(std::array{a}, {{b}, {}}).size(), 1U);
  Joint pin;
  pin.kind = JointKind::kPin;
  pin.body = "b";
  pin.to = "a";
  EXPECT_TRUE(overlaps_of(std::array{a}, {{b}, {pin}}).empty());
  a.fixed = b.fixed = true;
  EXPECT_TRUE(overlaps_of(std::array{a}, {{b}, {}}).empty());
  a.fixed = false;
  a.group = b.group = "g";
  EXPECT_TRUE(overlaps_of(std::array{a}, {{b}, {}}).empty());
}

TEST(Overlap, AGrownBodyShrinksToTouching) {
  Body other = body_of("other", Box{0.4, 0.4}, {1.0, 0.0});
  Body disc = body_of("disc", Disc{0.2}, {0.0, 0.0});
  Body large = disc;
  large.shape = Disc{0.95};
  const auto touching = grown_to_touch(std::array{disc}, std::array{large}, {{other}, {}});
  EXPECT_NEAR(std::get<Disc>(touching[0].shape).radius, 0.8, 1e-9);
  // The left side of a box stays where it was.
  const Body box = body_of("box", Box{0.4, 0.2}, {0.0, 0.0});
  Body wide = body_of("box", Box{1.2, 0.2}, {0.4, 0.0});
  const auto grown = grown_to_touch(std::array{box}, std::array{wide}, {{other}, {}});
  EXPECT_NEAR(std::get<Box>(grown[0].shape).width, 1.0, 1e-9);
  EXPECT_NEAR(grown[0].position.x(), 0.3, 1e-9);
  // Two that grow at once.
  const std::array pair = {body_of("a", Disc{0.1}, {0.0, 0.0}), body_of("b", Disc{0.1}, {0.3, 0.0})};
  std::array both = pair;
  both[0].shape = both[1].shape = Disc{0.2};
  const auto less = grown_to_touch(pair, both, {});
  EXPECT_NEAR(std::get<Disc>(less[0].shape).radius, 0.15, 1e-9);
}

TEST(Overlap, PutInTouchAlongTheLineOfCentres) {
  const Body disc = body_of("disc", Disc{0.1}, {0.3, 0.4});
  const Body touching = in_touch(disc, body_of("other", Disc{0.15}, {0.0, 0.0}));
  EXPECT_TRUE(touching.position.isApprox(0.25 * Vec2(0.6, 0.8), 1e-9));
  EXPECT_TRUE(
      in_touch(disc, body_of("box", Box{0.4, 0.2}, {0.3, 0.0})).position.isApprox(Vec2(0.3, 0.2), 1e-9));
  EXPECT_TRUE(in_touch(disc, body_of("ground", Wall{}, {5.0, 0.0})).position.isApprox(Vec2(0.3, 0.1), 1e-9));
}

TEST(Overlap, EachPairThatCanCollideIsFoundOnce) {
  const auto disc = [](const char* name, double x, bool fixed) {
    Body body;
    body.name = name;
    body.shape = Disc{0.5};
    body.position = Vec2(x, 0.0);
    body.fixed = fixed;
    return body;
  };
  Body ground = disc("ground", 7.0, true);
  ground.shape = Wall{};
  ground.position.y() = -0.45;
  const std::vector<Body> bodies{disc("c", 1.8, true),  disc("a", 0.0, false),   ground,
                                 disc("b", 0.9, false), disc("far", 5.0, false), disc("fixed", 2.0, true)};
  const std::vector<Overlap> found = overlaps_among(bodies, {});
  std::string names;
  for (const Overlap& overlap : found) names += overlap.body.name + "-" + overlap.other.name + " ";
  EXPECT_EQ(names, "c-b a-ground a-b ground-b ground-far ");
  EXPECT_NEAR(found[2].depth, 0.1, 1e-12);
  EXPECT_TRUE(found[2].at.isApprox(Vec2(0.45, 0.0), 1e-12));
  EXPECT_NEAR(found[1].depth, 0.05, 1e-12);
  // Rounding in a file is none.
  EXPECT_TRUE(overlaps_among(std::vector{disc("a", 0.0, false), disc("b", 0.99999, false)}, {}).empty());
}

}  // namespace
}  // namespace carom
