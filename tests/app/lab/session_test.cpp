#include "app/lab/session.h"

#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <gtest/gtest.h>
#include <set>

#include "app/library/preset_library.h"
#include "physics/preset/preset_file.h"
#include "tests/app/lab/late_discs.h"
#include "tests/app/lab/seen_run.h"
#include "tests/app/lab/session_fixture.h"
#include "tests/support/scenes.h"

// Undo and redo of every edit of a session restore the document and its runs.
namespace carom {
namespace {

constexpr double kEdit = 0.3;  // s
constexpr double kEnd = 0.6;   // s

// All parts of a session that an edit can change. Names of runs are not compared: they are made again.
struct Snapshot {
  std::string document;
  ReferenceId reference;
  std::vector<std::string> bodies;
  struct Run {
    SeenRun seen;
    Method start;
    std::vector<RunEdit> edits;
    std::vector<std::string> names;
  };
  std::vector<Run> runs;
};

std::vector<std::string> names_of(const std::vector<Body>& bodies) {
  std::vector<std::string> names;
  for (const Body& body : bodies) names.push_back(body.name);
  return names;
}

bool same(const RunEdit& a, const RunEdit& b) {
  const auto* method = std::get_if<Method>(&a.what);
  const auto* other = std::get_if<Method>(&b.what);
  if (a.time != b.time || (method == nullptr) != (other == nullptr)) return false;
  if (method != nullptr) return *method == *other;
  return added_body(a).name == added_body(b).name;
}

void expect_same(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.document, b.document);
  EXPECT_EQ(a.reference, b.reference);
  EXPECT_EQ(a.bodies, b.bodies);
  ASSERT_EQ(a.runs.size(), b.runs.size());
  for (std::size_t i = 0; i < a.runs.size(); ++i) {
    SCOPED_TRACE("run " + std::to_string(i));
    expect_same(a.runs[i].seen, b.runs[i].seen);
    EXPECT_EQ(a.runs[i].start, b.runs[i].start) << i;
    EXPECT_EQ(a.runs[i].names, b.runs[i].names) << i;
    EXPECT_TRUE(std::equal(a.runs[i].edits.begin(), a.runs[i].edits.end(), b.runs[i].edits.begin(),
                           b.runs[i].edits.end(), same))
        << i;
  }
}

class SessionTest : public SessionFixture {
 protected:
  SessionTest() { open(); }
  void open() {
    const Preset preset = read_preset(find_preset("drag-projectile"));
    session_.open(preset, preset.plots, {}, "drag-projectile", {});
  }
  [[nodiscard]] Snapshot snapshot() {
    Snapshot now{write_preset(session_.document()),
                 session_.history().document().reference,
                 names_of(session_.history().bodies()),
                 {}};
    const std::vector<SeenRun> seen = seen_runs(session_.runs());
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const Frame& frame = *session_.runs().frames()[i];
      now.runs.push_back({seen[i], frame.setup->method, frame.setup->edits, names_of(*frame.bodies)});
    }
    return now;
  }
};

Plot named(const char* id) {
  Plot plot;
  plot.id = id;
  return plot;
}

struct Case {
  const char* name;
  const char* text;
  std::function<void(Session&)> edit;
  bool is_work = true;
};

Method euler(const Session& session, double step) {
  Method method = session.document().method;
  method.integrator = IntegratorId::kExplicitEuler;
  method.step = step;
  return method;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"Method", "Method: Explicit Euler",
       [](Session& s) { s.methods().change(euler(s, s.document().method.step)); }},
      {"MethodOfAComparedRun", "Method: Velocity Verlet",
       [](Session& s) { s.methods().change(Method{.integrator = IntegratorId::kVelocityVerlet}, 1); }},
      {"Step", "Step 2 ms", [](Session& s) { s.methods().change_step(0.002, {0}, 1); }},
      {"StepOfAll", "Step 2.5 ms",
       [](Session& s) {
         s.methods().change_step(0.0025, {0, 1, 2}, 1);
       }},
      {"AddedMethod", "Add method Explicit Euler", [](Session& s) { s.methods().add(euler(s, 0.004)); }},
      {"RemovedMethod", "Remove method Explicit Euler", [](Session& s) { s.methods().remove(1); }},
      {"Reference", "Reference", [](Session& s) { s.methods().choose_reference(ReferenceId::kNone); }, false},
      {"Body", "Drop disc at 0.3 s", [](Session& s) { s.add_body(0.3, 1.5); }},
      {"Plots", "Remove plot", [](Session& s) { s.change_plots({named("energy")}); }, false},
      {"Notes", "Notes of a plot",
       [](Session& s) {
         std::vector<Plot> plots = s.document().plots;
         plots.front().notes = {{0.1, 0.2, "here"}};
         s.change_plots(plots);
       }},
  };
  return all;
}

