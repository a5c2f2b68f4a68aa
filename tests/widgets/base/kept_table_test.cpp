#include "widgets/base/kept_table.h"

#include <QApplication>
#include <QHeaderView>
#include <QScrollBar>
#include <QTest>
#include <gtest/gtest.h>

#include "widgets/base/figure_table.h"

namespace carom {
namespace {

constexpr int kBodies = 30;

// Names, six columns of figures, and a sum in the last row.
class Sums : public FigureModel {
 public:
  Sums()
      : FigureModel({{"name", 60, true}, {"a", 60}, {"b", 60}, {"c", 60}, {"d", 60}, {"e", 60}, {"f", 60}},
                    nullptr) {}
  void fill(int bodies) {
    bodies_ = bodies;
    rows_changed(bodies + 1);
  }
  [[nodiscard]] Cell cell(int row, int column) const override {
    return column == 0 ? Cell(QString("row %1").arg(row)) : Cell(-0.01234);
  }
  [[nodiscard]] bool is_sum(int row) const override { return row == bodies_; }

 private:
  int bodies_ = 0;
};

class KeptTableTest : public testing::Test {
 protected:
  KeptTableTest() {
    rows->fill(kBodies);
    table.resize(260, 190);
    table.show();
    QApplication::processEvents();
  }
  [[nodiscard]] QRect place(int row, int column) const {
    return table.visualRect(table.model()->index(row, column));
  }
  [[nodiscard]] int down() const { return table.viewport()->height(); }
  void scroll(int x, int y) {
    table.horizontalScrollBar()->setValue(x);
    table.verticalScrollBar()->setValue(y);
    QApplication::processEvents();
  }

  Sums* rows = new Sums;
  FigureTable table{rows, "rows", nullptr};
};

TEST_F(KeptTableTest, NamesAndSumsStayWhereTheRestScrolls) {
  ASSERT_GT(table.horizontalScrollBar()->maximum(), 40);
  const QRect strip(0, down() - place(0, 0).height(), table.viewport()->width(), place(0, 0).height());
  const QPoint name = place(3, 0).center();
  const auto sums = [&] { return table.viewport()->grab(strip).toImage(); };
  const QImage before = sums();
  scroll(0, 100);
  EXPECT_EQ(sums(), before) << "the sums are painted where they were";
  EXPECT_EQ(place(kBodies, 2).bottom(), down() - 1);
  EXPECT_EQ(table.indexAt(place(kBodies, 2).center()).row(), kBodies);

  const QRect head(0, 0, place(0, 0).width() - 1, table.horizontalHeader()->height());
  const auto heading = [&] { return table.horizontalHeader()->viewport()->grab(head).toImage(); };
  const QImage heading_before = heading();
  scroll(40, 0);
  EXPECT_EQ(heading(), heading_before);
  EXPECT_EQ(place(3, 0).left(), 0);
  EXPECT_EQ(table.indexAt(name), table.model()->index(3, 0));
  EXPECT_LT(place(3, 1).left(), place(3, 0).right());

  // At the end they stand in their own places.
  scroll(0, table.verticalScrollBar()->maximum());
  EXPECT_EQ(place(kBodies, 0).top(), place(kBodies - 1, 0).bottom() + 1);
}

TEST_F(KeptTableTest, ACellComesOutFromBelowWhatIsKept) {
  table.scrollTo(rows->index(20, 6));
  EXPECT_LT(place(20, 6).bottom(), place(kBodies, 6).top());
  EXPECT_LT(place(20, 6).right(), table.viewport()->width());
  table.scrollTo(rows->index(20, 1));
  EXPECT_GT(place(20, 1).left(), place(20, 0).right());
  // What is in sight moves nothing.
  scroll(20, 50);
  QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, place(kBodies, 0).center());
  EXPECT_EQ(table.currentIndex().row(), kBodies);
  EXPECT_EQ(table.horizontalScrollBar()->value(), 20);
  EXPECT_EQ(table.verticalScrollBar()->value(), 50);
}

TEST_F(KeptTableTest, AClickOnTheKeptHeadingIsOneOnIt) {
  table.setSelectionBehavior(QAbstractItemView::SelectItems);
  table.setSelectionMode(QAbstractItemView::ExtendedSelection);
  scroll(60, 0);
  QHeaderView* head = table.horizontalHeader();
  QTest::mouseClick(head->viewport(), Qt::LeftButton, {}, QPoint(20, head->height() / 2));
  EXPECT_TRUE(table.selectionModel()->isColumnSelected(0));
  EXPECT_FALSE(table.selectionModel()->isColumnSelected(1));
}

TEST_F(KeptTableTest, WhatIsMarkedEndsAboveTheKeptRows) {
  table.setSelectionBehavior(QAbstractItemView::SelectItems);
  table.setSelectionMode(QAbstractItemView::ExtendedSelection);
  const QPoint from = place(1, 1).center();
  const QPoint to = place(kBodies, 1).center();
  QTest::mousePress(table.viewport(), Qt::LeftButton, {}, from);
  QMouseEvent move(QEvent::MouseMove, to, table.viewport()->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(table.viewport(), &move);
  QTest::mouseRelease(table.viewport(), Qt::LeftButton, {}, to);
  EXPECT_TRUE(table.selectionModel()->isSelected(rows->index(2, 1)));
  EXPECT_FALSE(table.selectionModel()->isSelected(rows->index(kBodies, 1)));
  EXPECT_FALSE(table.selectionModel()->isSelected(rows->index(kBodies - 2, 1)));
}

TEST_F(KeptTableTest, AFewRowsHaveTheirOwnPlaces) {
  rows->fill(2);
  EXPECT_EQ(place(2, 0).top(), 2 * place(0, 0).height());
  EXPECT_FALSE(table.indexAt({20, down() - 2}).isValid());
}

}  // namespace
}  // namespace carom
