#include "widgets/scene/allowed_place.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

// A bob on a rod of 1 m that hangs from the origin, and two discs that a rod of 1 m joins.
class AllowedPlaceTest : public testing::Test {
 protected:
  AllowedPlaceTest() {
    for (const Vec2& place : {Vec2(0.0, -1.0), Vec2(3.0, 0.0), Vec2(4.0, 0.0)}) {
      Body body;
      body.name = scene_.bodies.empty() ? "bob" : scene_.bodies.size() == 1 ? "A" : "B";
      body.mass = 1.0;
      body.shape = Disc{0.1};
      body.position = place;
      scene_.bodies.push_back(body);
    }
    Joint rod;
    rod.body = "bob";
    Joint pair;
    pair.body = "A";
    pair.to = "B";
    for (Joint* joint : {&rod, &pair}) joint->length = 1.0;
    scene_.joints = {rod, pair};
    give_ids(scene_);
  }
  [[nodiscard]] SceneEdit at(std::size_t body, const Vec2& place) const {
    Body moved = scene_.bodies[body];
    moved.position = place;
    return Replace<Body>{moved};
  }
  static Vec2 place_of(const SceneEdit& edit) { return std::get<Replace<Body>>(edit).part.position; }
  Scene scene_;
};

TEST_F(AllowedPlaceTest, ABobSlidesOnItsCircle) {
  const AllowedPlace made = allowed_place(scene_, {at(0, Vec2(0.5, -1.0))});
  ASSERT_EQ(made.edits.size(), 1U);
  EXPECT_TRUE(made.refusal.isEmpty());
  const Vec2 place = place_of(made.edits[0]);
  EXPECT_NEAR(place.norm(), 1.0, 1e-12);
  EXPECT_GT(place.x(), 0.4);
  EXPECT_TRUE(made.sentence.startsWith("Rod 1 holds bob: x 0.4")) << made.sentence.toStdString();
}

TEST_F(AllowedPlaceTest, AlongTheRodNothingIsAllowed) {
  const AllowedPlace made = allowed_place(scene_, {at(0, Vec2(0.0, -1.5))});
  EXPECT_EQ(made.refusal.toStdString(), "Rod 1 would be 1.500 m.");
}

TEST_F(AllowedPlaceTest, WhatIsAllowedStaysAsTyped) {
  EXPECT_EQ(place_of(allowed_place(scene_, {at(0, Vec2(1.0, 0.0))}).edits[0]), Vec2(1.0, 0.0));
  const SceneEdits both = {at(1, Vec2(3.1, 0.0)), at(2, Vec2(4.1, 0.0))};
  const AllowedPlace made = allowed_place(scene_, both);
  EXPECT_TRUE(made.refusal.isEmpty()) << made.refusal.toStdString();
  EXPECT_TRUE(made.sentence.isEmpty());
  ASSERT_EQ(made.edits.size(), 2U);
  EXPECT_EQ(place_of(made.edits[1]), Vec2(4.1, 0.0));
}

TEST_F(AllowedPlaceTest, OneOfAPairSlidesAndBothAtOnePlaceAreRefused) {
  const AllowedPlace one = allowed_place(scene_, {at(1, Vec2(3.1, 0.3))});
  EXPECT_NEAR((place_of(one.edits[0]) - scene_.bodies[2].position).norm(), 1.0, 1e-12);
  const AllowedPlace both = allowed_place(scene_, {at(1, Vec2(3.5, 0.0)), at(2, Vec2(3.7, 0.0))});
  EXPECT_EQ(both.refusal.toStdString(), "Rod 2 would be 20.0 cm.");
}

TEST_F(AllowedPlaceTest, WhatIsWeldedComesAlong) {
  Joint& weld = scene_.joints[1];
  weld.kind = JointKind::kWeld;
  weld.length.reset();
  weld.point = Vec2(1.0, 0.0);
  const AllowedPlace made = allowed_place(scene_, {at(1, Vec2(3.0, 1.0))});
  ASSERT_EQ(made.edits.size(), 2U);
  EXPECT_EQ(place_of(made.edits[1]), Vec2(4.0, 1.0));
}

}  // namespace
}  // namespace carom
