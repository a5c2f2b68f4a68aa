#pragma once

#include "widgets/edit/inspector_row.h"

namespace carom {

class NameField;

// A line with the name of a part.
class NameRow : public InspectorRow {
  Q_OBJECT

 public:
  explicit NameRow(const InspectedRow& row, QWidget* parent = nullptr);

  void show_row(const InspectedRow& row) override;
  void restore() override;

 private:
  InspectedName named_;
  NameField* field_;
};

}  // namespace carom
