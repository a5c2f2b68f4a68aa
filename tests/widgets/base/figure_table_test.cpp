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
  [[nodiscard]] bool is_sum(int /*row*/) const override { return false; }

 private:
  int count_ = 0;
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

}  // namespace
}  // namespace carom
