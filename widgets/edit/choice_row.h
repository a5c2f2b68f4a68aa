#pragma once

#include "widgets/edit/inspector_row.h"

namespace carom {

class ChoiceBox;

// A line with one of several words.
class ChoiceRow : public InspectorRow {
  Q_OBJECT

 public:
  explicit ChoiceRow(const InspectedRow& row, QWidget* parent = nullptr);

  void show_row(const InspectedRow& row) override;
  void restore() override;

 private:
  InspectedChoice choice_;
  ChoiceBox* box_;
  QLabel* remark_;
};

}  // namespace carom
