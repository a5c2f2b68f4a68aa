#include "tests/app/lab/random_edits.h"

#include <array>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "app/lab/session.h"
#include "physics/preset/preset_file.h"
#include "tests/app/lab/two_discs.h"
#include "tests/support/effort.h"
#include "tests/support/scenes.h"
#include "tests/support/wait_events.h"

// Random edits of every kind, taken back, made again and cancelled in between: no document is lost, changed or
// invalid, and each is what the edits that were not taken back make of the first one.
namespace carom {
namespace {

Preset first_document() {
  Preset preset = two_discs();
  preset.duration = 1000.0;
  Plot speed;
  speed.y = {{"speed", {"left"}}, {"speed", {"right"}}};
  preset.plots = {speed};
  return preset;
}

Method other_method(const Method& method, unsigned seed) {
  constexpr std::array kIntegrators = {IntegratorId::kExplicitEuler, IntegratorId::kRk4,
                                       IntegratorId::kVelocityVerlet, IntegratorId::kDormandPrince};
  Method other = method;
  other.integrator = kIntegrators[seed % kIntegrators.size()];
  other.step = seed % 3 == 0 ? 0.01 : 0.005;
  return other;
}

// A session with the texts of its document after each step of undo, and what its run was there.
class EditedSession {
 public:
  EditedSession() {
    QObject::connect(&session_.history(), &EditHistory::editRefused, [this] { ++refused_; });
    const Preset first = first_document();
    session_.open(first, first.plots, {}, {}, {});
    documents_ = {document()};
  }

  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] QUndoStack& edits() { return session_.edits(); }
  [[nodiscard]] std::string document() const { return write_preset(session_.document()); }
  [[nodiscard]] int refused() const { return refused_; }
  [[nodiscard]] std::size_t index() { return static_cast<std::size_t>(edits().index()); }
  // Of the edits that were not taken back, in their order.
  [[nodiscard]] std::vector<unsigned> seeds() {
    return {seeds_.begin(), seeds_.begin() + static_cast<std::ptrdiff_t>(index())};
  }
  [[nodiscard]] const std::map<std::string, int>& made() const { return made_; }

  // One edit, of this scene; sometimes in three parts of one drag.
  void edit(const Scene& scene, unsigned seed) {
    test::RandomEdits random(scene, seed);
    if (seed % 16 == 0) {
      session_.methods().change(other_method(session_.document().method, seed / 16));
    } else {
      const SceneEdits edits = random.any();
      const int drag = seed % 5 == 1 && edits.size() == 1 ? ++drags_ : 0;
      for (int part = drag > 0 ? 3 : 1; part > 0; --part)
        session_.edit(edits, QString::fromUtf8(random.kind().data()), drag);
    }
    last_ = seed % 16 == 0 ? "method" : std::string(random.kind());
  }
  // To be called when the runs have followed.
  void note(unsigned seed, std::size_t before) {
    if (index() > before) {
      seeds_.resize(before);
      documents_.resize(before + 1);
      known_runs_.resize(before + 1);
      for (; documents_.size() <= index(); documents_.push_back(document())) seeds_.push_back(seed);
      ++made_[last_];
    } else {
      EXPECT_EQ(document(), documents_[index()]) << "by a refused " << last_;
    }
  }
  void expect_known() {
    ASSERT_LT(index(), documents_.size());
    EXPECT_EQ(document(), documents_[index()]) << "step " << index();
  }
  // When the runs have followed: after so many steps the run is at this step of undo what it was before.
  void expect_known_run() {
    known_runs_.resize(documents_.size());
    const Frame& now = *session_.runs().newest().front();
    const auto [known, is_new] = known_runs_[index()].try_emplace(now.steps, now.state);
    if (is_new) return;
    ++compared_;
    EXPECT_TRUE(test::same_bytes(known->second, now.state))
        << "step " << index() << ", at " << now.time << " s, after " << last_;
  }
  // As one step of undo, if the run has left its start.
  void restart() {
    const std::size_t before = index();
    last_ = "restart";
    session_.starts().restart();
    note(0, before);
  }
  // Where this begins the run, edits that follow are then made in its start.
  void redo() {
    const std::size_t before = index();
    edits().redo();
    if (session_.runs().at_start() && known_runs_.size() > before) known_runs_.resize(before + 1);
  }
  [[nodiscard]] int compared() const { return compared_; }
  // At the document's start.
  void edit_start(unsigned seed) {
    const std::size_t before = index();
    edit(*scene_at_start(session_.document().scene), seed);
    note(seed, before);
  }
  // Waits until the runs have done all that was asked for before: a curve that is asked for now comes last.
  void settle() {
    const Curve curve{{find_observable(settled_++ % 2 == 0 ? "kinetic_energy" : "total_energy"), {}}, {}};
    LabRuns& runs = session_.runs();
    runs.record({});
    runs.record({curve});
    ASSERT_TRUE(test::wait_in_event_loop([&] {
      const auto frame = runs.frame();
      return frame && frame->scene && !runs.replayed() && runs.waits().isEmpty() &&
             runs.recorders()[0]->series(curve) != nullptr && frame->rows_known_until >= frame->time;
    })) << last_;
  }
  // The same, and a run that is lost begins again.
  void settle_anew() {
    settle();
    if (session_.runs().lost() == nullptr) return;
    restart();
    settle_anew();
  }
  // At the shown moment.
  void edit_now(unsigned seed) {
    const std::size_t before = index();
    edit(*session_.runs().scene(), seed);
    settle_anew();
    note(seed, before);
  }
  // While the run plays; or a disc that comes into it.
  void edit_playing(unsigned seed) {
    const std::size_t before = index();
    test::RandomEdits random(session_.document().scene, seed);
    const SceneEdits edits = random.of_no_part();
    last_ = std::string(random.kind());
    session_.runs().set_playing(true);
    const LabRuns& runs = session_.runs();
    ASSERT_TRUE(test::wait_in_event_loop([&] { return runs.frame()->playing || runs.lost() != nullptr; }));
    if (seed % 3 == 0) {
      last_ = "disc in the run";
      try {
        session_.add_body(0.1 * (seed % 60) - 3.0, 2.0);
      } catch (const SceneError&) {
        ++refused_;  // in words
      }
    } else {
      session_.edit(edits, QString::fromStdString(last_));  // what changes nothing is no step
      ASSERT_TRUE(test::wait_in_event_loop([&] { return runs.waits().isEmpty(); }));
    }
    session_.runs().set_playing(false);
    settle_anew();
    note(seed, before);
  }
  // What a drag has done is as if it had not been.
  void cancel_drag(const Scene& scene, unsigned seed) {
    const int count = edits().count();
    const std::size_t before = index();
    const int drag = ++drags_;
    test::RandomEdits random(scene, seed);
    const SceneEdits edits = random.any();
    session_.edit(edits, "drag", drag);
    session_.edit(edits, "drag", drag);
    if (index() == before && this->edits().count() == count) return;  // refused
    session_.cancel(drag);
    documents_.resize(before + 1);
    known_runs_.resize(before + 1);
    seeds_.resize(before);
    ASSERT_EQ(index(), before);
    ASSERT_FALSE(this->edits().canRedo());
  }
  // The document as a file, opened anew.
  void expect_reopens() {
    const std::string text = document();
    const Preset again = parse_preset(text, "again");
    validate(again);
    EXPECT_EQ(write_preset(again), text);
  }

