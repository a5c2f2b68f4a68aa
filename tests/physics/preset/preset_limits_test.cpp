#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>

#include "physics/preset/preset.h"
#include "physics/preset/preset_file.h"
#include "physics/run/checkpoint.h"
#include "physics/run/simulation.h"
#include "physics/scene/limits.h"
#include "tests/support/scenes.h"

namespace carom {
namespace {

// A preset with a list of `count` elements, each made of its index.
template <class Element>
std::string with_list(const std::string& key, std::size_t count, const Element& element,
                      const std::string& more = "") {
  std::string text =
      fmt::format(R"({{"format": "carom-preset", "version": 1, "title": "t", {}"{}": [)", more, key);
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ',';
    text += element(i);
  }
  text += "]}";
  return text;
}

const char* const kTwoDiscs =
    R"("bodies": [{"name": "a", "shape": {"type": "disc", "radius": 1}, "position": [0, 0]},
       {"name": "b", "shape": {"type": "disc", "radius": 1}, "position": [9, 0]}], )";

std::string body(std::size_t i) {
  return fmt::format(R"({{"name":"b{}","shape":{{"type":"disc","radius":0.1}},"position":[{},0]}})", i, i);
}
std::string material(std::size_t i) { return fmt::format(R"({{"name":"m{}"}})", i); }
std::string spring(std::size_t) { return R"({"type":"spring","body":"a","anchor":[0,1],"stiffness":1})"; }
// 400 between two bodies, 400 between the next two, and so on.
std::string joint(std::size_t i) {
  return fmt::format(R"({{"type":"string","body":"b{}","to":"b{}","length":20}})", i / 400 * 2,
                     i / 400 * 2 + 1);
}
std::string plot(std::size_t) { return R"("energy")"; }
std::string expectation(std::size_t) {
  return R"({"observable":"time","reduction":"final","value":0,"tolerance":1})";
}

// The key "bodies" with so many of them.
std::string bodies(std::size_t count) {
  std::string list;
  for (std::size_t i = 0; i < count; ++i) list += fmt::format("{}{}", i == 0 ? "" : ",", body(i));
  return fmt::format(R"("bodies": [{}], )", list);
}

