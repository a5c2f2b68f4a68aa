#include "physics/scene/edit_rules.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

Scene pendulum() {
  Scene scene;
  for (const char* name : {"bob", "block"}) {
    Body body;
    body.name = name;
    body.material = "wood";
    scene.bodies.push_back(body);
  }
  Material wood;
  wood.name = "wood";
  scene.materials = {wood};
  MaterialPair pair;
  pair.a = pair.b = "wood";
  scene.pairs = {pair};
  Joint rod;
  rod.body = "bob";
  rod.to = "block";
  Joint weld;  // without an id, as a run makes it
  weld.kind = JointKind::kWeld;
  weld.body = "bob";
  AppliedForce push;
  push.body = "block";
  Spring spring;
  spring.body = "block";
  spring.to = "bob";
  scene.joints = {rod};
  scene.forces.springs = {spring};
  scene.forces.applied = {push};
  give_ids(scene);
  scene.joints.push_back(weld);
  return scene;
}

TEST(EditRules, TellWhatAnEditIsAbout) {
  const Scene scene = pendulum();
  Body bob = scene.bodies[0];
  EXPECT_TRUE(is_about_motion(scene, Add<Body>{bob}));
  EXPECT_TRUE(is_about_motion(scene, Add<Spring>{}));
  EXPECT_FALSE(is_about_motion(scene, Remove<Body>{bob.id}));
  EXPECT_FALSE(is_about_motion(scene, SetForces{}));
  EXPECT_FALSE(is_about_motion(scene, Replace<Body>{bob}));
  bob.mass = 2.0;
  bob.shape = Box{};
  EXPECT_FALSE(is_about_motion(scene, Replace<Body>{bob}));
  bob.spin = 1.0;
  EXPECT_TRUE(is_about_motion(scene, Replace<Body>{bob}));
  Joint rod = scene.joints[0];
  rod.length = 3.0;
  EXPECT_FALSE(is_about_motion(scene, Replace<Joint>{rod}));
  rod.point = {0.1, 0.0};
  EXPECT_TRUE(is_about_motion(scene, Replace<Joint>{rod}));
}

TEST(EditRules, NamesAreFollowed) {
  Scene scene = pendulum();
  Body bob = scene.bodies[0];
  bob.name = "ball";
  Material oak = scene.materials[0];
  oak.name = "oak";
  apply_edits(scene, with_followers(scene, {Replace<Body>{bob}, Replace<Material>{oak}}));
  EXPECT_EQ(scene.joints[0].body, "ball");
  EXPECT_EQ(scene.joints[1].body, "bob") << "the run's own weld is the run's business";
  EXPECT_EQ(scene.forces.springs[0].to, "ball");
  EXPECT_EQ(scene.forces.applied[0].body, "block");
  EXPECT_EQ(scene.bodies[1].material, "oak");
  EXPECT_EQ(scene.bodies[0].material, "oak") << "the body that was renamed before it";
  EXPECT_EQ(scene.pairs[0].a, "oak");
  EXPECT_EQ(scene.pairs[0].b, "oak");
}

TEST(EditRules, WhatHoldsABodyGoesWithIt) {
  Scene scene = pendulum();
  const Scene before = scene;
  const SceneEdits back = apply_edits(scene, with_followers(scene, {Remove<Body>{scene.bodies[0].id}}));
  EXPECT_EQ(scene.bodies.size(), 1U);
  ASSERT_EQ(scene.joints.size(), 1U);
  EXPECT_EQ(scene.joints[0].id.number, 0U);
  EXPECT_TRUE(scene.forces.springs.empty());
  EXPECT_EQ(scene.forces.applied.size(), 1U);
  const std::vector<Renamed> renamed = renamed_bodies(before, scene);
  ASSERT_EQ(renamed.size(), 1U);
  EXPECT_EQ(renamed[0].from, "bob");
  EXPECT_EQ(renamed[0].to, "");
  apply_edits(scene, back);
  EXPECT_EQ(scene.bodies[0].name, "bob");
  EXPECT_EQ(scene.joints[0].to, "block");
  EXPECT_EQ(scene.forces.springs.size(), 1U);
}

}  // namespace
}  // namespace carom
