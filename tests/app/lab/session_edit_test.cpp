#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "app/lab/session.h"
#include "physics/preset/preset_file.h"
#include "physics/run/simulation.h"
#include "physics/scene/fingerprint.h"
#include "tests/app/lab/session_edit_fixture.h"
#include "tests/app/lab/two_discs.h"
#include "tests/support/scenes.h"

// Edits of the scene in a session: at the start, from a moment on, of a run as it goes on; and all of them
// taken back and made again.
namespace carom {
namespace {

TEST_F(SessionEditTest, AtTheStartChangesTheStart) {
  const std::string before = document();
  Body right = now("right");
  right.position.x() = 0.6;
  edit(Replace<Body>{right}, "Move right");
  EXPECT_EQ(session_.edits().undoText(), "Move right");
  EXPECT_EQ(start(1).position.x(), 0.6);
  EXPECT_EQ(now("right").position.x(), 0.6);
  EXPECT_EQ(session_.runs().frame()->time, 0.0);
  run_to(1.0);
  EXPECT_NEAR(now("right").position.x(), 0.6 + 0.6, 1e-12) << "hit at 0.4 s, by an equal disc";
  undo();
  EXPECT_EQ(document(), before);
  EXPECT_EQ(session_.runs().frame()->time, 0.0);
  EXPECT_EQ(now("right").position.x(), 1.0);
  redo();
  EXPECT_EQ(now("right").position.x(), 0.6);
}

// Mass 1 hits mass 3 at 0.8 s with e = 1: -1/2 and 1/2 m/s afterwards.
TEST_F(SessionEditTest, OfWhatThingsAreHoldsFromNowOnAndInTheStart) {
  const std::string before = document();
  run_to(0.5);
  Body right = now("right");
  right.mass = 3.0;
  edit(Replace<Body>{right}, "Mass of right");
  EXPECT_EQ(session_.runs().frame()->time, 0.5) << "the run goes on";
  EXPECT_EQ(*start(1).mass, 3.0);
  EXPECT_EQ(start(0).position.x(), 0.0) << "the start keeps its places";
  run_to(1.0);
  EXPECT_NEAR(now("left").velocity.x(), -0.5, 1e-12);
  EXPECT_NEAR(now("right").velocity.x(), 0.5, 1e-12);
  undo();
  EXPECT_EQ(document(), before);
  EXPECT_NEAR(session_.runs().frame()->time, 1.0, 1e-9);
  EXPECT_NEAR(now("right").velocity.x(), 1.0, 1e-12) << "replayed with equal masses";
  redo();
  EXPECT_NEAR(now("right").velocity.x(), 0.5, 1e-12);
  session_.runs().restart();
  settle();
  run_to(1.0);
  EXPECT_NEAR(now("right").velocity.x(), 0.5, 1e-12);
}

// The start that was edited in mid-run is the one that runs begin from; so is the one that is undone to.
TEST_F(SessionEditTest, AnEditOfARunIsUndoneAfterARestart) {
  const auto mass_now = [this] { return *now("right").mass; };
  run_to(0.5);
  Body right = now("right");
  for (const double mass : {3.0, 5.0}) {
    right = now("right");
    right.mass = mass;
    edit(Replace<Body>{right}, "Mass of right");
  }
  session_.runs().restart();
  settle();
  EXPECT_EQ(mass_now(), 5.0);
  for (int round = 0; round < 2; ++round) {
    undo();
    EXPECT_EQ(mass_now(), 3.0) << round;
    undo();
    EXPECT_EQ(mass_now(), 1.0) << round;
    redo();
    EXPECT_EQ(mass_now(), 3.0) << round;
    redo();
    EXPECT_EQ(mass_now(), 5.0) << round;
    run_to(round == 0 ? 0.2 : 1.0);
  }
  undo();
  undo();
  EXPECT_NEAR(session_.runs().frame()->time, 1.0, 1e-9) << "replayed to where it was";
  EXPECT_NEAR(now("right").velocity.x(), 1.0, 1e-12) << "of equal masses";
}

TEST_F(SessionEditTest, OfMotionIsANewStartFromHere) {
  const std::string before = document();
  run_to(1.0);
  Body right = now("right");
  ASSERT_NEAR(right.velocity.x(), 1.0, 1e-12);
  right.velocity = {0.0, 2.0};
  edit(Replace<Body>{right}, "Speed of right");
  EXPECT_EQ(session_.runs().frame()->time, 0.0);
  EXPECT_NEAR(start(0).position.x(), 0.8, 1e-12);
  EXPECT_EQ(start(1).velocity, Vec2(0.0, 2.0));
  run_to(0.5);
  EXPECT_NEAR(now("right").position.y(), 1.0, 1e-12);
  undo();
  EXPECT_EQ(document(), before);
  EXPECT_NEAR(session_.runs().frame()->time, 1.0, 1e-12);
  EXPECT_NEAR(now("left").position.x(), 0.8, 1e-12);
}

TEST_F(SessionEditTest, WhatChangesNothingIsNoStep) {
  Body left = start(0);
  edit(Replace<Body>{left});
  EXPECT_EQ(session_.edits().count(), 0);
  left.velocity = -left.velocity;
  edit(Replace<Body>{left});
  EXPECT_EQ(session_.edits().count(), 1);
  run_to(0.2);
  edit(Replace<Body>{now("left")});
  EXPECT_EQ(session_.edits().count(), 1);
}

TEST_F(SessionEditTest, OneDragIsOneStep) {
  const std::string before = document();
  run_to(0.3);
  const Body right = now("right");
  for (int i = 1; i <= 20; ++i) {
    Body moved = right;
    moved.position.y() = 0.01 * i;
    session_.edit({Replace<Body>{moved}}, "Move right", 7);
  }
  settle();
  EXPECT_EQ(session_.edits().count(), 1);
  EXPECT_EQ(now("right").position.y(), 0.2);
  undo();
  EXPECT_EQ(document(), before);
  redo();
  EXPECT_EQ(now("right").position.y(), 0.2);
  Body left = now("left");
  for (int i = 1; i <= 5; ++i) {
    left.position.y() = -0.01 * i;
    session_.edit({Replace<Body>{left}}, "Move left", 8);
  }
  session_.cancel(8);
  settle();
  EXPECT_EQ(now("left").position.y(), 0.0);
  EXPECT_EQ(session_.edits().count(), 1);
  EXPECT_FALSE(session_.edits().canRedo());
}

TEST_F(SessionEditTest, WhatNamesABodyFollowsItsName) {
  Preset preset = two_discs();
  Joint rod;
  rod.body = "left";
  rod.to = "right";
  preset.scene.joints = {rod};
  preset.scene.bodies[0].velocity = {0.0, 0.0};
  Plot plot;
  plot.y = {{"speed", {"right"}}, {"speed", {"left"}}};
  preset.plots = {plot};
  preset.stops = {stop_of("", "at the 1st impact of left with right"), stop_of("", "when left passes x = 1 m")};
  open(preset);
  const std::string before = document();
  Body right = now("right");
  right.name = "heavy";
  edit(Replace<Body>{right}, "Rename");
  EXPECT_EQ(session_.document().scene.joints[0].to, "heavy");
  EXPECT_EQ(session_.document().plots[0].y[0].bodies[0], "heavy");
  EXPECT_EQ(sentence_of(session_.document().stops[0]), "at the 1st impact of left with heavy");
  run_to(0.2);
  edit(Remove<Body>{now("heavy").id}, "Delete heavy");
  EXPECT_TRUE(session_.document().scene.joints.empty());
  ASSERT_EQ(session_.document().plots[0].y.size(), 1U);
  EXPECT_EQ(session_.document().plots[0].y[0].bodies[0], "left");
  ASSERT_EQ(session_.document().stops.size(), 1U);
  EXPECT_EQ(sentence_of(session_.document().stops[0]), "when left passes x = 1 m");
  EXPECT_EQ(session_.history().bodies().size(), 1U);
  undo();
  undo();
  EXPECT_EQ(document(), before);
}

// The weld that the run made follows by itself.
TEST_F(SessionEditTest, ABodyThatHasStuckIsRenamedAndDeleted) {
  Preset preset = two_discs();
  preset.scene.materials[0].restitution = 0.0;
  preset.scene.materials[0].sticks = true;
  open(preset);
  run_to(1.0);
  ASSERT_NEAR(now("right").velocity.x(), 0.5, 1e-12);
  Body right = now("right");
  right.name = "stuck";
  edit(Replace<Body>{right}, "Rename");
  EXPECT_EQ(refused_, "");
  run_to(1.2);
  EXPECT_NEAR(now("stuck").velocity.x(), 0.5, 1e-12);
  edit(Remove<Body>{now("stuck").id}, "Delete stuck");
  EXPECT_EQ(refused_, "");
  EXPECT_EQ(session_.history().bodies().size(), 1U);
  EXPECT_NEAR(start(0).velocity.x(), 0.5, 1e-12);
}

TEST_F(SessionEditTest, ABodyOfAGeneratorBecomesAListedOne) {
  Preset preset = two_discs();
  GridGenerator grid;
  grid.name = "disc";
  grid.columns = 3;
  grid.rows = 1;
  grid.origin = {0.0, 2.0};
  grid.spacing = {0.5, 0.5};
  grid.radius_min = grid.radius_max = 0.1;
  preset.scene.generators = {grid};
  open(preset);
  const std::string before = document();
  Body disc = now("disc-2");
  disc.velocity = {0.0, 1.0};
  edit(Replace<Body>{disc}, "Speed of disc-2");
  EXPECT_TRUE(session_.document().scene.generators.empty());
  EXPECT_EQ(session_.document().scene.bodies.size(), 5U);
  EXPECT_EQ(now("disc-2").velocity.y(), 1.0);
  EXPECT_EQ(now("disc-1").velocity.y(), 0.0);
  undo();
  EXPECT_EQ(document(), before);
}

// Exact flight knows no drag.
TEST_F(SessionEditTest, AMethodThatBecomesImpossibleChangesWithTheEdit) {
  Preset preset = two_discs();
  preset.method.integrator = IntegratorId::kExactFlight;
  open(preset);
  run_to(0.2);
  edit(SetForces{.gravity = {0.0, 0.0}, .linear_drag = 1.0}, "Drag");
  EXPECT_EQ(session_.document().method.integrator, IntegratorId::kRk4);
  EXPECT_EQ(session_.runs().frame()->method.integrator, IntegratorId::kRk4);
  EXPECT_EQ(said_, "Exact flight can't have drag: RK4 instead.");
  run_to(0.4);
  EXPECT_NEAR(now("left").velocity.x(), std::exp(-0.2), 1e-8);
  undo();
  EXPECT_EQ(session_.document().method.integrator, IntegratorId::kExactFlight);
  EXPECT_NEAR(now("left").velocity.x(), 1.0, 1e-12);
}

TEST_F(SessionEditTest, WhatIsNotAllowedIsSaidAndChangesNothing) {
  const std::string before = document();
  Body right = now("right");
  right.mass = -1.0;
  session_.edit({Replace<Body>{right}}, "Mass of right");
  EXPECT_TRUE(refused_.contains("mass")) << refused_.toStdString();
  right.mass = 1.0;
  right.name = "left";
  session_.edit({Replace<Body>{right}}, "Rename");
  EXPECT_TRUE(refused_.contains("left")) << refused_.toStdString();
  session_.edit({Remove<Body>{{99}}}, "Delete");
  EXPECT_EQ(document(), before);
  EXPECT_FALSE(session_.edits().canUndo());
}

TEST_F(SessionEditTest, ARefusalNamesThingsAndHasFewDigits) {
  Body right = now("right");
  right.mass = -1.0 / 3.0;
  session_.edit({Replace<Body>{right}}, "Mass of right");
  EXPECT_TRUE(refused_.startsWith("right, mass: -0.333333 is not allowed")) << refused_.toStdString();
  Joint rod;
  rod.kind = JointKind::kRod;
  rod.body = "left";
  rod.to = "right";
  rod.length = 1.0 / 3.0;
  session_.edit({Add<Joint>{rod}}, "Add rod");
  EXPECT_TRUE(refused_.startsWith("Rod 1, length: 0.333333 for ends")) << refused_.toStdString();
  Joint weld;
  weld.kind = JointKind::kWeld;
  weld.body = weld.to = "left";
  session_.edit({Add<Joint>{weld}}, "Add weld");
  EXPECT_EQ(refused_, "Both ends of Weld 1 are on left; it joins two bodies.");
  session_.edit({SetForces{.gravity = {0.0, 1e30}}}, "Gravity");
  EXPECT_TRUE(refused_.startsWith("gravity y: 1e+30 is not allowed")) << refused_.toStdString();
  EXPECT_FALSE(refused_.contains('/' + QString("gravity")));
  EXPECT_FALSE(session_.edits().canUndo());
}

TEST_F(SessionEditTest, ABodyWithoutAnAreaAndAMassIsRefusedInPlainWords) {
  Body right = now("right");
  right.mass.reset();
  right.density.reset();
  right.shape = Disc{0.0};
  session_.edit({Replace<Body>{right}}, "Radius of right");
  EXPECT_EQ(refused_,
            "Without an area right has no mass by its density. Give it a mass first, or a size above 0.");
  EXPECT_FALSE(session_.edits().canUndo());
}

TEST_F(SessionEditTest, ADiscThatCameLaterIsEditedWhereItStands) {
  run_to(0.5);
  session_.add_body(0.5, 1.0);
  settle();
  run_to(0.7);
  Body late = now("A");
  late.mass = 5.0;
  late.density.reset();
  edit(Replace<Body>{late}, "Mass of A");
  EXPECT_NEAR(session_.runs().frame()->time, 0.7, 1e-12);
  ASSERT_EQ(session_.document().edits.size(), 1U);
  EXPECT_EQ(*added_body(session_.document().edits[0]).mass, 5.0);
  EXPECT_EQ(*now("A").mass, 5.0);
  Body moved = now("A");
  moved.position.y() = 2.0;
  edit(Replace<Body>{moved}, "Move A");
  EXPECT_TRUE(session_.document().edits.empty()) << "it is there at the new start";
  EXPECT_EQ(session_.document().scene.bodies.size(), 3U);
  undo();
  undo();
  undo();
  EXPECT_EQ(document(), write_preset(two_discs()));
}

// The same in a file that was opened: its discs have ids of their own from the start on.
TEST_F(SessionEditTest, ALateDiscOfAFileIsEditedWhereItStands) {
  run_to(0.5);
  session_.add_body(0.5, 1.0);
  settle();
  open(parse_preset(document(), "file"));
  const std::string opened = document();
  run_to(0.7);
  Body late = now("A");
  late.mass = 5.0;
  late.density.reset();
  edit(Replace<Body>{late}, "Mass of A");
  EXPECT_EQ(refused_, "");
  ASSERT_EQ(session_.document().edits.size(), 1U);
  EXPECT_EQ(*added_body(session_.document().edits[0]).mass, 5.0);
  EXPECT_EQ(*now("A").mass, 5.0);
  EXPECT_EQ(session_.add_body(-0.5, 1.0), "B");
  settle();
  EXPECT_NE(now("A").id, now("B").id);
  undo();
  undo();
  EXPECT_EQ(document(), opened);
}

// What one start gave is not given again in another, so that no id means two parts of a session.
TEST_F(SessionEditTest, GivesNoIdTwice) {
  const auto add = [this](const char* name, double x) {
    edit(Add<Body>{test::disc(name, {x, 2.0}, {0.0, 0.0})}, "Add disc");
    EXPECT_EQ(refused_, "");
    return session_.document().scene.bodies.back().id.number;
  };
  const std::string before = document();
  const std::uint64_t scene = fingerprint(session_.document().scene, 0.0);
  run_to(0.3);
  std::set<std::uint32_t> given = {start(0).id.number, start(1).id.number};
  EXPECT_TRUE(given.insert(add("a", 0.0)).second);
  EXPECT_TRUE(given.insert(add("b", 1.0)).second);
  undo();
  undo();
  EXPECT_EQ(document(), before);
  EXPECT_EQ(fingerprint(session_.document().scene, 0.0), scene);
  EXPECT_NEAR(session_.runs().frame()->time, 0.3, 1e-12);
  EXPECT_TRUE(given.insert(add("c", 2.0)).second) << "in the start that is new";
  undo();
  session_.starts().restart();
  settle();
  EXPECT_TRUE(given.insert(add("d", 3.0)).second) << "in the start that was there";
  session_.starts().go_to_first();
  settle();
  EXPECT_TRUE(given.insert(add("e", 4.0)).second);
}

// Random edits of a small scene, at the start and on the way, taken back and made again one by one: the
// document is the same text each time, and so is the run that begins again.
TEST_F(SessionEditTest, RandomEditsAreTakenBackAndMadeAgain) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    open(two_discs());
    std::mt19937 random(seed);
    const auto draw = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::vector<std::string> documents = {document()};
    for (int i = 0; i < 8; ++i) {
      if (random() % 3 == 0) run_to(session_.runs().frame()->time + 0.1);
      const std::vector<Body>& bodies = session_.runs().frame()->scene->bodies;
      Body body = bodies.empty() ? Body{} : bodies[random() % bodies.size()];
      switch (bodies.empty() ? 0 : random() % 6) {
        case 0:
          body = two_discs().scene.bodies[0];
          body.name = free_body_name(bodies, "new");
          body.position = {draw(-3.0, 3.0), draw(1.0, 3.0)};
          session_.edit({Add<Body>{body}}, "Add disc");
          break;
        case 1:
          body.mass = draw(0.5, 2.0);
          session_.edit({Replace<Body>{body}}, "Mass");
          break;
        case 2:
          body.velocity = {draw(-1.0, 1.0), draw(-1.0, 1.0)};
          session_.edit({Replace<Body>{body}}, "Speed");
          break;
        case 3:
          session_.edit({Remove<Body>{body.id}}, "Delete");
          break;
        case 4:
          body.name += 'x';
          session_.edit({Replace<Body>{body}}, "Rename");
          break;
        default:
          session_.edit({SetForces{.gravity = {0.0, draw(-10.0, 0.0)}}}, "Gravity");
      }
      settle();
      ASSERT_EQ(refused_, "");
      documents.push_back(document());
    }
    ASSERT_EQ(session_.edits().count(), 8);
    for (int i = 7; i >= 0; --i) {
      undo();
      ASSERT_EQ(document(), documents[static_cast<std::size_t>(i)]) << seed << ", edit " << i;
    }
    for (std::size_t i = 1; i <= 8; ++i) {
      redo();
      ASSERT_EQ(document(), documents[i]) << seed << ", edit " << i;
    }
    session_.runs().restart();
    run_to(0.5);
    Simulation alone(setup_of(session_.document()));
    alone.advance_to(0.5);
    EXPECT_TRUE(test::same_bytes(alone.state(), session_.runs().frame()->state)) << seed;
  }
}

}  // namespace
}  // namespace carom