std::string refusal(const std::string& text) {
  try {
    (void)parse_preset(text, "p");
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

TEST(PresetLimits, ListsAreRefusedBeyondThem) {
  const auto expect_limit = [](const std::string& good, const std::string& bad, const std::string& key,
                               std::size_t most) {
    EXPECT_EQ(refusal(good), "") << key;
    const std::string line = refusal(bad);
    EXPECT_TRUE(line.starts_with(fmt::format("p: /{}", key))) << line;
    EXPECT_NE(line.find(fmt::format("up to {}", most)), std::string::npos) << line;
    EXPECT_LT(line.size(), 200U);
  };
  expect_limit(with_list("bodies", kMostBodies, body), with_list("bodies", kMostBodies + 1, body), "bodies",
               kMostBodies);
  expect_limit(with_list("materials", kMostMaterials, material),
               with_list("materials", kMostMaterials + 1, material), "materials", kMostMaterials);
  expect_limit(with_list("forces", kMostForces, spring, kTwoDiscs),
               with_list("forces", kMostForces + 1, spring, kTwoDiscs), "forces", kMostForces);
  expect_limit(with_list("links", kMostJoints, joint, bodies(502)),
               with_list("links", kMostJoints + 1, joint, bodies(502)), "links", kMostJoints);
  expect_limit(with_list("plots", kMostPlots, plot), with_list("plots", kMostPlots + 1, plot), "plots",
               kMostPlots);
  expect_limit(with_list("expect", kMostExpectations, expectation),
               with_list("expect", kMostExpectations + 1, expectation), "expect", kMostExpectations);
}

TEST(PresetLimits, BodiesUnderAttractionAreCounted) {
  const auto attracted = [](int columns) {
    return fmt::format(
        R"({{"format":"carom-preset","version":1,"title":"t","bodies":[],)"
        R"("forces":[{{"type":"attraction","constant":1}}],)"
        R"("generators":[{{"type":"grid","name":"d","columns":{},"rows":20,"origin":[0,0],"spacing":[1,1],"radius":[0.1,0.1]}}]}})",
        columns);
  };
  EXPECT_EQ(refusal(attracted(100)), "");
  EXPECT_EQ(refusal(attracted(101)),
            "p: /forces/0: attraction among 2020 bodies is not allowed; allowed: among up to 2000");
}

TEST(PresetLimits, JointsThatHoldOnToOneAnotherAreCounted) {
  // A chain of 501 joints, the last one in its middle: whole, and where one of its bodies is fixed.
  const auto chain = [&](const std::string& all) {
    return with_list(
        "links", 501,
        [](std::size_t i) {
          const std::size_t left = (i + 251) % 501;
          return fmt::format(R"({{"type":"string","body":"b{}","to":"b{}","length":2}})",
                             left < 250 ? left : left + 1, left < 250 ? left + 1 : left);
        },
        all);
  };
  const std::string free = bodies(502);
  EXPECT_NE(refusal(chain(free)).find("/links/500: link 501 of bodies"), std::string::npos)
      << refusal(chain(free));
  std::string held = free;
  held.insert(held.find("\"name\":\"b250\""), "\"fixed\":true,");
  EXPECT_EQ(refusal(chain(held)), "");
  // Of one body.
  const auto hung = [](std::size_t i) {
    return fmt::format(R"({{"type":"string","body":"a","anchor":[{},0],"length":2000}})", i);
  };
  EXPECT_NE(refusal(with_list("links", 501, hung, kTwoDiscs)), "");
}

// The names that a generator makes have room, so that a run of them can be saved.
TEST(PresetLimits, StemsLeaveRoomForNumbers) {
  const auto generated = [](std::size_t length) {
    return with_list("generators", 1, [length](std::size_t) {
      return fmt::format(
          R"({{"type":"grid","name":"{}","columns":500,"rows":200,"origin":[0,0],"spacing":[1,1],)"
          R"("radius":[0.1,0.1]}})",
          std::string(length, 'x'));
    });
  };
  EXPECT_NE(refusal(generated(kLongestStem + 1)).find("/generators/0/name: "), std::string::npos);
  const Preset preset = parse_preset(generated(kLongestStem), "p");
  EXPECT_EQ(all_bodies(preset.scene).back().name.size(), kLongestName);
}

// What the reader would refuse is not written, and the old file stays.
TEST(PresetLimits, HoldForWhatIsSaved) {
  const auto file = std::filesystem::path(testing::TempDir()) / "held-limits.json";
  Preset preset = parse_preset(with_list("bodies", 1, body), "p");
  save_preset(preset, file);
  Plot plot;
  plot.id = "energy";
  plot.notes.assign(kMostNotes + 1, {0.0, 0.0, "a note"});
  preset.plots = {plot};
  try {
    save_preset(preset, file);
    FAIL() << "saved";
  } catch (const SceneError& error) {
    EXPECT_NE(std::string(error.what()).find("/plots/0/notes: "), std::string::npos) << error.what();
  }
  EXPECT_TRUE(read_preset(file).plots.empty());
  std::filesystem::remove(file);
}

// Two chains whose ends meet and stick: the run may be saved and go on, but none may begin so.
TEST(PresetLimits, WhatHasStuckTogetherInARunMayBeMore) {
  Preset s;
  s.title = "t";
  s.scene.materials = {{.name = "glue", .sticks = true}};
  for (int i = 0; i <= 502; ++i) {
    if (i == 251) continue;  // the gap
    Body b = test::disc(fmt::format("b{}", i), {i < 251 ? i : i - 1.79, 0.0}, {i < 251 ? 1.0 : -1.0, 0.0});
    b.material = "glue";
    s.scene.bodies.push_back(b);
    if (i == 0 || i == 252) continue;
    Joint l;
    l.kind = JointKind::kRod;
    l.body = fmt::format("b{}", i - 1);
    l.to = b.name;
    s.scene.joints.push_back(l);
  }
  s.method = {IntegratorId::kRk4, ImpactsId::kLocated, ContactsId::kImpulse, 0.01};
  Simulation run(setup_of(s));
  run.step();
  ASSERT_EQ(run.joints().size(), 501U) << run.status();
  Preset saved = saved_preset(s, run);
  EXPECT_EQ(refusal(write_preset(saved)), "");
  saved.saved.reset();
  EXPECT_NE(refusal(write_preset(saved)).find("linked with one another"), std::string::npos);
}

TEST(PresetLimits, CurvesOfAllPlotsAreCounted) {
  const auto plots = [](std::size_t count, std::size_t curves) {
    return with_list("plots", count, [&](std::size_t) {
      std::string y = R"({"observable":"time"})";
      for (std::size_t i = 1; i < curves; ++i) y += R"(,{"observable":"time"})";
      return fmt::format(R"({{"y":[{}]}})", y);
    });
  };
  EXPECT_EQ(refusal(plots(2, kMostPlotCurves)), "");
  EXPECT_NE(refusal(plots(1, kMostPlotCurves + 1)).find("p: /plots/0/y: an array of 101 elements"),
            std::string::npos);
  EXPECT_NE(refusal(plots(3, kMostPlotCurves)).find("p: /plots/2/y: 300 curves in all"), std::string::npos);
}

TEST(PresetLimits, NamesAndTexts) {
  const auto title = [](std::size_t length) {
    return fmt::format(R"({{"format": "carom-preset", "version": 1, "title": "{}"}})",
                       std::string(length, 'x'));
  };
  EXPECT_EQ(refusal(title(kLongestTitle)), "");
  EXPECT_NE(refusal(title(kLongestTitle + 1)).find("p: /title: "), std::string::npos);
  EXPECT_LT(refusal(title(1'000'000)).size(), 300U);
}

// Keys that nobody asked for, looked up in a time that grows as their number.
TEST(PresetLimits, ManyUnknownKeys) {
  const auto keys = [](std::size_t count) {
    std::string text = R"({"format": "carom-preset", "version": 1, "title": "t")";
    for (std::size_t i = 0; i < count; ++i) text += fmt::format(", \"k{}\": 0", i);
    text += '}';
    return text;
  };
  EXPECT_NE(refusal(keys(90'000)).find("/k0: unknown key"), std::string::npos);
  EXPECT_EQ(refusal(keys(1'000'000)), "p: /: more than 1000000 keys; allowed: up to 1000000");
  const std::string extra = R"({"format": "carom-preset", "version": 1, "title": "t", "extra": {"a": [)";
  std::string zeros = "0";
  for (int i = 0; i < 1'000'000; ++i) zeros += ",0";
  EXPECT_EQ(refusal(extra + zeros + "]}}"), "p: /extra/a: more than 1000000 elements; allowed: up to 1000000");
}

// Bodies that refer to one of many materials, pairs that name them, settings that name many places.
TEST(PresetLimits, ReferencesAreFoundAmongMany) {
  std::string materials = R"("materials": [{"name":"m"})";
  for (std::size_t i = 0; i + 1 < kMostMaterials; ++i) {
    materials += ',';
    materials += material(i);
  }
  materials += "], ";
  const auto pair = [](std::size_t i) {
    return fmt::format(R"({{"materials":["m{}","m{}"]}})", i / 400, 500 + i % 400);
  };
  EXPECT_EQ(refusal(with_list("material_pairs", 100'000, pair, materials)), "");
  const auto of_material = [](std::size_t i) {
    return fmt::format(
        R"({{"name":"b{}","shape":{{"type":"disc","radius":0.1}},"position":[{},0],"material":"m{}"}})", i, i,
        i % 999);
  };
  EXPECT_EQ(refusal(with_list("bodies", 50'000, of_material, materials)), "");
}

TEST(PresetText, FaultsHaveTheirPlace) {
  const std::string head = "{\"format\": \"carom-preset\", \"version\": 1,\n \"title\": \"t\",\n ";
  EXPECT_EQ(refusal(head + "\"duration\": 1e400}"),
            "p: line 3, column 14, /duration: the number 1e400 is too large; allowed: up to 1000000000000 in "
            "SI units");
  EXPECT_EQ(refusal(head + "\"gravity\": [0, -1e400]}"),
            "p: line 3, column 17, /gravity/1: the number -1e400 is too large; allowed: up to 1000000000000 in "
            "SI units");
  EXPECT_EQ(refusal(head + "\"duration\": 1}" + std::string(1, '\0') + "{"),
            "p: line 3, column 16: a NUL character is not allowed; allowed: text in UTF-8");
  EXPECT_EQ(refusal(head + "\"about\": \"\xc0\xaf\"}"),
            "p: line 3, column 12: the byte \\xc0 is not allowed; allowed: text in UTF-8");
  EXPECT_TRUE(refusal(head + "\"duration\": 1} x").starts_with("p: line 3, column 17: this is not JSON"))
      << refusal(head + "\"duration\": 1} x");
  EXPECT_TRUE(refusal(head + "\"a/b~\x1b\": 1}").starts_with("p: ")) << refusal(head + "\"a/b~\": 1}");
  EXPECT_NE(refusal(head + "\"a/b~\": 1}").find("/a~1b~0: unknown key"), std::string::npos);
  EXPECT_NE(
      refusal(head + "\"duration\": " + std::string(1'000'000, '9') + "}").find("/duration: the number 999"),
      std::string::npos);
}

TEST(PresetText, NumbersOfAMillionDigitsAreRead) {
  const std::string digits = "1." + std::string(1'000'000, '3');
  EXPECT_EQ(refusal(R"({"format": "carom-preset", "version": 1, "title": "t", "duration": )" + digits + "}"),
            "");
}

TEST(PresetMessages, SayWhatIsAllowed) {
  const auto disc = [](const std::string& radius) {
    return R"({"format": "carom-preset", "version": 1, "title": "t", "bodies": [{"name": "a", "mass": 1,
      "position": [0, 0], "shape": {"type": "disc", "radius": )" +
           radius + "}}]}";
  };
  EXPECT_EQ(refusal(disc("0")), "");
  EXPECT_EQ(
      refusal(disc("-0.1")),
      "p: /bodies/0/shape/radius: -0.1 is not allowed; allowed: 0, or a number from 1e-12 to 1000000000000 m");
}

}  // namespace
}  // namespace carom
