#include "physics/scene/edit.h"

#include <gtest/gtest.h>
#include <stdexcept>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/scene/validate.h"
#include "tests/support/draws.h"
#include "tests/support/effort.h"
#include "tests/support/random_edit.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

using test::disc;

// All numbers and names of a scene, and the ids of its parts.
std::string text_of(const Scene& scene) {
  Preset preset;
  preset.title = "scene";
  preset.scene = scene;
  std::string text = write_preset(preset);
  const auto add = [&](const auto& list) {
    text += '/';
    for (const auto& part : list) text += " " + std::to_string(part.id.number);
  };
  add(scene.bodies);
  add(scene.materials);
  add(scene.pairs);
  add(scene.generators);
  add(scene.joints);
  add(scene.forces.springs);
  add(scene.forces.applied);
  return text;
}

Scene scene_of_all_parts(std::uint64_t seed) {
  Scene scene = test::random_scene(seed).preset.scene;
  scene.pairs.push_back({"default", "default", Material{"", 0.5}});
  scene.generators.push_back({.name = "grid", .columns = 2, .rows = 2});
  give_ids(scene);
  return scene;
}

// An edit's inverse gives the bytes of before, and the inverse of that those of after, however many are made
// and taken back in a row, valid scene or not.
TEST(SceneEdit, IsTakenBackAndPutBackByteForByte) {
  const int count = test::by_effort(200, 2000, 10'000);
  int made = 0;
  for (int k = 0; k < count; ++k) {
    test::Draws draws(static_cast<std::uint64_t>(k) + 1);
    Scene scene = scene_of_all_parts(static_cast<std::uint64_t>(k % 50) + 1);
    std::vector<std::string> texts = {text_of(scene)};
    std::vector<SceneEdits> back;
    while (texts.size() < 8) {
      SceneEdits edits;
      for (int n = draws.up_to(2); n >= 0; --n) edits.push_back(test::random_edit(scene, draws));
      try {
        back.push_back(apply_edits(scene, edits));
      } catch (const std::out_of_range&) {
        EXPECT_EQ(text_of(scene), texts.back()) << "a part that an earlier edit of them removed";
        continue;
      }
      texts.push_back(text_of(scene));
      ++made;
    }
    std::vector<SceneEdits> again;
    for (std::size_t i = back.size(); i-- > 0;) {
      again.push_back(apply_edits(scene, back[i]));
      ASSERT_EQ(text_of(scene), texts[i]) << k;
    }
    for (std::size_t i = 0; i < back.size(); ++i) {
      (void)apply_edits(scene, again[back.size() - 1 - i]);
      ASSERT_EQ(text_of(scene), texts[i + 1]) << k;
    }
  }
  EXPECT_EQ(made, 7 * count);
}

TEST(SceneEdit, GivesNoIdTwice) {
  Scene scene = test::scene_with({disc("a", {0, 0}, {0, 0}), disc("b", {1, 0}, {0, 0})});
  give_ids(scene);
  const Id<Body> second = scene.bodies[1].id;
  EXPECT_NE(scene.bodies[0].id, second);
  apply_edit(scene, Remove<Body>{second});
  apply_edit(scene, Add<Body>{disc("c", {2, 0}, {0, 0})});
  EXPECT_NE(scene.bodies[1].id, second);
  EXPECT_NE(scene.bodies[1].id.number, 0U);
  const std::uint32_t given = scene.ids_given;
  give_ids(scene);
  EXPECT_EQ(scene.ids_given, given) << "all have one";
}

TEST(SceneEdit, OfAPartThatIsNotThereChangesNothing) {
  Scene scene = test::scene_with({disc("a", {0, 0}, {0, 0})});
  give_ids(scene);
  const std::string before = text_of(scene);
  const SceneEdits edits = {SetForces{.gravity = {0, -1}}, Remove<Joint>{{99}}};
  EXPECT_THROW(apply_edits(scene, edits), std::out_of_range);
  EXPECT_EQ(text_of(scene), before);
  EXPECT_THROW(apply_edit(scene, Replace<Body>{disc("without an id", {0, 0}, {0, 0})}), std::out_of_range);
}

}  // namespace
}  // namespace carom
