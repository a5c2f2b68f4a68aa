#include "physics/preset/start_fingerprint.h"

#include <functional>
#include <gtest/gtest.h>
#include <set>
#include <utility>

#include "physics/scene/fingerprint.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

RunEdit late(const std::string& name, double time) {
  return {time, 0, SceneEdits{Add<Body>{test::disc(name, {0.0, 0.5}, {1.0, 0.0})}}};
}

Preset with_late_discs() {
  Preset preset = test::preset_with({test::disc("first", {0.0, 0.0}, {1.0, 0.0})}, 1.0, 0.0);
  preset.edits = {late("a", 0.4), late("b", 0.4)};
  return preset;
}

Body& body_of(RunEdit& edit) { return std::get<Add<Body>>(std::get<SceneEdits>(edit.what).front()).part; }

TEST(StartFingerprint, IsThatOfASceneIntoWhichNothingComes) {
  Preset preset = with_late_discs();
  preset.edits.clear();
  EXPECT_EQ(fingerprint_of_start(preset), fingerprint(preset.scene, 0.0));
  preset.saved = SavedRun{.time = 1.5};
  EXPECT_EQ(fingerprint_of_start(preset), fingerprint(preset.scene, 1.5));
}

// Files of the lab's unsaved work have it.
TEST(StartFingerprint, StaysTheSame) {
  EXPECT_EQ(fingerprint_of_start(with_late_discs()), 0x21da14ed94f745beULL);
}

TEST(StartFingerprint, TellsApartWhatRunsStartFrom) {
  const std::vector<std::function<void(Preset&)>> changes = {
      [](Preset& p) { p.scene.forces.linear_drag = 0.1; },
      [](Preset& p) { p.saved = SavedRun{.time = 0.1}; },
      [](Preset& p) { p.edits[0].time = 0.8; },
      [](Preset& p) { p.edits[1].time = 0.8; },
      [](Preset& p) { body_of(p.edits[0]).mass = 5.0; },
      [](Preset& p) { body_of(p.edits[1]).velocity.y() = 0.1; },
      [](Preset& p) { std::swap(p.edits[0], p.edits[1]); },
      [](Preset& p) { p.edits.pop_back(); },
      [](Preset& p) { p.edits.clear(); },
      [](Preset& p) {
        for (RunEdit& edit : p.edits) p.scene.bodies.push_back(body_of(edit));
        p.edits.clear();
      },
  };
  std::set<std::uint64_t> all = {fingerprint_of_start(with_late_discs())};
  for (const auto& change : changes) {
    Preset preset = with_late_discs();
    change(preset);
    all.insert(fingerprint_of_start(preset));
  }
  EXPECT_EQ(all.size(), changes.size() + 1);
}

TEST(StartFingerprint, LeavesOutWhatHasNoPartInTheStart) {
  Preset other = with_late_discs();
  other.title = "another";
  other.about += ", told in other words";
  other.duration = 9.0;
  other.method.step *= 0.5;
  other.edits[0].id = 7;
  body_of(other.edits[0]).id.number = 8;
  other.plots = {Plot{.id = "energy", .title = {}, .y = {}, .x = {}}};
  EXPECT_EQ(fingerprint_of_start(other), fingerprint_of_start(with_late_discs()));
}

}  // namespace
}  // namespace carom