TEST_F(SessionTest, EachEditIsUndoneAsIfItHadNeverBeen) {
  run_to(kEnd);
  const Snapshot never = snapshot();
  for (const Case& each : cases()) {
    SCOPED_TRACE(each.name);
    open();
    run_to(kEdit);
    EXPECT_FALSE(session_.modified());
    each.edit(session_);
    EXPECT_EQ(session_.edits().undoText().toStdString(), each.text);
    EXPECT_EQ(session_.modified(), each.is_work);
    run_to(kEnd);
    const Snapshot with = snapshot();
    undo();
    expect_same(snapshot(), never);
    EXPECT_FALSE(session_.modified());
    redo();
    expect_same(snapshot(), with);
    undo();
    expect_same(snapshot(), never);
  }
}

// This edit restarts the run, and so does its undo.
TEST_F(SessionTest, TheUsualComparisonIsUndone) {
  run_to(kEnd);
  const Snapshot never = snapshot();
  session_.methods().compare_usual(session_.document().plots, {});
  run_to(kEnd);
  const Snapshot with = snapshot();
  ASSERT_EQ(with.runs.size(), 3U);
  undo();
  expect_same(snapshot(), never);
  EXPECT_FALSE(session_.methods().compares_usual());
  redo();
  expect_same(snapshot(), with);
  EXPECT_TRUE(session_.methods().compares_usual());
  session_.methods().compare_usual(session_.document().plots, {});
  run_to(kEnd);
  undo();
  expect_same(snapshot(), with);
}

// Several edits, undone without waiting for the runs.
TEST_F(SessionTest, ManyEditsAreUndoneAtOnce) {
  run_to(kEnd);
  const Snapshot never = snapshot();
  open();
  double time = 0.0;
  for (const Case& each : cases()) {
    run_to(time += kEnd / 12.0);
    each.edit(session_);
  }
  run_to(kEnd);
  const Snapshot with = snapshot();
  for (std::size_t i = 0; i < cases().size(); ++i) session_.edits().undo();
  EXPECT_FALSE(session_.edits().canUndo());
  settle();
  expect_same(snapshot(), never);
  for (std::size_t i = 0; i < cases().size(); ++i) session_.edits().redo();
  settle();
  expect_same(snapshot(), with);
}

TEST_F(SessionTest, UndoWhileARunPlays) {
  session_.runs().set_speed(0.1);
  session_.runs().set_playing(true);
  ASSERT_TRUE(test::wait_in_event_loop(
      [&] { return session_.runs().frame() && session_.runs().frame()->time > 0.05; }));
  session_.add_body(0.3, 1.5);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return session_.runs().frame()->setup->edits.size() == 1; }));
  session_.methods().change(euler(session_, 0.004));
  ASSERT_TRUE(test::wait_in_event_loop([&] { return session_.runs().frame()->setup->edits.size() == 2; }));
  const double time = session_.runs().frame()->time;
  session_.edits().undo();
  session_.edits().undo();
  ASSERT_TRUE(test::wait_in_event_loop([&] { return session_.runs().frame()->setup->edits.empty(); }));
  EXPECT_GT(session_.runs().frame()->time, time - 0.01) << "the moments on the way are not shown";
  EXPECT_TRUE(session_.runs().frame()->playing);
  ASSERT_TRUE(test::wait_in_event_loop([&] { return session_.runs().frame()->time > time + 0.05; }));
  session_.runs().set_playing(false);
  settle();
  const Snapshot undone = snapshot();
  open();
  run_to(session_.document().method.step * static_cast<double>(undone.runs[0].seen.steps));
  EXPECT_TRUE(test::same_bytes(snapshot().runs[0].seen.state, undone.runs[0].seen.state));
}

// A restart begins with the current methods; an undo after it acts from the start.
TEST_F(SessionTest, UndoAfterARestart) {
  run_to(kEnd);
  const Snapshot never = snapshot();
  open();
  run_to(kEdit);
  session_.methods().change(euler(session_, 0.004));
  session_.add_body(0.3, 1.5);
  session_.runs().restart();
  run_to(kEnd);
  const Snapshot with = snapshot();
  EXPECT_EQ(with.runs[0].start.integrator, IntegratorId::kExplicitEuler);
  undo();
  undo();
  expect_same(snapshot(), never);
  session_.runs().restart();
  run_to(kEnd);
  expect_same(snapshot(), never);
  redo();
  redo();
  expect_same(snapshot(), with);
}

