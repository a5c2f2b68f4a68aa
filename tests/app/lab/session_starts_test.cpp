#include <QTemporaryDir>
#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "tests/app/lab/session_record_fixture.h"
#include "tests/support/wait_events.h"

// Restart, the first start and the list of starts; each is a step of undo, and no run is lost by it.
namespace carom {
namespace {

class SessionStartsTest : public SessionRecordTest {
 protected:
  [[nodiscard]] std::vector<QString> names() {
    std::vector<QString> all;
    for (const SessionStarts::Known& known : session_.starts().known())
      all.push_back(known.start == nullptr ? known.name + "!" : known.name);
    return all;
  }
  void go_to(std::size_t i) {
    session_.starts().go_to(session_.starts().known().at(i));
    settle();
  }
  // Puts disc 2 a little higher at this moment (s), as a new start.
  void raise(double time) {
    run_to(time);
    Body body = now("disc 2");
    body.position.y() += 0.003;
    edit(Replace<Body>{body}, "Move disc 2");
    ASSERT_EQ(refused_, "");
  }
  [[nodiscard]] static std::size_t place_of(const std::string& name) {
    const std::vector<Body> bodies = gas().scene.bodies;
    const auto found =
        std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; });
    return static_cast<std::size_t>(found - bodies.begin());
  }
  void give_mass(const std::string& name, double mass) {
    Body body = now(name);
    body.mass = mass;
    edit(Replace<Body>{body}, "Mass");
  }
};

TEST_F(SessionStartsTest, ARestartIsAStepThatBringsTheWholeRunBack) {
  run_to(0.8);
  const Shown before = shown();
  session_.starts().restart();
  settle();
  EXPECT_EQ(session_.edits().undoText(), "Restart");
  EXPECT_FALSE(session_.modified());
  EXPECT_EQ(session_.runs().frame()->time, 0.0);
  const Shown after = shown();
  expect_undo_and_redo(before, after);
}

TEST_F(SessionStartsTest, ARestartKeepsTheRecordOfARunThatHasShownNothingYet) {
  run_to(0.8);
  Method method = session_.document().method;
  method.step *= 0.5;
  session_.methods().add(method);
  session_.starts().restart();  // before a frame of the new run has come
  settle();
  undo();
  const Shown before = shown();
  ASSERT_EQ(before.runs.size(), 2);
  redo();
  undo();
  expect_same(shown(), before);
  session_.edits().redo();
  session_.edits().undo();  // at once
  settle();
  expect_same(shown(), before);
}

// Until its first frame comes, the picture of the run before stays.
TEST_F(SessionStartsTest, ARunThatHasShownNothingYetIsAtItsStart) {
  run_to(0.8);
  session_.starts().restart();
  session_.starts().set_playing(true);
  session_.edits().undo();
  EXPECT_FALSE(session_.runs().have_begun());
  session_.edits().redo();
  EXPECT_FALSE(session_.runs().have_begun());
  settle();
  undo();
  EXPECT_EQ(session_.runs().frame()->time, 0.0);
}

TEST_F(SessionStartsTest, WhereNothingHasRunARestartIsNoStep) {
  session_.starts().restart();
  session_.starts().restart();
  settle();
  EXPECT_EQ(session_.edits().count(), 0);
  session_.starts().go_to_first();
  EXPECT_EQ(session_.edits().count(), 0);
}

TEST_F(SessionStartsTest, ARunThatPlaysIsBroughtBackPaused) {
  session_.runs().set_playing(true);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return session_.runs().frame()->time > 0.1; }));
  session_.starts().restart();
  settle();
  EXPECT_EQ(session_.runs().frame()->time, 0.0);
  session_.edits().undo();
  EXPECT_FALSE(session_.runs().frame()->playing);
  settle();
  const Shown back = shown();
  EXPECT_GT(back.runs[0].time, 0.1);
  open(gas());
  run_to(back.runs[0].time);
  expect_same(shown(), back);
}

TEST_F(SessionStartsTest, TheFirstStartIsTheOneThatWasOpened) {
  const std::string opened = document();
  raise(0.4);
  const std::string raised = document();
  run_to(0.3);
  const Shown before = shown();
  session_.starts().restart();
  settle();
  EXPECT_EQ(document(), raised) << "the newest one";
  session_.starts().go_to_first();
  settle();
  EXPECT_EQ(document(), opened);
  EXPECT_EQ(session_.edits().undoText(), "First start");
  EXPECT_EQ(session_.runs().frame()->time, 0.0);
  EXPECT_EQ(now("disc 2").position, gas().scene.bodies.at(place_of("disc 2")).position);
  undo();
  EXPECT_EQ(document(), raised);
  undo();
  expect_same(shown(), before);
  session_.starts().go_to_first();
  settle();
  EXPECT_EQ(document(), opened) << "straight from the run";
  undo();
  expect_same(shown(), before);
}

