#include "physics/model/needs.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "physics/scene/facts.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

using test::disc;
using test::wall;

// Two discs and a wall, elastic and smooth, without any force.
Scene plain() {
  return test::scene_with({disc("a", {0, 0}, {1, 0}), disc("b", {3, 0}, {0, 0}), wall("w", {9, 0}, 1, 1)});
}

Spring spring(const std::string& body, const std::string& to = "") {
  Spring s;
  s.body = body;
  s.to = to;
  return s;
}

AppliedForce push(const std::string& body, const Vec2& force, double torque = 0.0) {
  AppliedForce f;
  f.body = body;
  f.force = force;
  f.torque = torque;
  return f;
}

bool holds(const std::vector<std::string>& list, const std::string& noun) {
  return std::find(list.begin(), list.end(), noun) != list.end();
}

bool needs(const Scene& scene, Part part) { return needs_of(scene).has(part); }

TEST(Needs, OfAPlainSceneAreNone) {
  EXPECT_EQ(needs_of(plain()), Needs());
  EXPECT_EQ(needs_of(Scene{}), Needs());
}

TEST(Needs, RotationBySpinTorqueOrFriction) {
  Scene s = plain();
  s.bodies[1].spin = -0.1;
  EXPECT_TRUE(needs(s, Part::kRotation));
  EXPECT_FALSE(needs(s, Part::kFriction));

  s = plain();
  s.forces.applied = {push("a", {0, 0}, 1.0)};
  EXPECT_TRUE(needs(s, Part::kRotation));
  s.forces.applied[0] = push("a", {1, 0});
  EXPECT_FALSE(needs(s, Part::kRotation));

  s = plain();
  s.materials[0].kinetic_friction = s.materials[0].static_friction = 0.1;
  EXPECT_TRUE(needs(s, Part::kRotation));
  EXPECT_TRUE(needs(s, Part::kFriction));
}

TEST(Needs, FrictionOnlyBetweenMaterialsThatCanMeet) {
  Scene s = plain();
  s.materials.push_back({"rough", 1.0, 0.0, 0.5, 0.5});
  // A rough wall and smooth discs: the geometric mean is zero.
  s.bodies[2].material = "rough";
  EXPECT_FALSE(needs(s, Part::kFriction));
  // Two rough walls never meet.
  s.bodies.push_back(wall("w2", {9, 0}, 1, 1));
  s.bodies[3].material = "rough";
  EXPECT_FALSE(needs(s, Part::kFriction));
  // The only rough body has nothing rough to meet; a second one has.
  s = plain();
  s.materials.push_back({"rough", 1.0, 0.0, 0.5, 0.5});
  s.bodies[0].material = "rough";
  EXPECT_FALSE(needs(s, Part::kFriction));
  s.bodies[1].material = "rough";
  EXPECT_TRUE(needs(s, Part::kFriction));
  // Tangential restitution alone does nothing; static friction holds what rests.
  s = plain();
  s.materials[0].tangential_restitution = 1.0;
  EXPECT_FALSE(needs(s, Part::kFriction));
  EXPECT_FALSE(needs(s, Part::kRotation));
  s.materials[0].static_friction = 0.5;
  EXPECT_TRUE(needs(s, Part::kFriction));
}

TEST(Needs, ForcesInFlight) {
  Scene s = plain();
  s.forces.gravity = {0, -9.81};
  for (const Part part : {Part::kDrag, Part::kSprings, Part::kAttraction, Part::kAppliedForces})
    EXPECT_FALSE(needs(s, part));

  for (double Forces::*drag : {&Forces::linear_drag, &Forces::quadratic_drag}) {
    s = plain();
    s.forces.*drag = 0.1;
    EXPECT_TRUE(needs(s, Part::kDrag));
    EXPECT_FALSE(needs(s, Part::kSprings) || needs(s, Part::kAppliedForces));
  }

  s = plain();
  s.forces.springs = {spring("a")};
  EXPECT_TRUE(needs(s, Part::kSprings));
  EXPECT_FALSE(needs(s, Part::kDrag) || needs(s, Part::kSwitching));

  s = plain();
  s.forces.applied = {push("a", {1, 0})};
  EXPECT_TRUE(needs(s, Part::kAppliedForces));
  EXPECT_FALSE(needs(s, Part::kDrives));

  s = plain();
  s.forces.attraction = Attraction{};
  EXPECT_TRUE(needs(s, Part::kAttraction));
  // One body has nobody to attract.
  s.bodies.erase(s.bodies.begin() + 1);
  EXPECT_FALSE(needs(s, Part::kAttraction));
}

TEST(Needs, Drives) {
  Scene s = plain();
  s.bodies[2].fixed = false;
  s.bodies[2].drive.emplace().velocity = {1, 0};
  EXPECT_TRUE(needs(s, Part::kDrives));
}