// Discs that were added on the way come in at their time, however the work is brought back: restarted, undone
// and redone, saved and opened, recovered under several methods. The runs are the same to the last bit.
TEST_F(SessionTest, WhatIsSavedIsTheRunThatWasSeen) {
  const Preset preset = late_discs_preset();
  session_.open(preset, preset.plots, {}, {}, {});
  add_late_discs(session_);
  settle();
  const Snapshot seen = snapshot();
  ASSERT_EQ(seen.runs[0].names.size(), preset.scene.bodies.size() + 2);
  for (const Snapshot::Run& run : seen.runs) {
    std::set<int> hit;
    for (const ImpactRecord& impact : run.seen.impacts) hit.insert({impact.a, impact.b});
    EXPECT_EQ(hit.size(), run.names.size()) << "each body has had an impact";
  }
  ASSERT_EQ(session_.document().scene.bodies.size(), preset.scene.bodies.size())
      << "they are not there at t = 0";
  session_.runs().restart();
  run_to(0.5);
  EXPECT_EQ(snapshot().runs[0].names.size(), preset.scene.bodies.size());
  run_to(kLateDiscsEnd);
  expect_same(snapshot(), seen);
  undo();
  undo();
  EXPECT_EQ(snapshot().runs[1].names.size(), preset.scene.bodies.size());
  redo();
  redo();
  expect_same(snapshot(), seen);

  const QTemporaryDir folder;
  const QString file = folder.filePath("mine.json");
  session_.save(file);
  const Preset saved = read_preset(file.toStdString());
  session_.open(saved, saved.plots, {}, {}, file);
  run_to(kLateDiscsEnd);
  const Snapshot opened = snapshot();
  EXPECT_EQ(opened.document, seen.document);
  ASSERT_EQ(opened.runs.size(), seen.runs.size());
  for (std::size_t i = 0; i < seen.runs.size(); ++i) {
    EXPECT_EQ(opened.runs[i].names, seen.runs[i].names);
    expect_same(opened.runs[i].seen, seen.runs[i].seen);
  }
  Simulation alone(setup_of(saved));
  alone.advance_to(kLateDiscsEnd);
  EXPECT_TRUE(test::same_bytes(alone.state(), seen.runs[0].seen.state)) << "also on the command line";
  // Another disc is called otherwise, and those to come in stand after it once it is there.
  session_.runs().restart();
  run_to(0.3);
  session_.add_body(0.02, 1.0);
  run_to(kLateDiscsEnd);
  EXPECT_EQ(snapshot().bodies, snapshot().runs[0].names);
  EXPECT_EQ(snapshot().bodies[preset.scene.bodies.size()], "C");
}

TEST_F(SessionTest, AnEditAfterAnUndoTakesThePlaceOfWhatWasUndone) {
  run_to(kEdit);
  session_.add_body(0.3, 1.5);
  session_.edits().undo();
  session_.methods().change(euler(session_, 0.004));
  EXPECT_FALSE(session_.edits().canRedo());
  run_to(kEnd);
  const Snapshot with = snapshot();
  EXPECT_EQ(with.runs[0].edits.size(), 1U);
  EXPECT_NEAR(with.runs[0].edits[0].time, kEdit, 1e-9);
  undo();
  redo();
  expect_same(snapshot(), with);
}

TEST_F(SessionTest, TheStepsOfOneDragAreOneEdit) {
  run_to(kEdit);
  for (const double step : {0.004, 0.003, 0.002}) session_.methods().change_step(step, {0}, 7);
  EXPECT_EQ(session_.edits().count(), 1);
  session_.methods().change_step(0.001, {0}, 8);
  EXPECT_EQ(session_.edits().count(), 2);
  session_.edits().undo();
  EXPECT_EQ(session_.document().method.step, 0.002);
  undo();
  EXPECT_EQ(session_.runs().frame()->setup->edits.size(), 0U);
  redo();
  EXPECT_EQ(session_.document().method.step, 0.002);
  EXPECT_EQ(session_.runs().frame()->setup->edits.size(), 3U);
}

TEST_F(SessionTest, TheMarkOfChangesFollowsUndoAndSave) {
  std::vector<bool> marks;
  QObject::connect(&session_, &Session::modifiedChanged, [&](bool modified) { marks.push_back(modified); });
  const QTemporaryDir folder;
  const QString file = folder.filePath("mine.json");
  session_.add_body(0.3, 1.5);
  session_.save(file);
  EXPECT_EQ(session_.file(), file);
  EXPECT_FALSE(session_.modified());
  session_.edits().undo();
  EXPECT_TRUE(session_.modified());
  session_.edits().redo();
  EXPECT_FALSE(session_.modified());
  session_.edits().undo();
  session_.change_plots({named("energy")});
  EXPECT_TRUE(session_.modified());
  session_.edits().undo();
  EXPECT_TRUE(session_.modified()) << "what was saved can't be reached any more";
  EXPECT_EQ(marks, (std::vector<bool>{true, false, true, false, true}));
  open();
  EXPECT_FALSE(session_.modified());
  EXPECT_FALSE(session_.edits().canUndo());
  session_.edits().resetClean();
  EXPECT_TRUE(session_.modified());
}

// The choice of named plots of a built-in experiment is not work that could be lost.
TEST_F(SessionTest, WhichNamedPlotsAreOpenIsUndoneButNoWork) {
  session_.change_plots({named("energy"), named("ledger")});
  EXPECT_FALSE(session_.modified());
  EXPECT_TRUE(session_.edits().canUndo());
  session_.edits().undo();
  EXPECT_FALSE(session_.modified());
}

}  // namespace
}  // namespace carom