 private:
  Session session_;
  std::vector<std::string> documents_;
  std::vector<std::map<std::int64_t, State>> known_runs_;  // by their steps
  std::vector<unsigned> seeds_;
  std::map<std::string, int> made_;
  std::string last_;
  int refused_ = 0;
  int drags_ = 0;
  int settled_ = 0;
  int compared_ = 0;
};

// Takes back all and makes it again, one by one; `each` follows.
template <class Each>
void go_through(EditedSession& edited, const Each& each) {
  const int index = edited.edits().index();
  const std::string last = edited.document();
  while (edited.edits().canUndo() && !testing::Test::HasFailure()) {
    edited.edits().undo();
    edited.expect_known();
    each();
  }
  EXPECT_EQ(edited.document(), EditedSession().document());
  while (edited.edits().index() < index && !testing::Test::HasFailure()) {
    edited.redo();
    edited.expect_known();
    each();
  }
  EXPECT_EQ(edited.document(), last);
}

void take_some_back(EditedSession& edited, std::size_t count) {
  for (; count > 0 && edited.edits().canUndo(); --count) edited.edits().undo();
}

void make_some_again(EditedSession& edited, std::size_t count) {
  for (; count > 0 && edited.edits().canRedo(); --count) edited.redo();
}

TEST(RandomEditsTest, AtTheStart) {
  const int edits = test::by_effort(200, 400, 10'000);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    EditedSession edited;
    for (int i = 0; i < edits && !testing::Test::HasFailure(); ++i) {
      SCOPED_TRACE("edit " + std::to_string(i));
      const std::size_t how = random() % 12;
      if (how < 2) {
        take_some_back(edited, random() % 4);
      } else if (how == 2) {
        make_some_again(edited, random() % 4);
      } else if (how == 3) {
        edited.cancel_drag(*scene_at_start(edited.session().document().scene), static_cast<unsigned>(random()));
      } else {
        edited.edit_start(static_cast<unsigned>(random()));
      }
      edited.expect_known();
      if (i % 10 == 0) edited.expect_reopens();
    }
    ASSERT_GT(edited.index(), 0U);
    const std::string last = edited.document();
    EditedSession fresh;
    for (const unsigned each : edited.seeds()) fresh.edit_start(each);
    EXPECT_EQ(fresh.document(), last) << "by the edits that were not taken back alone";
    go_through(edited, [] {});
    if (test::long_tests())
      for (const auto& [kind, count] : edited.made()) std::printf("%6d %s\n", count, kind.c_str());
  }
}

// Twelve of them, which run side by side: with the length of its run an edit costs ever more.
class RandomEditsOnTheWay : public testing::TestWithParam<unsigned> {};

TEST_P(RandomEditsOnTheWay, AreKnownAndComeBack) {
  const int edits = test::by_effort(5, 10, 850);
  std::mt19937 random(GetParam());
  EditedSession edited;
  edited.settle_anew();
  for (int i = 0; i < edits && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("edit " + std::to_string(i));
    LabRuns& runs = edited.session().runs();
    switch (random() % 12) {
      case 0:
        take_some_back(edited, random() % 4);
        break;
      case 1:
        make_some_again(edited, random() % 4);
        break;
      case 2:
        edited.cancel_drag(*runs.scene(), static_cast<unsigned>(random()));
        break;
      case 3:
      case 4:
        edited.edit_playing(static_cast<unsigned>(random()));
        break;
      case 5:
        edited.restart();
        break;
      case 6:
      case 7:
        runs.run_until(runs.frame()->time + 0.05 * static_cast<double>(1 + random() % 4));
        break;
      default:
        edited.edit_now(static_cast<unsigned>(random()));
    }
    edited.settle_anew();
    edited.expect_known();
    edited.expect_known_run();
    edited.expect_reopens();
  }
  go_through(edited, [&] {
    edited.settle();
    edited.expect_known_run();
  });
  EXPECT_GT(edited.compared(), 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomEditsOnTheWay, testing::Range(1U, 13U));

}  // namespace
}  // namespace carom
