#include <algorithm>

#include "app/library/preset_library.h"
#include "physics/preset/preset_file.h"
#include "tests/app/lab/hands_fixture.h"
#include "tests/support/scenes.h"
#include "widgets/plot/run_plot.h"

// Theories on the plots of one's own experiment are its author's: an edit of the scene marks them, and keeps
// them.
namespace carom {
namespace {

class LabTheoriesTest : public LabHandsTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(LabHandsTest::SetUp());
    QFile::copy(QString::fromStdString(find_preset("head-on").string()), mine_);
    ASSERT_TRUE(window_.open(mine_.toStdString()));
    ASSERT_TRUE(shows_start());
  }
  // What the legends say of theories.
  [[nodiscard]] std::string said() {
    QStringList all;
    for (const RunPlot* plot : panel().plots()) {
      for (const auto& [name, pen] : plot->legend()) {
        if (name.startsWith("theory")) all << name;
      }
    }
    return all.join("; ").toStdString();
  }
  [[nodiscard]] std::size_t theories(const Preset& preset) {
    std::size_t count = 0;
    for (const Plot& plot : preset.plots) {
      count += static_cast<std::size_t>(std::count_if(
          plot.y.begin(), plot.y.end(), [](const QuantityName& line) { return !line.theory.empty(); }));
    }
    return count;
  }
  // Whether a chip says this; its tip does so whole.
  [[nodiscard]] bool says(const QString& text) {
    const auto chips = window_.findChildren<QLabel*>("chip");
    return std::any_of(chips.begin(), chips.end(), [&text](const QLabel* chip) {
      return chip->isVisible() && chip->toolTip().contains(text);
    });
  }
  void give_mass(const QString& mass) {
    select(now("light").position);
    type("Mass, kg", mass);
  }
  [[nodiscard]] PlotPanel& panel() { return *window_.findChild<PlotPanel*>(); }

  const QString mine_ = folder_.filePath("mine.json");
  const std::string plain_ = "theory";
  const std::string marked_ = "theory of the first scene";
};

TEST_F(LabTheoriesTest, AnEditMarksThemAndUndoTakesTheMarkBack) {
  EXPECT_EQ(said(), plain_);
  give_mass("2 kg");
  EXPECT_EQ(said(), marked_);
  EXPECT_EQ(theories(window_.preset()), 2U) << "they stay in the document";
  give_mass("3 kg");
  EXPECT_EQ(said(), marked_);
  undo();
  EXPECT_EQ(said(), marked_);
  undo();
  EXPECT_EQ(said(), plain_);
  window_.session().edits().redo();
  EXPECT_EQ(said(), marked_);
}

TEST_F(LabTheoriesTest, TheFirstStartHasThemUnmarked) {
  window_.run_until(0.2);
  ASSERT_TRUE(wait_for([this] { return time() >= 0.2; }));
  Body body = window_.session().runs().scene()->bodies[0];
  body.position.y() += 0.5;
  window_.session().edit({Replace<Body>{body}}, "Move light");
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_EQ(said(), marked_);
  window_.session().starts().go_to_first();
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(said(), plain_);
  window_.session().starts().go_to(window_.session().starts().known().at(1));
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(said(), marked_);
}

TEST_F(LabTheoriesTest, ALaterStartOfAnExperimentHasThemMarked) {
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(shows_start());
  window_.run_until(0.2);
  ASSERT_TRUE(wait_for([this] { return time() >= 0.2; }));
  Body body = window_.session().runs().scene()->bodies[0];
  body.name = "small";
  body.position.y() += 0.5;
  window_.session().edit({Replace<Body>{body}}, "Move light");
  ASSERT_TRUE(wait_for([this] { return time() == 0.0; }));
  EXPECT_EQ(said(), marked_);
  window_.session().starts().go_to_first();
  EXPECT_EQ(said(), plain_);
  window_.session().starts().go_to(window_.session().starts().known().at(1));
  EXPECT_EQ(said(), marked_);
  EXPECT_EQ(theories(window_.preset()), 0U);
  undo();
  EXPECT_EQ(said(), plain_);
}

