#pragma once

#include "widgets/edit/inspector_row.h"

class QButtonGroup;

namespace carom {

// A line with one of several words, all of which are seen.
class WordsRow : public InspectorRow {
  Q_OBJECT

 public:
  explicit WordsRow(const InspectedRow& row, QWidget* parent = nullptr);

  void show_row(const InspectedRow& row) override;
  void restore() override;

 private:
  void choose(int index);

  InspectedChoice choice_;
  QButtonGroup* words_;
};

}  // namespace carom
