#pragma once

#include <vector>

#include "widgets/edit/inspector_row.h"

namespace carom {

class ElidedButton;

// A line of buttons.
class ActionRow : public InspectorRow {
  Q_OBJECT

 public:
  explicit ActionRow(const InspectedRow& row, QWidget* parent = nullptr);

  void show_row(const InspectedRow& row) override;

 private:
  std::vector<InspectedAction> actions_;
  std::vector<ElidedButton*> buttons_;
};

}  // namespace carom