// The runs go on with one body more.
TEST_F(LabTheoriesTest, ADiscDroppedIntoARunMarksThem) {
  for (const std::string& opened : {mine_.toStdString(), std::string("head-on")}) {
    SCOPED_TRACE(opened);
    ASSERT_TRUE(window_.open(opened));
    ASSERT_TRUE(shows_start());
    window_.run_until(0.2);
    ASSERT_TRUE(wait_for([this] { return time() >= 0.2; }));
    EXPECT_EQ(said(), plain_);
    window_.session().add_body(0.3, 1.0);
    EXPECT_EQ(said(), marked_);
    undo();
    EXPECT_EQ(said(), plain_);
    window_.session().edits().setClean();
  }
}

TEST_F(LabTheoriesTest, AnotherTimeOfADiscThatComesLaterMarksThem) {
  Preset with = read_preset(mine_.toStdString());
  with.edits = {{0.5, 0, SceneEdits{Add<Body>{test::disc("late", {0.3, 1.0}, {0.0, 0.0})}}}};
  save_preset(with, mine_.toStdString());
  ASSERT_TRUE(window_.open(mine_.toStdString()));
  ASSERT_TRUE(shows_start());
  EXPECT_EQ(said(), plain_);
  EditHistory& history = window_.session().history();
  std::vector<RunEdit> later = window_.preset().edits;
  later.at(0).time += 0.4;
  history.push({.text = "Later"}, change_of_late_bodies(history.document(), later));
  EXPECT_EQ(said(), marked_);
  undo();
  EXPECT_EQ(said(), plain_);
}

// It is for the scene as it is then.
TEST_F(LabTheoriesTest, ATheoryThatIsTypedAfterTheEditHasNoMark) {
  give_mass("2 kg");
  ASSERT_EQ(said(), marked_);
  Plot plot = panel().plots().front()->content().plot;
  plot.y[0].theory = "1 + t";
  panel().replace(panel().plots().front(), plot);
  EXPECT_EQ(said(), "theory, partly of the first scene");
  plot.y[1].theory = "2 + t";
  panel().replace(panel().plots().front(), plot);
  EXPECT_EQ(said(), plain_);
  give_mass("3 kg");
  EXPECT_EQ(said(), marked_);
  undo();
  EXPECT_EQ(said(), plain_);
}

TEST_F(LabTheoriesTest, AResidualIsMarkedInItsTitle) {
  Plot plot = panel().plots().front()->content().plot;
  plot.y.resize(1);
  plot.y[0].residual = true;
  panel().replace(panel().plots().front(), plot);
  const auto title = [this] { return panel().plots().front()->content().title.toStdString(); };
  EXPECT_EQ(title(), "x of light − theory");
  give_mass("2 kg");
  EXPECT_EQ(title(), "x of light − theory of the first scene");
  undo();
  EXPECT_EQ(title(), "x of light − theory");
}

TEST_F(LabTheoriesTest, AnotherNameOfABodyIsFollowed) {
  give_mass("2 kg");
  Body body = window_.preset().scene.bodies[0];
  body.name = "small";
  window_.session().edit({Replace<Body>{body}}, "Rename");
  EXPECT_EQ(said(), marked_);
  EXPECT_EQ(window_.preset().plots[0].y[0].bodies[0], "small");
}

// Saved is what its author wrote; the one line says that it's not of this scene.
TEST_F(LabTheoriesTest, SavingKeepsThemAndSaysWhoseTheyAre) {
  ASSERT_TRUE(window_.save());
  EXPECT_TRUE(says("saved as mine.json"));
  EXPECT_FALSE(says("first scene"));
  give_mass("2 kg");
  ASSERT_TRUE(window_.save());
  EXPECT_TRUE(says("saved as mine.json; its theories are those of the first scene"));
  EXPECT_EQ(theories(read_preset(mine_.toStdString())), 2U);
  EXPECT_EQ(said(), marked_);
}

// Those of a built-in experiment belong to it alone.
TEST_F(LabTheoriesTest, SavingAnEditedExperimentSaysThatItsTheoriesAreNotInTheFile) {
  ASSERT_TRUE(window_.open("head-on"));
  ASSERT_TRUE(shows_start());
  give_mass("2 kg");
  ASSERT_EQ(said(), marked_);
  chosen_file_ = folder_.filePath("lesson.json");
  action("Save")->trigger();
  EXPECT_TRUE(
      wait_for([this] { return says("saved as lesson.json, without the theories of the first scene"); }));
  EXPECT_EQ(theories(read_preset(folder_.filePath("lesson.json").toStdString())), 0U);
}

}  // namespace
}  // namespace carom
