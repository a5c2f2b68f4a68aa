#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <gtest/gtest.h>

#include "physics/record/replay.h"
#include "tests/support/scenes.h"
#include "widgets/run/before_after_panel.h"

namespace carom {
namespace {

using test::disc;
using Choice = BeforeAfterPanel::Choice;

// A run up to `time`, as the window gets it.
struct ShownRun {
  explicit ShownRun(const Scene& scene, double time) : start(scene.bodies) {
    RunSetup setup;
    setup.scene = scene;
    setup.method.step = 0.01;
    Simulation run(setup);
    run.watch_impacts(true);
    while (run.time() < time - 1e-9) {
      run.step();
      const std::vector<ImpactRecord>& news = run.last_impacts();
      frame.impacts.insert(frame.impacts.end(), news.begin(), news.end());
      if (!news.empty()) frame.jumps = jump_moments(run);
    }
    take_moment(run, frame);
    frame.run = 1;
    recorder.add(frame);
  }
  void show(BeforeAfterPanel& panel, const std::optional<double>& picked = std::nullopt) const {
    panel.update_from({frame, frame, recorder, start, picked});
  }
  // An earlier moment, which is no impact's.
  void show_earlier(BeforeAfterPanel& panel) const {
    Frame earlier = frame;
    earlier.time -= 0.1;
    earlier.jumps.clear();
    panel.update_from({earlier, frame, recorder, start});
  }
  void show_marked(BeforeAfterPanel& panel, std::optional<double> a, std::optional<double> b,
                   const std::shared_ptr<const RunInterval>& marked = nullptr) const {
    panel.update_from({frame, frame, recorder, start, {}, a, b, marked});
  }

