#include "widgets/plot/legend_row.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "widgets/plot/legend_button.h"

namespace carom {
namespace {

class LegendRowTest : public testing::Test {
 protected:
  void fill(int curves) {
    for (int i = 0; i < curves; ++i) {
      buttons.push_back(new LegendButton(QString("curve & %1").arg(i)));
      row.add(buttons.back());
    }
    row.resize(400, row.sizeHint().height());
    row.show();
    QApplication::processEvents();
  }
  [[nodiscard]] int shown() const {
    return static_cast<int>(
        std::count_if(buttons.begin(), buttons.end(), [](const auto* b) { return b->isVisible(); }));
  }
  [[nodiscard]] QToolButton* more() const {
    for (auto* b : row.findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly)) {
      if (b->menu() != nullptr) return b;
    }
    return nullptr;
  }
  LegendRow row;
  std::vector<LegendButton*> buttons;
};

TEST_F(LegendRowTest, FewCurvesHaveTheirWholeNames) {
  fill(3);
  EXPECT_EQ(shown(), 3);
  EXPECT_FALSE(more()->isVisible());
  for (const LegendButton* b : buttons) EXPECT_EQ(b->width(), b->sizeHint().width());
}

TEST_F(LegendRowTest, NamesOfAnyLengthAreWholeWhereTheRowHasRoomForThem) {
  for (const char* name : {"kinetic", "a name that is far longer than the others", "total"}) {
    buttons.push_back(new LegendButton(name));
    row.add(buttons.back());
  }
  row.resize(row.sizeHint());
  row.show();
  QApplication::processEvents();
  for (const LegendButton* b : buttons) EXPECT_EQ(b->width(), b->sizeHint().width()) << b->text().toStdString();
}

// The legend of Energy with a theory and the run before, beside the title of a plot 300 px wide.
TEST_F(LegendRowTest, NarrowPlotsHaveWholeNamesInMoreLines) {
  for (const char* name : {"kinetic", "potential", "total", "theory", "run before"}) {
    buttons.push_back(new LegendButton(name));
    buttons.back()->set_look(QPen(), QColor());
    row.add(buttons.back());
  }
  row.resize(300 - 20 - 80, row.sizeHint().height());
  row.show();
  QApplication::processEvents();
  EXPECT_EQ(shown(), 5);
  EXPECT_FALSE(more()->isVisible());
  row.resize(row.width(), row.sizeHint().height());
  QApplication::processEvents();
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    const LegendButton& b = *buttons[i];
    EXPECT_EQ(b.width(), b.sizeHint().width()) << b.text().toStdString();
    EXPECT_TRUE(row.rect().contains(b.geometry())) << b.text().toStdString();
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(b.geometry().intersects(buttons[k]->geometry()));
  }
  row.resize(600, row.height());
  QApplication::processEvents();
  EXPECT_EQ(row.sizeHint().height(), buttons.front()->height()) << "one line where there is room";
}

TEST_F(LegendRowTest, ManyCurvesKeepTheRowNarrow) {
  fill(100);
  EXPECT_LE(row.minimumSizeHint().width(), LegendRow::kLeastWidth);
  EXPECT_GT(shown(), 2);
  EXPECT_LT(shown(), 20);
  ASSERT_TRUE(more()->isVisible());
  EXPECT_EQ(more()->text(), QString("+ %1 more ▾").arg(100 - shown()));
  for (const LegendButton* b : buttons) {
    if (b->isVisible() && b->y() == more()->y()) {
      EXPECT_LT(b->geometry().right(), more()->geometry().left());
    }
  }
  EXPECT_LE(more()->geometry().right(), row.width());

  // The menu hides and shows the curves without room.
  emit more()->menu()->aboutToShow();
  ASSERT_EQ(more()->menu()->actions().size(), 100 - shown());
  QAction* last = more()->menu()->actions().back();
  EXPECT_EQ(last->text(), "curve && 99");
  last->trigger();
  EXPECT_FALSE(buttons.back()->isChecked());

  row.resize(40, row.height());
  QApplication::processEvents();
  EXPECT_EQ(shown(), 0);
  row.resize(20'000, row.height());
  QApplication::processEvents();
  EXPECT_EQ(shown(), 100);
  EXPECT_FALSE(more()->isVisible());
}

}  // namespace
}  // namespace carom