TEST(Needs, Switching) {
  Scene s = plain();
  s.forces.springs = {spring("a")};
  EXPECT_FALSE(needs(s, Part::kSwitching));
  s.forces.springs[0].acts = SpringActs::kPush;
  EXPECT_TRUE(needs(s, Part::kSwitching));
  s = plain();
  Joint string;
  string.kind = JointKind::kString;
  string.body = "a";
  s.joints = {string};
  EXPECT_TRUE(needs(s, Part::kSwitching) && needs(s, Part::kJoints));
  s.joints[0].kind = JointKind::kRod;
  EXPECT_FALSE(needs(s, Part::kSwitching));
}

TEST(Needs, RestingContacts) {
  Scene s = plain();
  s.materials[0].restitution = 0.9;
  EXPECT_TRUE(needs(s, Part::kRestingContacts));  // inelastic collapse

  s = plain();
  s.forces.gravity = {0, -9.81};
  EXPECT_TRUE(needs(s, Part::kRestingContacts));
  s.bodies.pop_back();  // nothing to be pressed against: all fall alike
  EXPECT_FALSE(needs(s, Part::kRestingContacts));
  s.forces.linear_drag = 0.1;  // they don't
  EXPECT_TRUE(needs(s, Part::kRestingContacts));

  s = plain();
  s.bodies[2].fixed = false;
  s.bodies[2].drive.emplace().velocity = {1, 0};
  EXPECT_FALSE(needs(s, Part::kRestingContacts));
  s.bodies[2].drive->amplitude = {1, 0};
  s.bodies[2].drive->angular_frequency = 1.0;
  EXPECT_TRUE(needs(s, Part::kRestingContacts));

  s = plain();
  s.bodies.resize(1);
  s.forces.gravity = {0, -9.81};
  s.materials[0].restitution = 0.5;
  EXPECT_FALSE(needs(s, Part::kRestingContacts));  // nobody to meet
}

TEST(Needs, InWords) {
  Scene s = plain();
  s.forces.linear_drag = 0.1;
  const NeedsText trimmed = text_of(needs_of(s), s, ContactsId::kImpulse);
  EXPECT_TRUE(holds(trimmed.modelled, "normal impulses"));
  EXPECT_TRUE(holds(trimmed.modelled, "drag"));
  EXPECT_TRUE(holds(trimmed.not_needed, "rotation"));
  EXPECT_TRUE(holds(trimmed.not_needed, "friction"));
  const NeedsText whole = text_of(all_needs(), s, ContactsId::kImpulse);
  EXPECT_TRUE(holds(whole.modelled, "rotation"));
  EXPECT_TRUE(holds(whole.modelled, "friction"));
  EXPECT_TRUE(holds(whole.modelled, "lasting contacts (as repeated impacts)"));
  EXPECT_TRUE(whole.not_needed.empty());
  for (const std::string& noun : trimmed.not_needed) EXPECT_FALSE(holds(trimmed.modelled, noun)) << noun;

  s.forces.linear_drag = 0.0;
  s.forces.springs = {spring("a")};
  s.forces.springs[0].damping = 1.0;
  const NeedsText sprung = text_of(needs_of(s), s, ContactsId::kImpulse);
  EXPECT_TRUE(holds(sprung.modelled, "springs"));
  EXPECT_TRUE(holds(sprung.not_needed, "drag"));
  // A body alone hits nothing.
  const Scene alone = test::scene_with({disc("a", {0, 0}, {0, 0})});
  EXPECT_FALSE(holds(text_of(needs_of(alone), alone, ContactsId::kImpulse).modelled, "normal impulses"));
  EXPECT_TRUE(holds(text_of(needs_of(plain()), plain(), ContactsId::kImpulse).not_needed, "lasting contacts"));
}

TEST(WhyNot, ExactFlightNamesEveryReason) {
  Scene s = plain();
  s.forces.gravity = {0, -9.81};
  s.forces.applied = {push("a", {1, 0}, 2.0)};
  for (int id = 0; id <= static_cast<int>(IntegratorId::kExactFlight); ++id)
    EXPECT_EQ(why_not(s, static_cast<IntegratorId>(id)), std::nullopt);

  s.forces.quadratic_drag = 0.1;
  EXPECT_NE(why_not(s, IntegratorId::kExactFlight)->find("not possible with drag; allowed: "),
            std::string::npos);
  EXPECT_EQ(why_not(s, IntegratorId::kRk4), std::nullopt);
  s.forces.springs = {spring("a")};
  s.forces.attraction = Attraction{};
  s.forces.applied[0].end = 1.0;
  EXPECT_NE(why_not(s, IntegratorId::kExactFlight)
                ->find("attraction and drag and springs and forces that start, rise or end; allowed: "),
            std::string::npos)
      << *why_not(s, IntegratorId::kExactFlight);
}

}  // namespace
}  // namespace carom
