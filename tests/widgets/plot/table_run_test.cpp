#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QScrollBar>
#include <QTest>
#include <gtest/gtest.h>

#include "physics/preset/preset.h"
#include "tests/support/run_fixture.h"
#include "widgets/run/before_after.h"
#include "widgets/run/impacts_table.h"
#include "widgets/theme/theme.h"

namespace carom {
namespace {

QString cell(const QTableView& table, int row, int column) {
  return table.model()->index(row, column).data().toString();
}

TEST(RunTables, BodiesBeforeAndAfterAHeadOnCollision) {
  const Preset preset = head_on_scene();
  BeforeAfterTable table;
  table.show_pair(since_start(preset.scene.bodies, run_to(preset, 0.5)));
  ASSERT_EQ(table.model()->rowCount(), 3);
  const QStringList expected[] = {
      {"A", "1.000", "3.00, 0.00", "−1.00, 0.00", "3.00, 0.00", "−1.00, 0.00", "4.500", "0.5000"},
      {"B", "2.000", "0, 0", "2.00, 0.00", "0, 0", "4.00, 0.00", "0", "4.000"},
      {"sum", "3.000", "", "", "3.00, 0.00", "3.00, 0.00", "4.500", "4.500"}};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 8; ++column) {
      EXPECT_EQ(cell(table, row, column), expected[row][column]) << row << ", " << column;
    }
  }
  EXPECT_TRUE(table.model()->index(2, 0).data(Qt::FontRole).value<QFont>().bold());
}

TEST(RunTables, AreCopiedWithEveryDigit) {
  const Preset preset = head_on_scene();
  const Frame frame = run_to(preset, 0.5);
  BeforeAfterTable table;
  table.show_pair(since_start(preset.scene.bodies, frame));
  table.show();
  QTest::keySequence(&table, QKeySequence::Copy);
  const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
  ASSERT_EQ(lines.size(), 1 + 3 + 1) << "each with its end";
  EXPECT_EQ(lines[0],
            "body\tm / kg\tv before / m/s, x\tv before / m/s, y\tv after / m/s, x\tv after / m/s, y\t"
            "p before / kg m/s, x\tp before / kg m/s, y\tp after / kg m/s, x\tp after / kg m/s, y\t"
            "K before / J\tK after / J");
  const QStringList a = lines[1].split('\t');
  ASSERT_EQ(a.size(), 12);
  EXPECT_EQ(a[4].toDouble(), frame.state.v(0, 0));
  EXPECT_EQ(lines[3].split('\t').size(), 12) << "the sums";
  EXPECT_EQ(lines[3].split('\t')[2], "");
}

TEST(RunTables, AreCsvWithQuotesWhereCommasNeedThem) {
  const Preset preset = head_on_scene();
  BeforeAfterTable table;
  table.show_pair(since_start(preset.scene.bodies, run_to(preset, 0.5)));
  const QStringList lines = table.csv().split('\n');
  EXPECT_TRUE(lines[0].startsWith("body,m / kg,\"v before / m/s, x\",\"v before / m/s, y\","))
      << lines[0].toStdString();
  EXPECT_TRUE(lines[1].startsWith("A,1,3,0,-1,0,")) << lines[1].toStdString();
}

TEST(RunTables, ABodyAddedLaterHasNoBefore) {
  const Preset preset = head_on_scene();
  BeforeAfterTable table;
  table.show_pair(since_start({preset.scene.bodies.front()}, run_to(preset, 0.1)));
  EXPECT_EQ(cell(table, 0, 2), "3.00, 0.00");
  EXPECT_EQ(cell(table, 1, 2), "");
  EXPECT_EQ(cell(table, 2, 4), "3.00, 0.00");
  EXPECT_EQ(cell(table, 2, 6), "4.500");
}

TEST(RunTables, ImpactsNewestFirst) {
  const Frame frame = run_to(head_on_scene(), 0.5);
  Recorder recorder;
  recorder.add(frame);
  ImpactsTable table;
  table.update_from(frame, frame.time, recorder);
  ASSERT_EQ(table.model()->rowCount(), 1);
  const QStringList expected = {"1", "0.200000", "A – B", "3.000", "4.000", "0"};
  for (int column = 0; column < expected.size(); ++column) EXPECT_EQ(cell(table, 0, column), expected[column]);

  Frame many = frame;
  many.impacts.assign(700, frame.impacts.front());
  many.impacts.back().closing_speed = 7.0;
  many.impact_count = 701;
  many.playing = true;
  recorder.add(many);
  table.update_from(many, many.time, recorder);
  ASSERT_EQ(table.model()->rowCount(), ImpactsTable::kMostWhilePlaying);
  EXPECT_EQ(cell(table, 0, 0), "701");
  EXPECT_EQ(cell(table, 0, 3), "7.000");
  EXPECT_EQ(cell(table, 499, 0), "202");
  many.playing = false;
  table.update_from(many, many.time, recorder);
  EXPECT_EQ(table.model()->rowCount(), 701) << "all of a run that stands still";

  Frame restarted = frame;
  restarted.run = 2;
  restarted.impact_count = 0;
  restarted.impacts.clear();
  recorder.add(restarted);
  table.update_from(restarted, restarted.time, recorder);
  EXPECT_EQ(table.model()->rowCount(), 0);
}

// A driven body has no momentum of its own.
TEST(RunTables, SumsAreOfTheBodiesThatMoveFreely) {
  const Preset preset = head_on_scene();
  Frame frame = run_to(preset, 0.1);
  std::vector<Body> bodies = *frame.bodies;
  bodies[0].drive = Drive{.velocity = Vec2(3.0, 0.0)};
  frame.bodies = std::make_shared<const std::vector<Body>>(bodies);
  BeforeAfterTable table;
  table.show_pair(since_start(bodies, frame));
  ASSERT_EQ(table.model()->rowCount(), 2);
  EXPECT_EQ(cell(table, 0, 0), "B");
  EXPECT_EQ(cell(table, 1, 1), "2.000");
}

TEST(RunTables, ColumnsShareTheWidth) {
  const Preset preset = head_on_scene();
  BeforeAfterTable table;
  table.resize(740, 200);
  table.show_pair(since_start(preset.scene.bodies, run_to(preset, 0.5)));
  table.show();
  QApplication::processEvents();
  EXPECT_EQ(table.horizontalHeader()->length(), table.viewport()->width());
  constexpr int kRoom = 96;  // px, that the drawer of a window of 1280 by 800 leaves
  EXPECT_LE(table.horizontalHeader()->height() + 3 * table.rowHeight(0), kRoom);
  EXPECT_GE(table.rowHeight(0), 20) << "to be read";
  EXPECT_FALSE(table.verticalHeader()->isVisible());
}

}  // namespace
}  // namespace carom