TEST_F(SessionStartsTest, AFileHoldsThemAll) {
  const std::string opened = document();
  raise(0.4);
  const std::string raised = document();
  Body body = now("disc 1");
  body.name = "renamed";
  edit(Replace<Body>{body}, "Rename");
  raise(0.3);
  const std::string last = document();
  const std::vector<QString> before = names();
  ASSERT_EQ(before.size(), 3U);
  const QByteArray text = written_starts(session_.starts().kept());

  open(parse_preset(last, "last"));
  EXPECT_EQ(names().size(), 1U);
  session_.starts().recover(read_starts(text));
  EXPECT_EQ(names(), before);
  ASSERT_TRUE(session_.history().document().start.from);
  EXPECT_NEAR(*session_.history().document().start.from, 0.3, 0.01);
  session_.starts().go_to_first();
  settle();
  EXPECT_EQ(document(), opened);
  undo();
  EXPECT_EQ(document(), last);
  go_to(1);
  EXPECT_EQ(session_.history().document().start.by, "Move disc 2");
  EXPECT_EQ(session_.history().bodies().at(place_of("disc 1")).name, "renamed") << "edited after it had begun";
  EXPECT_NE(document(), raised);
  // A body of one name is the same body: an edit of it is made in the start that came before.
  give_mass("disc 2", 2.0);
  session_.edits().undo();
  settle();
  EXPECT_EQ(session_.history().bodies().size(), gas().scene.bodies.size());
}

TEST_F(SessionStartsTest, WhatIsNoListOfStartsIsSaid) {
  EXPECT_THROW((void)read_starts("{}"), SceneError);
  EXPECT_THROW((void)read_starts("[{\"preset\": \"no preset\"}]"), SceneError);
  EXPECT_TRUE(read_starts("[]").empty());
}

TEST_F(SessionStartsTest, AfterSavingTheFirstStartIsTheSavedOne) {
  raise(0.4);
  const QTemporaryDir folder;
  session_.save(folder.filePath("mine.json"));
  const std::string saved = document();
  raise(0.3);
  EXPECT_NE(document(), saved);
  session_.starts().go_to_first();
  settle();
  EXPECT_EQ(document(), saved);
  EXPECT_EQ(names().front(), "as saved!");
}

TEST_F(SessionStartsTest, AllStartsAreListedByName) {
  EXPECT_EQ(names(), std::vector<QString>{"as opened!"});
  raise(0.4);
  raise(0.2);
  const std::vector<QString> all = names();
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0], "as opened");
  EXPECT_EQ(all[1], "from 0.400 s: Move disc 2");
  EXPECT_EQ(all[2], "from 0.200 s: Move disc 2!");
  const std::string newest = document();
  go_to(1);
  EXPECT_EQ(session_.edits().undoText(), "Start from 0.400 s: Move disc 2");
  EXPECT_EQ(names()[1], "from 0.400 s: Move disc 2!");
  EXPECT_EQ(names().size(), 3U);
  EXPECT_EQ(session_.history().document().start.from, 0.4);
  go_to(2);
  EXPECT_EQ(document(), newest);
  undo();
  undo();
  EXPECT_EQ(names(), all);
  undo();
  EXPECT_EQ(names().size(), 2U) << "a start that is taken back is no start";
}

// They are other starts, though the same edit made them at the same moment.
TEST_F(SessionStartsTest, StartsOfOneNameAreAllListedAndNumbered) {
  std::vector<std::string> made;
  for (int round = 0; round < 3; ++round) {
    session_.starts().go_to_first();
    settle();
    run_to(0.4);
    Body body = now("disc 2");
    body.position.y() += 0.001 * (round + 1);
    edit(Replace<Body>{body}, "Move disc 2");
    ASSERT_EQ(refused_, "");
    made.push_back(document());
  }
  const QString name = "from 0.400 s: Move disc 2";
  const std::vector<QString> all = {"as opened", name, name + " (2)", name + " (3)!"};
  EXPECT_EQ(names(), all);
  go_to(1);
  EXPECT_EQ(document(), made[0]);
  EXPECT_EQ(names()[1], name + "!");
  go_to(2);
  EXPECT_EQ(document(), made[1]);
  go_to(3);
  EXPECT_EQ(document(), made[2]);
  const QByteArray text = written_starts(session_.starts().kept());
  open(parse_preset(document(), "last"));
  session_.starts().recover(read_starts(text));
  EXPECT_EQ(names(), all) << "a crash recovers them all";
}

// What was changed of it afterwards belongs to it.
TEST_F(SessionStartsTest, AStartIsListedAsItWasLeft) {
  give_mass("disc 1", 3.0);
  EXPECT_EQ(names(), (std::vector<QString>{"as opened", "as opened, edited!"}));
  session_.starts().go_to_first();
  settle();
  EXPECT_NE(now("disc 1").mass, 3.0);
  EXPECT_EQ(names(), (std::vector<QString>{"as opened!", "as opened, edited"}));
  go_to(1);
  EXPECT_EQ(now("disc 1").mass, 3.0);
}

