#include "widgets/run/impacts_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <gtest/gtest.h>

#include "tests/support/run_fixture.h"
#include "widgets/base/plain_text.h"

namespace carom {
namespace {

// Four impacts of "light", "heavy" and a floor.
class ImpactsPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    std::vector<Body> bodies = {disc("light", {0.0, 0.0}, {0.0, 0.0}, 1.0),
                                disc("heavy", {1.0, 0.0}, {0.0, 0.0}, 2.0),
                                disc("floor", {0.0, -1.0}, {0.0, 0.0}, 1.0)};
    bodies[2].fixed = true;
    frame_ = run_to(head_on_scene(), 0.1);
    frame_.bodies = std::make_shared<const std::vector<Body>>(bodies);
    add(0.5, 0, 1, 3.0, 0.2);
    add(1.0, 0, 2, 1.0, 0.05);
    add(1.5, 1, 2, 2.0, 0.3);
    add(2.5, 0, 1, 2.0, 0.0);
    frame_.impact_count = 4;
    frame_.time = 3.0;
    recorder_.add(frame_);
    panel_.resize(700, 300);
    panel_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel_));
    QObject::connect(&panel_, &ImpactsPanel::filterChanged, [this] { update(); });
    update();
  }
  void add(double time, int a, int b, double impulse, double lost) {
    ImpactRecord impact;
    impact.time = time;
    impact.a = BodyIndex{a};
    impact.b = BodyIndex{b};
    impact.normal_impulse = impulse;
    impact.lost_to_friction = lost;
    frame_.impacts.push_back(impact);
  }
  void update() { panel_.update_from(frame_, frame_.time, recorder_); }
  void type(const QString& text) { panel_.findChild<QLineEdit*>()->setText(text); }
  // The numbers of the shown ones, in their order.
  QString shown() {
    QStringList numbers;
    for (int row = 0; row < panel_.table().model()->rowCount(); ++row)
      numbers << panel_.table().model()->index(row, 0).data().toString();
    return numbers.join(' ');
  }
  QString said() { return panel_.findChild<PlainLabel*>()->text(); }
  void click_head(int column) {
    QHeaderView* heads = panel_.table().horizontalHeader();
    const QPoint at(heads->sectionViewportPosition(column) + 20, heads->height() / 2);
    QTest::mouseClick(heads->viewport(), Qt::LeftButton, {}, at);
  }

  Frame frame_;
  Recorder recorder_;
  ImpactsPanel panel_;
};

TEST_F(ImpactsPanelTest, OfVeryManyItSaysWhichAreKept) {
  frame_.impacts.clear();
  for (std::size_t i = 0; i < Recorder::kMostImpacts; ++i)
    add(4.0 + 1e-5 * static_cast<double>(i), 1, 2, 2.0, 0.3);
  frame_.impact_count += static_cast<std::int64_t>(Recorder::kMostImpacts);
  frame_.time = 5.0;
  recorder_.add(frame_);
  type("light");
  EXPECT_EQ(said(), "0 of 100004 shown; only the newest 100000 are kept, from 4.000 s on");
}

TEST_F(ImpactsPanelTest, TermsOfTheFilter) {
  EXPECT_EQ(shown(), "4 3 2 1");
  EXPECT_EQ(said(), "4 of 4 shown");
  const std::vector<std::pair<QString, QString>> cases = {
      {"light", "4 2 1"},
      {"LIG", "4 2 1"},
      {"wall", "3 2"},
      {"light wall", "2"},
      {"loss > 0.1", "3 1"},
      {"loss>0.1 t<1", "1"},
      {"t < 2 s, heavy", "3 1"},
      {"loss > 0,1", "3 1"},
      {"t >= 1", "4 3 2"},
      {"t ≤ 1", "2 1"},
      {"jn = 2", "4 3"},
      {"# > 2", "4 3"},
      {"loss > 0.1 J", "3 1"},
      {"\"light\",\"floor\"", "2"},
      {"t > 9", ""},
      {"", "4 3 2 1"},
  };
  for (const auto& [text, numbers] : cases) {
    type(text);
    EXPECT_EQ(shown(), numbers) << text.toStdString();
    EXPECT_TRUE(said().endsWith(" of 4 shown")) << text.toStdString() << ": " << said().toStdString();
  }
}

TEST_F(ImpactsPanelTest, SaysWhatItDoesNotUnderstand) {
  type("light");
  const std::vector<std::pair<QString, QString>> cases = {
      {"feather", "no body is called \"feather\""},
      {"loss > much", "after \"loss >\" comes a number"},
      {"loss >", "after \"loss >\" comes a number"},
      {"loss", "after \"loss\" comes < or > and a number"},
      {"speed > 1", "\"speed\" is none of #, t, closing, jn, jt, loss"},
      {"> 1", "before \">\" comes #, t, closing, jn, jt or loss"},
  };
  for (const auto& [text, fault] : cases) {
    type("light");
    type(text);
    EXPECT_EQ(said(), fault) << text.toStdString();
    EXPECT_EQ(shown(), "4 2 1") << "the last good one holds";
    EXPECT_TRUE(panel_.findChild<QLineEdit*>()->property("fault").toBool());
  }
  type("light");
  EXPECT_EQ(said(), "3 of 4 shown");
  EXPECT_FALSE(panel_.findChild<QLineEdit*>()->property("fault").toBool());
}

TEST_F(ImpactsPanelTest, AHeadSortsAndWhatIsCopiedHasThatOrder) {
  click_head(6);
  EXPECT_EQ(shown(), "4 2 1 3") << "the least loss first";
  click_head(6);
  EXPECT_EQ(shown(), "3 1 2 4");
  click_head(4);
  EXPECT_EQ(shown(), "2 4 3 1") << "of equal ones the newest first";
  click_head(2);
  EXPECT_EQ(shown(), "3 2 4 1") << "by names";
  click_head(6);
  type("light");
  EXPECT_EQ(shown(), "4 2 1") << "a filter keeps the order";
  const QStringList lines = panel_.table().csv().split('\n');
  ASSERT_EQ(lines.size(), 5);
  EXPECT_EQ(lines[1], "4,2.5,light – heavy,0,2,0,0");
  EXPECT_EQ(lines[2], "2,1,light – floor,0,1,0,0.05");
}

TEST_F(ImpactsPanelTest, AClickGoesToTheMomentOfTheSortedRow) {
  std::vector<double> chosen;
  QObject::connect(&panel_.table(), &ImpactsTable::impactChosen, [&](double time) { chosen.push_back(time); });
  click_head(6);
  const QPoint at = panel_.table().visualRect(panel_.table().model()->index(3, 1)).center();
  QTest::mouseClick(panel_.table().viewport(), Qt::LeftButton, {}, at);
  EXPECT_EQ(chosen, std::vector{1.5});
}

}  // namespace
}  // namespace carom
