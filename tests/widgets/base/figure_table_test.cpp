#include "widgets/base/figure_table.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

class Counted : public FigureModel {
 public:
  Counted() : FigureModel({{"row", 40}}, nullptr) {}
  void set_count(int count) {
    count_ = count;
    rows_changed(count);
  }
  [[nodiscard]] Cell cell(int row, int /*column*/) const override {
    EXPECT_LT(row, count_);
    return static_cast<double>(row);
  }
  void set_sum(int row) { sum_ = row; }
  [[nodiscard]] bool is_sum(int row) const override { return row == sum_; }

 private:
  int count_ = 0;
  int sum_ = -1;
};

// A view may change its current row, and be laid out anew, while rows go.
TEST(FigureTable, WhatGoneRowsShowedIsNotRead) {
  Counted model;
  model.set_count(5);
  int read = 0;
  QObject::connect(&model, &QAbstractItemModel::rowsAboutToBeRemoved, &model, [&] {
    for (int row = 0; row < model.rowCount(); ++row) {
      EXPECT_EQ(model.data(model.index(row, 0)).isValid(), row < 2) << row;
      ++read;
    }
  });
  model.set_count(2);
  EXPECT_EQ(read, 5);
  EXPECT_EQ(model.rowCount(), 2);
}

// With what theory says of it in the rows below.
TEST(FigureTable, ASumStaysInSightWithTheRowsUnderIt) {
  auto* model = new Counted;
  FigureTable table(model, "counted", nullptr);
  constexpr int kSum = 17;
  model->set_sum(kSum);
  model->set_count(kSum + 3);
  table.resize(200, 180);
  table.show();
  const int height = table.viewport()->height();
  ASSERT_LT(height, table.rowViewportPosition(kSum));
  for (int row = kSum; row < kSum + 3; ++row)
    EXPECT_LT(table.visualRect(model->index(row, 0)).bottom(), height);
  EXPECT_GE(table.visualRect(model->index(kSum, 0)).top(), 0);
}

TEST(FigureTable, NoRowIsCutInHalf) {
  auto* model = new Counted;
  FigureTable table(model, "counted", nullptr);
  table.show();
  model->set_count(3);
  table.resize(200, 300);
  const int usual = table.rowHeight(0);
  model->set_count(40);
  for (int height = 90; height < 300; ++height) {
    table.resize(200, height);
    const int seen = table.viewport()->height();
    const int row = table.rowHeight(0);
    EXPECT_GE(row, 20) << "to be read";
    EXPECT_LT(seen % row, seen / row) << "less than a pixel a row is left";
  }
  table.resize(200, 300);
  model->set_count(3);
  EXPECT_EQ(table.rowHeight(0), usual);
}

}  // namespace
}  // namespace carom