  std::vector<Body> start;
  Frame frame;
  Recorder recorder;
};

Scene head_on() {
  return test::scene_with(
      {disc("light", {-0.6, 0.0}, {2.0, 0.0}), disc("heavy", {0.6, 0.0}, {-1.0, 0.0}, 0.1, 2.5),
       disc("far", {0.0, 5.0}, {1.0, 0.0})},
      0.8);
}

QStringList row_of(const BeforeAfterPanel& panel, int row) {
  const QAbstractItemModel* model = panel.findChild<BeforeAfterTable*>()->model();
  QStringList cells;
  for (int column = 0; column < model->columnCount(); ++column)
    cells << model->index(row, column).data().toString();
  return cells;
}

QStringList heads_of(const BeforeAfterPanel& panel) {
  const QAbstractItemModel* model = panel.findChild<BeforeAfterTable*>()->model();
  QStringList heads;
  for (int column = 0; column < model->columnCount(); ++column)
    heads << model->headerData(column, Qt::Horizontal).toString();
  return heads;
}

QString tip_of(const BeforeAfterPanel& panel, int row, int column) {
  return panel.findChild<BeforeAfterTable*>()->model()->index(row, column).data(Qt::ToolTipRole).toString();
}

int rows_of(const BeforeAfterPanel& panel) { return panel.findChild<BeforeAfterTable*>()->model()->rowCount(); }

TEST(BeforeAfter, TheImpactAtTheShownMomentBesideTheory) {
  const ShownRun run(head_on(), 0.34);
  BeforeAfterPanel panel;
  run.show(panel);
  ASSERT_EQ(rows_of(panel), 3) << "the two that took part, and their sum";
  // p = -0.5 N s; v = (p - 0.8 · 2.5 · 3) / 3.5 and (p + 0.8 · 3) / 3.5.
  EXPECT_EQ(row_of(panel, 0), (QStringList{"light", "1.000", "2.00, 0.00", "−1.86, 0.00", "−1.86, 0.00",
                                           "< 1e−12", "2.00, 0.00", "−1.86, 0.00", "2.000", "1.724"}));
  EXPECT_EQ(row_of(panel, 1), (QStringList{"heavy", "2.500", "−1.00, 0.00", "0.543, 0.000", "0.543, 0.000",
                                           "< 1e−12", "−2.50, 0.00", "1.36, 0.00", "1.250", "0.3684"}));
  EXPECT_EQ(row_of(panel, 2)[6], "−0.500, 0.000");
  EXPECT_EQ(row_of(panel, 2)[7], "−0.500, 0.000");
  EXPECT_EQ(row_of(panel, 2)[8], "3.250");
}

TEST(BeforeAfter, TheLastImpactStaysAndThisOneGoesWithTheMoment) {
  const ShownRun run(head_on(), 0.6);
  BeforeAfterPanel panel;
  run.show(panel);
  EXPECT_EQ(rows_of(panel), 3) << "at the newest moment the last one";
  run.show_earlier(panel);
  EXPECT_EQ(rows_of(panel), 0) << "there is none at this moment";
  panel.choose(Choice::kLast);
  run.show(panel);
  EXPECT_EQ(rows_of(panel), 3);
  panel.choose(Choice::kStart);
  run.show(panel);
  EXPECT_EQ(rows_of(panel), 4) << "all bodies";
  EXPECT_EQ(row_of(panel, 0).size(), 10) << "of an interval there is no law";
}

TEST(BeforeAfter, SpinsHaveColumnsWhereSomethingTurns) {
  Scene scene = test::scene_with(
      {disc("ball", {0.0, 0.3}, {6.0, -2.0}), test::wall("floor", {0.0, -0.5}, 20.0, 1.0)}, 0.5, 0.3);
  const ShownRun run(scene, 0.1);
  BeforeAfterPanel panel;
  run.show(panel);
  ASSERT_EQ(rows_of(panel), 2) << "the floor does not move";
  const QStringList ball = row_of(panel, 0);
  ASSERT_EQ(ball.size(), 16);
  // j_t = -0.3 · 1.5 · 2 N s at the radius of 0.1 m, about I = 0.005 kg m².
  EXPECT_EQ(ball.mid(2, 8), (QStringList{"6.00, −2.00", "5.10, 1.00", "5.10, 1.00", "< 1e−12", "0", "−18.00",
                                         "−18.00", "< 1e−12"}));
}

TEST(BeforeAfter, TheErrorIsAShareOfTheLargestSpeed) {
  const ShownRun run(head_on(), 0.34);
  BeforeAfter compared = before_and_after(*run.frame.jumps.front());
  compared.theory->v(0, 0) += 0.003;
  BeforeAfterTable table;
  table.show_pair(compared);
  EXPECT_EQ(table.model()->index(0, 5).data().toString(), "1.5e−3") << "of 2 m/s";
  EXPECT_EQ(table.model()->index(1, 5).data().toString(), "< 1e−12");
}

TEST(BeforeAfter, ASumThatCancelsIsZero) {
  std::vector<Body> bodies = {disc("A", {1.0, 0.0}, {0.5, 0.3}, 0.1, 0.1),
                              disc("B", {1.0, 0.0}, {0.5, 0.1}, 0.1, 0.2),
                              disc("C", {1.0, 0.0}, {0.5, -1.0 / 6.0}, 0.1, 0.3)};
  ASSERT_NE(0.1 * 0.3 + 0.2 * 0.1 + 0.3 * (-1.0 / 6.0), 0.0) << "by rounding";
  Frame frame;
  frame.bodies = std::make_shared<const std::vector<Body>>(bodies);
  frame.state = initial_state(bodies);
  BeforeAfterTable table;
  table.show_pair(since_start(bodies, frame));
  const QAbstractItemModel& model = *table.model();
  ASSERT_EQ(model.headerData(7, Qt::Horizontal).toString().section('\n', 0, 0), "L after");
  EXPECT_EQ(model.index(3, 7).data().toString(), "0");
}

TEST(BeforeAfter, SaysWhyThereIsNoTheory) {
  Scene scene = test::scene_with({disc("a", {-0.49, 0.0}, {2.0, 0.0}), disc("b", {0.5, 0.0}, {0.0, 0.0}),
                                  disc("c", {0.5, 0.6}, {0.0, 0.0})});
  Joint rod;
  rod.body = "b";
  rod.to = "c";
  scene.joints.push_back(rod);
  const ShownRun run(scene, 0.4);
  BeforeAfterPanel panel;
  run.show(panel);
  ASSERT_GE(rows_of(panel), 3);
  EXPECT_EQ(row_of(panel, 0)[3], "—");
  EXPECT_TRUE(tip_of(panel, 0, 3).contains("joint")) << tip_of(panel, 0, 3).toStdString();
}

TEST(BeforeAfter, OfSeveralImpactsOfAStepThePickedOne) {
  const Scene scene =
      test::scene_with({disc("a", {-0.5, 0.0}, {1.0, 0.0}), disc("b", {0.002, 0.0}, {0.0, 0.0}),
                        disc("c", {-0.5, 2.0}, {1.0, 0.0}), disc("d", {0.006, 2.0}, {0.0, 0.0})});
  const ShownRun run(scene, 0.31);
  ASSERT_EQ(run.frame.jumps.size(), 2U);
  BeforeAfterPanel panel;
  run.show(panel, run.frame.jumps.front()->time());
  EXPECT_EQ(row_of(panel, 0)[0], "a");
  run.show(panel, run.frame.jumps.back()->time());
  EXPECT_EQ(row_of(panel, 0)[0], "c");
  run.show(panel);
  EXPECT_EQ(row_of(panel, 0)[0], "c") << "without a choice the last one";
}

std::shared_ptr<const RunInterval> interval_of(const Scene& scene, double from, double to) {
  RunSetup setup;
  setup.scene = scene;
  setup.method.step = 0.01;
  return std::make_shared<const RunInterval>(run_interval(setup, {}, from, to, [] { return true; }).value());
}

QString head_of(const BeforeAfterPanel& panel) {
  for (const QLabel* label : panel.findChildren<QLabel*>()) {
    if (label->accessibleName() == "What is compared") return label->text();
  }
  return {};
}

TEST(BeforeAfter, FromAToBWithTheLawsThatHoldForIt) {
  const ShownRun run(head_on(), 0.8);
  BeforeAfterPanel panel;
  panel.choose(Choice::kMarked);
  run.show_marked(panel, 0.7, 0.1, interval_of(head_on(), 0.1, 0.7));
  ASSERT_EQ(rows_of(panel), 3 + 1 + 2) << "all bodies, their sum, its theory and its error";
  EXPECT_EQ(head_of(panel), "B, t = 0.100 s, to A, t = 0.700 s");
  // Its angular momentum gives L a column: body, m, v before, theory, v after, error, p, p, L, L, K, K.
  ASSERT_EQ(row_of(panel, 0).size(), 12);
  EXPECT_EQ(row_of(panel, 0).mid(2, 4), (QStringList{"2.00, 0.00", "—", "−1.86, 0.00", "—"}));
  EXPECT_TRUE(tip_of(panel, 0, 3).contains("touched another body"));
  EXPECT_EQ(row_of(panel, 2).mid(2, 4), (QStringList{"1.00, 0.00", "1.00, 0.00", "1.00, 0.00", "< 1e−12"}));
  EXPECT_EQ(row_of(panel, 3).mid(6),
            (QStringList{"0.500, 0.000", "0.500, 0.000", "−5.000", "−5.000", "3.750", "2.593"}));
  EXPECT_EQ(row_of(panel, 4),
            (QStringList{"theory", "", "", "", "", "", "", "0.500, 0.000", "", "−5.000", "", "—"}));
  EXPECT_EQ(row_of(panel, 5).mid(7), (QStringList{"< 1e−12", "", "< 1e−12", "", "—"}));
  EXPECT_TRUE(tip_of(panel, 4, 11).contains("e below 1"));
}

TEST(BeforeAfter, SaysWhatIsMissingForTheMarks) {
  const ShownRun run(head_on(), 0.8);
  BeforeAfterPanel panel;
  panel.choose(Choice::kMarked);
  run.show_marked(panel, std::nullopt, 0.2);
  EXPECT_TRUE(head_of(panel).startsWith("no mark A yet: click in a plot"));
  run.show_marked(panel, 0.2, std::nullopt);
  EXPECT_TRUE(head_of(panel).startsWith("no mark B yet: Shift and click in a plot"));
  run.show_marked(panel, 0.2, 3.0);
  EXPECT_TRUE(head_of(panel).contains("after the run so far"));
  EXPECT_EQ(rows_of(panel), 0);
}

TEST(BeforeAfter, NoFigureIsCutAndAPlaneImpactFitsADrawer) {
  const ShownRun run(head_on(), 0.34);
  BeforeAfterTable table;
  table.show_pair(before_and_after(*run.frame.jumps.front()));
  table.show();
  for (const int width : {400, 720, 860, 1400}) {
    table.resize(width, 200);
    QCoreApplication::processEvents();
    const QHeaderView& heads = *table.horizontalHeader();
    for (int column = 1; column < table.model()->columnCount(); ++column) {
      EXPECT_GE(heads.sectionSize(column), heads.sectionSizeHint(column)) << width << " " << column;
      for (int row = 0; row < table.model()->rowCount(); ++row) {
        const QModelIndex cell = table.model()->index(row, column);
        EXPECT_GE(heads.sectionSize(column), table.itemDelegate()->sizeHint({}, cell).width());
      }
    }
    EXPECT_TRUE(width < 860 || heads.length() == table.viewport()->width());
  }
}

TEST(BeforeAfter, RoundingBesideTheFastestIsNothing) {
  Scene scene = head_on();
  scene.bodies[0].velocity.y() = 4.3e-50;
  scene.bodies[1].spin = 6.8e-49;
  const ShownRun run(scene, 0.34);
  BeforeAfterPanel panel;
  run.show(panel);
  for (int row : {0, 1}) {
    for (const QString& cell : row_of(panel, row)) EXPECT_FALSE(cell.contains("e−4")) << cell.toStdString();
  }
  for (const QString& head : heads_of(panel)) EXPECT_FALSE(head.startsWith("ω")) << "nothing turns";
}

}  // namespace
}  // namespace carom
