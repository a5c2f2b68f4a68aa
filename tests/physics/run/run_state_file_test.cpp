#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <utility>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/preset/preset_json.h"
#include "physics/scene/facts.h"
#include "tests/support/effort.h"
#include "tests/support/resumed_run.h"
#include "tests/support/scenes.h"
#include "tests/support/source_folder.h"

// The section "state" of a preset file: what may be edited beside it, and what is refused.
namespace carom {
namespace {

using test::all_of;
using test::disc;
using test::parting;
using test::preset_with;
using test::saved_and_read;
using test::wall;

// A piston, a timed force, a spring, a string and a resting pair.
Preset busy(const Method& method) {
  Preset s =
      preset_with({wall("floor", {0, -0.5}, 20.0, 1.0), wall("piston", {-2, 0.2}, 0.2, 0.4),
                   disc("a", {0, 0.1}, {-1, 0}), disc("b", {1, 0.3}, {0, 0}), disc("c", {2, 0.6}, {0.3, 0})},
                  0.5, 0.3);
  s.scene.bodies[1].fixed = false;
  s.scene.bodies[1].drive = Drive{.velocity = {0.4, 0.0}, .amplitude = {0.05, 0.0}, .angular_frequency = 9.0};
  if (method.contacts == ContactsId::kLasting) s.scene.bodies[3].shape = Box{0.2, 0.2};
  s.scene.forces.gravity = {0.0, -9.81};
  s.scene.forces.springs = {{"band", "b", "c", Vec2::Zero(), 5.0, 0.1, 0.5, SpringActs::kPull}};
  s.scene.forces.applied = {{"a", {0.0, 5.0}, 0.1, 0.3, 0.4, 0.9}};
  Joint string;
  string.kind = JointKind::kString;
  string.body = "c";
  string.anchor = {2.0, 1.5};
  string.length = 1.0;
  s.scene.joints = {string};
  s.method = method;
  s.duration = 2.0;
  return s;
}

Preset ahead() {
  return busy({IntegratorId::kAdaptiveDormandPrince, ImpactsId::kLocated, ContactsId::kImpulse, 0.01, 1e-7});
}
Preset held() { return busy({IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kLasting, 0.01}); }

Preset saved_at(const Preset& s, double time) {
  Simulation run(setup_of(s));
  run.advance_to(time);
  return saved_preset(s, run);
}

TEST(RunStateFile, WhatIsReadIsWrittenAgain) {
  for (const Preset& s : {ahead(), held()}) {
    const Preset saved = saved_at(s, 0.6);
    const std::string text = write_preset(saved);
    EXPECT_EQ(write_preset(parse_preset(text, "again")), text);
    EXPECT_EQ(saved.duration, s.duration);
  }
  Preset clock = ahead();
  clock.saved = SavedRun{.time = 0.25};
  EXPECT_EQ(write_preset(parse_preset(write_preset(clock), "again")), write_preset(clock));
  EXPECT_EQ(write_preset(ahead()).find("\"state\""), std::string::npos);
}

// Files of earlier versions held the solver's state, too: one that such a version saved at 0.6 s goes on like
// the run from the start. Its contact forces were constant during a step, and bounces that take less than a
// step were not followed: where it has resting contacts, the run is the same when all of them have ended.
TEST(RunStateFile, EarlierFilesGoOn) {
  for (const auto& [name, slid] : {std::pair("located.json", 0.0), std::pair("resting.json", 5e-3)}) {
    const auto file = [](const char* of) { return test::source("tests/physics/run/earlier_saved_runs") / of; };
    const Preset earlier = read_preset(file(name));
    Preset start = read_preset(file("start.json"));
    start.method = earlier.method;
    Simulation whole(setup_of(start));
    whole.advance_to(0.6);
    Simulation resumed(setup_of(earlier));
    if (slid == 0.0) {
      EXPECT_EQ(test::difference(whole, resumed, 1e-9), "") << name;
    }
    for (Simulation* run : {&whole, &resumed}) run->advance_to(1.1);
    if (slid == 0.0) {
      EXPECT_EQ(test::unexplained(whole, resumed, earlier), "") << name;
    } else {
      EXPECT_EQ(test::difference_of_motions(whole, resumed, slid), "") << name;
    }
    // What is written has no more of it.
    const Json state = preset_json(earlier, false)["state"];
    for (const char* key : {"tracks", "ahead", "work", "positions", "books"})
      EXPECT_FALSE(state.contains(key)) << key;
  }
}

// All notices are restored, also those that no scene here has.
TEST(RunStateFile, NoticesAndSumsStay) {
  Preset saved = saved_at(held(), 0.6);
  Checkpoint checkpoint = *saved.saved->checkpoint;
  double next = 0.1;
  for (double Notices::*entry :
       {&Notices::resting_since, &Notices::collapsed_since, &Notices::impacts_capped_since,
        &Notices::log_cut_since, &Notices::search_cut_since, &Notices::gained_since, &Notices::gained,
        &Notices::energy_made_since, &Notices::cluster_unsolved_since, &Notices::restitution_lowered_since,
        &Notices::contacts_left_since, &Notices::contacts_left, &Notices::tolerance_missed_since,
        &Notices::joints_missed_since, &Notices::order_decided_since}) {
    checkpoint.sums.notices.*entry = next *= 1.1;
  }
  checkpoint.sums.notices.bodies[0] = {BodyIndex{0}, BodyIndex{1}};
  checkpoint.sums.notices.bodies[9] = {BodyIndex{1}, BodyIndex{2}};
  saved.saved->checkpoint = std::make_shared<Checkpoint>(checkpoint);
  const Simulation one(setup_of(saved));
  const Simulation two(setup_of(parse_preset(write_preset(saved), "saved")));
  EXPECT_EQ(parting(all_of(saved, one), all_of(saved, two)), "");
  const std::string text = two.notices().text();
  EXPECT_EQ(text.find("scene was changed"), std::string::npos) << text;
  EXPECT_EQ(std::count(text.begin(), text.end(), ';'), 13) << text;
  EXPECT_EQ(one.status(), two.status());
  const std::string& second = two.bodies()[1].name;
  EXPECT_NE(two.status().find(fmt::format("({} and {})", two.bodies()[0].name, second)), std::string::npos);
  EXPECT_NE(two.status().find(fmt::format("({} and {})", second, two.bodies()[2].name)), std::string::npos);
  checkpoint.sums.notices.bodies[9] = {BodyIndex{1}, BodyIndex{99}};
  saved.saved->checkpoint = std::make_shared<Checkpoint>(checkpoint);
  EXPECT_THROW(static_cast<void>(parse_preset(write_preset(saved), "saved")), SceneError);
}

TEST(RunStateFile, WhatIsNoPhysicsMayChange) {
  const Preset s = ahead();
  Preset saved = saved_at(s, 0.6);
  saved.title = "another";
  saved.about = saved.observe = "text";
  saved.duration = 7.0;
  saved.view = View{{1, 1}, 3.0};
  saved.extra = R"({"kept":1})";
  Simulation whole(setup_of(s));
  whole.advance_to(1.1);
  const Preset read = parse_preset(write_preset(saved), "saved");
  Simulation resumed(setup_of(read));
  resumed.advance_to(1.1);
  EXPECT_EQ(test::unexplained(whole, resumed, read), "");
}

// From bodies and clock alone; the status reports it.
TEST(RunStateFile, ChangedByHandItGoesOnFromBodiesAndClock) {
  const std::vector<std::function<void(Json&)>> changes = {
      [](Json& j) { j["bodies"][2]["position"][0] = 0.31; },
      [](Json& j) {
        j["bodies"][2]["velocity"] = {0.0, 1.0};
      },
      [](Json& j) { j["bodies"][3]["mass"] = 2.0; },
      [](Json& j) {
        j["bodies"].push_back(j["bodies"][0]);
        j["bodies"].back()["name"] = "more";
      },
      [](Json& j) { j["gravity"][1] = -1.6; },
      [](Json& j) { j["forces"].erase(0); },
      [](Json& j) { j["links"].clear(); },
      [](Json& j) { j["materials"][0]["restitution"] = 0.51; },
      [](Json& j) { j["state"]["time"] = 0.65; },
      [](Json& j) {
        j["state"]["taut"] = "nothing";
        j["bodies"][2]["position"][0] = 0.31;
      },
  };
  for (const Preset& s : {ahead(), held()}) {
    const Json saved = preset_json(saved_at(s, 0.6), false);
    for (std::size_t i = 0; i < changes.size(); ++i) {
      Json changed = saved;
      changes[i](changed);
      const Preset read = preset_of(changed);
      EXPECT_EQ(read.saved->checkpoint, nullptr) << i;
      Simulation run(setup_of(read));
      EXPECT_NE(run.notices().text().find("the scene was changed after the run was saved"), std::string::npos)
          << i;
      EXPECT_EQ(run.time(), changed["state"]["time"]) << i;
      EXPECT_EQ(run.steps(), 0) << i;
      changed["state"] = {{"time", changed["state"]["time"]}};
      Simulation clock(setup_of(preset_of(changed)));
      EXPECT_EQ(clock.notices().text(), "ok") << i;
      for (Simulation* each : {&run, &clock}) each->advance_to(1.0);
      EXPECT_TRUE(test::same_bytes(run.state(), clock.state())) << i;
      // The piston is where its drive puts it at that time.
      EXPECT_NEAR(run.state().q(0, 1), -2.0 + 0.4 + 0.05 * std::sin(9.0), 1e-12) << i;
      EXPECT_EQ(write_preset(parse_preset(write_preset(read), "again")), write_preset(read)) << i;
    }
  }
}

// The state does not belong to a scene changed after reading, either.
TEST(RunStateFile, ChangedInMemory) {
  Preset saved = saved_and_read(ahead(), Simulation(setup_of(ahead())));
  EXPECT_TRUE(state_belongs(saved.scene, saved.saved));
  EXPECT_EQ(Simulation(setup_of(saved)).notices().text(), "ok");
  saved.scene.bodies[2].velocity.x() += 1e-9;
  EXPECT_FALSE(state_belongs(saved.scene, saved.saved));
  EXPECT_NE(Simulation(setup_of(saved)).notices().text(), "ok");
}

TEST(RunStateFile, ARunThatHasBlownUpIsNotSaved) {
  Preset s = preset_with({disc("a", {0, 0}, {1, 0})});
  s.scene.forces.springs = {{"stiff", "a", "", Vec2::Zero(), 1e6, 0.0, 0.0, SpringActs::kBoth}};
  s.method = {IntegratorId::kExplicitEuler, ImpactsId::kStepEnd, ContactsId::kImpulse, 0.1};
  Simulation run(setup_of(s));
  run.advance_to(3.0);
  EXPECT_THROW((void)saved_preset(s, run), SceneError);
}

// The clock has one range, in a file and in memory.
TEST(RunStateFile, TheClockIsNotBeforeZero) {
  const Preset saved = saved_at(ahead(), 0.6);
  const auto fault_of = [](const auto& act) -> std::string {
    try {
      act();
    } catch (const SceneError& error) {
      return error.what();
    }
    return {};
  };
  for (const double time : {-0.5, -1e-12, 1e300}) {
    Preset clock = saved;
    clock.saved = SavedRun{.time = time};
    const std::string fault = fault_of([&] { validate(clock); });
    EXPECT_NE(fault.find("allowed: a number from 0 to 1000000000000 s"), std::string::npos) << fault;
    Json file = preset_json(saved, false);
    file["state"]["time"] = time;
    EXPECT_EQ(fault_of([&] { (void)preset_of(file); }), fault) << "with its state";
    file["state"] = {{"time", time}};
    EXPECT_EQ(fault_of([&] { (void)preset_of(file); }), fault) << "alone";
  }
}

// Each value of the section in turn becomes something invalid or doubtful: a value that is not restored must
// be refused in one line that says where.
void mutilate(const Preset& saved, const std::vector<Json>& values) {
  const Json whole = preset_json(saved, false);
  std::vector<Json::json_pointer> places;
  const std::function<void(const Json&, const Json::json_pointer&)> collect =
      [&](const Json& at, const Json::json_pointer& place) {
        places.push_back(place);
        if (at.is_object()) {
          for (const auto& item : at.items()) collect(item.value(), place / item.key());
        } else if (at.is_array()) {
          for (std::size_t i = 0; i < at.size(); ++i) collect(at[i], place / i);
        }
      };
  collect(whole["state"], Json::json_pointer("/state"));
  int refused = 0;
  const auto look = [&](const Json& changed, const std::string& what) {
    try {
      Simulation run(setup_of(preset_of(changed)));
      for (int k = 0; k < 3; ++k) run.step();
    } catch (const SceneError& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("/state"), std::string::npos) << what << ": " << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << what;
    }
  };
  for (const Json::json_pointer& place : places) {
    for (const Json& value : values) {
      Json changed = whole;
      changed[place] = value;
      look(changed, place.to_string() + " = " + value.dump());
    }
    Json shorter = whole;
    Json& parent = shorter[place.parent_pointer()];
    if (parent.is_object()) {
      parent.erase(place.back());
    } else {
      parent.erase(std::stoul(place.back()));
    }
    look(shorter, "without " + place.to_string());
    Json longer = whole;
    if (longer[place].is_object()) longer[place]["more"] = 1;
    if (longer[place].is_array() && !longer[place].empty()) longer[place].push_back(longer[place].back());
    look(longer, "more at " + place.to_string());
  }
  EXPECT_GT(refused, static_cast<int>(places.size()));
}

TEST(RunStateFile, HostileSectionsAreRefusedOrHarmless) {
  const std::vector<Json> all = {nullptr,
                                 -1,
                                 0,
                                 1,
                                 3,
                                 0.5,
                                 -7.5,
                                 1e300,
                                 -1e300,
                                 1e-300,
                                 2147483648,
                                 9223372036854775807,
                                 18446744073709551615U,
                                 "inf",
                                 true,
                                 Json::array(),
                                 Json::object(),
                                 Json::array({1, 2, 3})};
  const std::vector<Json> some = {nullptr, -1, 1e300, "inf", Json::array()};
  const std::vector<Json> values = test::by_effort(some, all, all);
  mutilate(saved_at(ahead(), 0.6), values);
  mutilate(saved_at(held(), 0.6), values);
}

}  // namespace
}  // namespace carom
