#include "app/lab/copied_bodies.h"

#include <gtest/gtest.h>
#include <utility>

#include "tests/support/scenes.h"

namespace carom {
namespace {

using test::disc;

TEST(CopiedBodies, StandWhereTheyAreSeenAndFree) {
  const std::vector<Body> one = {disc("A", {0.0, 0.0}, {0.0, 0.0}, 0.1)};
  const Extent all{Vec2(-1.0, -1.0), Vec2(1.0, 1.0)};
  EXPECT_TRUE(shift_beside(one, one, all).isApprox(Vec2(0.5, 0.0), 1e-12));
  std::vector<Body> others = one;
  others.push_back(disc("B", {0.5, 0.0}, {0.0, 0.0}, 0.1));
  EXPECT_TRUE(shift_beside(one, others, all).isApprox(Vec2(0.0, 0.5), 1e-12)) << "above";
  EXPECT_TRUE(shift_beside(one, others, {Vec2(-1.0, -0.1), Vec2(1.0, 0.1)}).isApprox(Vec2(-0.5, 0.0), 1e-12))
      << "to the left";
  EXPECT_TRUE(shift_beside(one, one, {Vec2(-0.1, -0.7), Vec2(0.1, 0.1)}).isApprox(Vec2(0.0, -0.5), 1e-12))
      << "below";
  EXPECT_TRUE(shift_beside(one, others, {Vec2(-0.1, -0.1), Vec2(0.8, 0.1)}).isApprox(Vec2(0.5, 0.0), 1e-12))
      << "in sight, not free";
  EXPECT_TRUE(shift_beside(one, one, {Vec2(5.0, 5.0), Vec2(6.0, 6.0)}).isApprox(Vec2(0.5, 0.0), 1e-12))
      << "nothing is seen";
}

// Places that were typed stay short numbers.
TEST(CopiedBodies, StandARoundFigureBeside) {
  const Extent all{Vec2(-9.0, -9.0), Vec2(9.0, 9.0)};
  for (const auto& [radius, shift] : {std::pair(0.062, 0.2), {0.137, 0.5}, {0.4, 1.0}, {0.9, 2.0}}) {
    const std::vector<Body> one = {disc("A", {0.0, 0.0}, {0.0, 0.0}, radius)};
    EXPECT_TRUE(shift_beside(one, one, all).isApprox(Vec2(shift, 0.0), 1e-12)) << radius;
  }
}

TEST(CopiedBodies, OfALetterHaveTheNextOne) {
  Scene scene =
      test::scene_with({disc("A", {0, 0}, {0, 0}), disc("C", {3, 0}, {0, 0}), disc("light", {6, 0}, {0, 0})});
  const Paste paste = paste_into(scene, copied_bodies(scene, {"A", "C", "light"}), Vec2(0.0, 2.0));
  EXPECT_EQ(paste.names, (std::vector<std::string>{"B", "D", "light-1"}));
}

// The law of two surfaces too, but none that would change those of the scene.
TEST(CopiedBodies, TakeTheirForcesAndSurfacesAlong) {
  Scene scene = test::scene_with({disc("A", {0, 0}, {0, 0}), disc("B", {3, 0}, {0, 0})});
  Material ice = scene.materials.front();
  ice.name = "ice";
  Material felt = ice;
  felt.name = "felt";
  scene.materials.push_back(ice);
  scene.materials.push_back(felt);
  scene.bodies[0].material = "ice";
  scene.bodies[1].material = "felt";
  MaterialPair pair{"ice", "felt", ice};
  pair.surface.restitution = 0.25;
  scene.pairs = {pair};
  AppliedForce force;
  force.body = "A";
  force.force = Vec2(1.0, 0.0);
  force.point = Vec2(0.0, 0.05);
  scene.forces.applied = {force};
  give_ids(scene);

  const auto pasted = [](Scene to, const Preset& from) {
    const Paste paste = paste_into(to, from, Vec2(0.0, 2.0));
    SceneEdits edits = paste.edits;
    apply_edits(to, edits);
    return to;
  };
  const Scene twice = pasted(scene, copied_bodies(scene, {"A", "B"}));
  ASSERT_EQ(twice.forces.applied.size(), 2U);
  EXPECT_EQ(twice.forces.applied[1].body, "C");
  EXPECT_EQ(twice.forces.applied[1].point, force.point);
  EXPECT_EQ(twice.pairs.size(), 1U);
  EXPECT_TRUE(copied_bodies(scene, {"B"}).scene.forces.applied.empty());
  EXPECT_TRUE(copied_bodies(scene, {"B"}).scene.pairs.empty());

  Scene other = test::scene_with({disc("Z", {0, 0}, {0, 0})});
  give_ids(other);
  const Scene fresh = pasted(other, copied_bodies(scene, {"A", "B"}));
  ASSERT_EQ(fresh.pairs.size(), 1U);
  EXPECT_EQ(fresh.pairs[0].surface.restitution, 0.25);
  ASSERT_EQ(fresh.forces.applied.size(), 1U);
  EXPECT_EQ(fresh.forces.applied[0].body, "A");
}

}  // namespace
}  // namespace carom
