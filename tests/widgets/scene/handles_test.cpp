#include "widgets/scene/handles.h"

#include <QLineF>
#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <numbers>

#include "physics/math/vectors.h"

namespace carom {
namespace {

// 100 px/m; the world's origin stands at (320, 200).
class HandlesTest : public testing::Test {
 protected:
  HandlesTest() {
    disc_.shape = Disc{0.5};
    disc_.position = Vec2(1.0, 0.0);
  }
  [[nodiscard]] std::vector<Handle> handles(const std::vector<Body>& bodies) const {
    return handles_of(bodies, camera_, 0.5);
  }
  [[nodiscard]] static Handle of(const std::vector<Handle>& handles, HandleKind kind) {
    return *std::find_if(handles.begin(), handles.end(), [&](const Handle& h) { return h.kind == kind; });
  }
  [[nodiscard]] static auto number(const std::vector<Handle>& handles, HandleKind kind) {
    return std::count_if(handles.begin(), handles.end(), [&](const Handle& h) { return h.kind == kind; });
  }
  Camera camera_;
  Body disc_;
};

TEST_F(HandlesTest, TheTipOfAVelocityIsThatOfItsArrow) {
  disc_.velocity = Vec2(0.0, 2.0);
  const Handle tip = of(handles({disc_}), HandleKind::kVelocity);
  EXPECT_EQ(tip.at, QPointF(420.0, 100.0));
  EXPECT_FALSE(tip.foot);
}

TEST_F(HandlesTest, AtRestTheGripStandsOutsideTheRimAtTheRight) {
  const Handle grip = of(handles({disc_}), HandleKind::kVelocity);
  EXPECT_EQ(grip.at, QPointF(420.0 + 50.0 + 30.0, 200.0));
  ASSERT_TRUE(grip.foot);
  EXPECT_EQ(*grip.foot, QPointF(470.0, 200.0));
}

TEST_F(HandlesTest, AllStandFarEnoughFromTheCentreOfASmallBody) {
  disc_.shape = Disc{0.01};
  Body box = disc_;
  box.shape = Box{0.02, 0.01};
  for (const Body& body : {disc_, box}) {
    for (const Handle& handle : handles({body})) {
      EXPECT_GE(QLineF(handle.at, QPointF(420.0, 200.0)).length(), kLeastHandleDistance - 1e-9);
    }
  }
}

TEST_F(HandlesTest, TheKnobLeavesTheArrowItsPlace) {
  EXPECT_LT(of(handles({disc_}), HandleKind::kTurn).at.y(), 150.0);
  disc_.velocity = Vec2(0.0, 2.0);
  EXPECT_GT(of(handles({disc_}), HandleKind::kTurn).at.y(), 250.0);
}

TEST_F(HandlesTest, TheKnobGoesAlongWithATurn) {
  Body box = disc_;
  box.shape = Box{1.0, 0.4};
  const QPointF before = of(handles_of(std::array{box}, camera_, std::nullopt), HandleKind::kTurn).at;
  box.angle = std::numbers::pi / 2.0;
  const Handle knob = of(handles_of(std::array{box}, camera_, std::nullopt, box.angle), HandleKind::kTurn);
  const QPointF centre(420.0, 200.0);
  const double reach = centre.y() - before.y();
  EXPECT_NEAR(knob.at.x(), centre.x() - reach, 1e-9) << "counter-clockwise from the top";
  EXPECT_NEAR(knob.at.y(), centre.y(), 1e-9);
  EXPECT_NEAR(knob.foot->x(), centre.x() - 20.0, 1e-9) << "from the side that was on top";
}

TEST_F(HandlesTest, SeveralBodiesHaveVelocitiesOnly) {
  Body fixed = disc_;
  fixed.fixed = true;
  const std::vector<Handle> of_three = handles({disc_, fixed, disc_});
  EXPECT_EQ(of_three.size(), 2U);
  EXPECT_EQ(of_three[1].body, 2U);
  EXPECT_EQ(number(handles({fixed}), HandleKind::kVelocity), 0);
  EXPECT_EQ(number(handles({fixed}), HandleKind::kRadius), 4);
}

TEST_F(HandlesTest, TheGripOfASpinGoesAlongTheRim) {
  const Handle still = of(handles({disc_}), HandleKind::kSpin);
  ASSERT_TRUE(still.arc);
  EXPECT_NEAR(QLineF(still.at, QPointF(420.0, 200.0)).length(), 58.0, 1e-9);
  EXPECT_EQ(still.arc->sweep, 0.0);
  EXPECT_NEAR(still.at.x(), 420.0 - 29.0, 1e-9);
  EXPECT_GT(still.at.y(), 200.0);
  disc_.spin = 2.0;
  const Handle spun = of(handles({disc_}), HandleKind::kSpin);
  EXPECT_EQ(spun.arc->sweep, 30.0);
  EXPECT_NEAR(spun.at.x(), 420.0, 1e-9);
  EXPECT_NEAR(spun.at.y(), 258.0, 1e-9);
  disc_.spin = -100.0;
  EXPECT_EQ(of(handles({disc_}), HandleKind::kSpin).arc->sweep, -330.0);
  EXPECT_EQ(number(handles({disc_, disc_}), HandleKind::kSpin), 0);
}

TEST_F(HandlesTest, TheNearestOneWithinReachIsTaken) {
  const std::vector<Handle> all = handles({disc_});
  const QPointF grip = of(all, HandleKind::kVelocity).at;
  ASSERT_TRUE(handle_at(all, grip + QPointF(6.0, 6.0)));
  EXPECT_EQ(handle_at(all, grip + QPointF(6.0, 6.0))->kind, HandleKind::kVelocity);
  EXPECT_FALSE(handle_at(all, grip + QPointF(8.0, 8.0)));
}

TEST_F(HandlesTest, ABoxHasThemAtItsSidesAndCorners) {
  disc_.shape = Box{1.0, 0.6};
  const std::vector<Handle> all = handles({disc_});
  EXPECT_EQ(of(all, HandleKind::kRight).at, QPointF(478.0, 200.0));
  EXPECT_EQ(of(all, HandleKind::kTopRight).at, QPointF(478.0, 162.0));
  EXPECT_EQ(of(all, HandleKind::kBottomLeft).at, QPointF(362.0, 238.0));
  EXPECT_EQ(all.size(), 3U + 8U);  // with velocity, spin and knob
  for (const Handle& a : all) {
    for (const Handle& b : all) EXPECT_TRUE(&a == &b || QLineF(a.at, b.at).length() > kHandleReach);
  }
}

TEST_F(HandlesTest, TheSpinOfALongBoxStandsAtItsOutline) {
  disc_.shape = Box{3.0, 0.4};
  disc_.angle = 0.3;
  for (const double spin : {0.0, 2.0, -5.0, 11.0, 20.0}) {
    disc_.spin = spin;
    const std::vector<Handle> all = handles({disc_});
    const Handle grip = of(all, HandleKind::kSpin);
    const Vec2 at = turned_by(-disc_.angle, camera_.to_world(grip.at) - disc_.position);
    const double away = signed_distance(disc_.shape, at) * camera_.scale;
    EXPECT_GT(away, 20.0);
    EXPECT_LT(away, 24.0);
    ASSERT_TRUE(grip.arc);
    EXPECT_EQ(grip.arc->way.last(), grip.at);
    for (const Handle& each : all) {
      if (each.kind < HandleKind::kRadius) continue;
      EXPECT_GT(QLineF(each.at, grip.at).length(), 9.0) << "spin " << spin;
    }
  }
}

TEST_F(HandlesTest, AThinWallHasThemAtItsEnds) {
  Body wall = disc_;
  wall.shape = Wall{1.0};
  wall.fixed = true;
  wall.angle = std::numbers::pi / 2;
  const std::vector<Handle> all = handles({wall});
  EXPECT_EQ(all.size(), 3U) << "and the knob";
  EXPECT_NEAR(QLineF(of(all, HandleKind::kRight).at, QPointF(420.0, 142.0)).length(), 0.0, 1e-9);
  EXPECT_NEAR(QLineF(of(all, HandleKind::kLeft).at, QPointF(420.0, 258.0)).length(), 0.0, 1e-9);
  wall.shape = Wall{};
  EXPECT_EQ(handles({wall}).size(), 1U) << "a half-plane has the knob alone";
}

TEST_F(HandlesTest, APolygonHasThemAtItsCorners) {
  disc_.shape = Polygon{{Vec2(0.0, 0.0), Vec2(0.9, 0.0), Vec2(0.0, 0.9)}};  // about (0.3, 0.3)
  const std::vector<Handle> all = handles({disc_});
  ASSERT_EQ(number(all, HandleKind::kCorner), 3);
  const Handle first = of(all, HandleKind::kCorner);
  EXPECT_EQ(first.corner, 0U);
  EXPECT_NEAR(QLineF(first.at, QPointF(390.0, 230.0)).length(), 8.0, 1e-9);  // outside of it
  EXPECT_LT(first.at.x(), 390.0);
  EXPECT_EQ(all.back().corner, 2U);
}

}  // namespace
}  // namespace carom