// A disc of a file that comes in on the way belongs to the start, with its time and its mass.
TEST_F(SessionStartsTest, AnEditOfADiscThatComesLaterMakesAnotherStart) {
  Preset with = gas();
  with.edits = {{0.3, 0, SceneEdits{Add<Body>{test::disc("late", {0.0, 0.8}, {0.0, 0.0})}}}};
  open(with);
  const std::string opened = document();
  run_to(0.6);
  give_mass("late", 5.0);
  ASSERT_EQ(refused_, "");
  EXPECT_EQ(names(), (std::vector<QString>{"as opened", "as opened, edited!"}));
  session_.starts().go_to_first();
  settle();
  EXPECT_EQ(document(), opened);
  EXPECT_EQ(names(), (std::vector<QString>{"as opened!", "as opened, edited"}));
  go_to(1);
  EXPECT_EQ(*added_body(session_.document().edits.at(0)).mass, 5.0);
}

TEST_F(SessionStartsTest, PlotsOfBodiesThatAStartDoesNotHaveGo) {
  Body added = test::disc("new", {0.0, 0.8}, {0.0, 0.0});
  edit(Add<Body>{added}, "Add");
  Plot both;
  both.y = {{"speed", {"new"}}, {"speed", {"disc 1"}}};
  session_.change_plots({both});
  session_.starts().go_to_first();
  settle();
  ASSERT_EQ(session_.document().plots.size(), 1U);
  ASSERT_EQ(session_.document().plots[0].y.size(), 1U);
  undo();
  EXPECT_EQ(session_.document().plots[0].y.size(), 2U);
}

// --- put into the start before
// -----------------------------------------------------------------------------------------------------------

TEST_F(SessionStartsTest, AnEditIsPutIntoTheStartBefore) {
  run_to(0.4);
  const Shown before = shown();
  Body body = now("disc 2");
  body.velocity.x() = 1.25;
  edit(Replace<Body>{body}, "Speed of disc 2");
  session_.starts().put_into_start_before();
  settle();
  ASSERT_EQ(refused_, "");
  const Body& there = start(place_of("disc 2"));
  const Body was = gas().scene.bodies.at(place_of("disc 2"));
  EXPECT_EQ(there.velocity.x(), 1.25);
  EXPECT_EQ(there.velocity.y(), was.velocity.y()) << "as it starts";
  EXPECT_EQ(there.position, was.position);
  EXPECT_EQ(session_.runs().frame()->time, 0.0);
  EXPECT_EQ(session_.edits().undoText(), "Speed of disc 2");
  EXPECT_EQ(session_.edits().count(), 1);
  EXPECT_FALSE(session_.history().document().start.from);
  undo();
  expect_same(shown(), before);
}

TEST_F(SessionStartsTest, ADragIsPutIntoTheStartBeforeWhole) {
  run_to(0.4);
  drag("disc 3", 7);
  const double x = now("disc 3").position.x();
  run_to(0.2);
  session_.starts().restart();
  session_.starts().put_into_start_before();
  settle();
  ASSERT_EQ(refused_, "");
  const Body was = gas().scene.bodies.at(place_of("disc 3"));
  EXPECT_EQ(start(place_of("disc 3")).position.x(), x);
  EXPECT_EQ(start(place_of("disc 3")).position.y(), was.position.y());
  EXPECT_EQ(start(place_of("disc 3")).velocity, was.velocity);
}

// A new spring at a body that is not there at the start.
TEST_F(SessionStartsTest, WhatTheStartBeforeCannotTakeIsSaid) {
  run_to(0.3);
  session_.add_body(0.0, 0.3);
  settle();
  run_to(0.4);
  Spring spring;
  spring.name = "spring 1";
  spring.body = session_.history().bodies().back().name;
  spring.to = "disc 1";
  spring.stiffness = 10.0;
  spring.rest_length = 0.5;
  edit(Add<Spring>{spring}, "Add spring");
  ASSERT_EQ(refused_.toStdString(), "");
  const std::string with = document();
  session_.starts().put_into_start_before();
  EXPECT_TRUE(refused_.startsWith("Not in the start before: ")) << refused_.toStdString();
  EXPECT_EQ(document(), with);
  EXPECT_TRUE(session_.history().document().start.from);
}

TEST_F(SessionStartsTest, MoreThatWasChangedSinceIsNotLost) {
  raise(0.4);
  give_mass("disc 1", 3.0);
  const std::string with = document();
  session_.starts().put_into_start_before();
  EXPECT_EQ(refused_, "More was changed since: take that back first.");
  EXPECT_EQ(document(), with);
  undo();
  refused_.clear();
  session_.starts().put_into_start_before();
  EXPECT_EQ(refused_, "");
}

}  // namespace
}  // namespace carom
