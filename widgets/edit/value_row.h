#pragma once

#include <vector>

#include "widgets/edit/inspector_row.h"

class QLayout;
class QToolButton;

namespace carom {

class QuantityField;
class ValueSlider;

// A line with a field and its slider, or with two fields and perhaps small buttons, one under the other where
// it is narrow.
class ValueRow : public InspectorRow {
  Q_OBJECT

 public:
  explicit ValueRow(const InspectedRow& row, QWidget* parent = nullptr);

  void show_row(const InspectedRow& row) override;
  void restore() override;
  void refuse(int field, const QString& sentence) override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void place_fields(bool narrow);
  void add_field(const Inspected& value);
  void add_button();
  [[nodiscard]] QLayout* with_slider(QuantityField* field);

  std::vector<NamedEdits> emptied_;  // of each field that may be empty
  std::vector<QuantityField*> fields_;
  std::vector<QWidget*> handles_;  // the labels of two fields
  bool narrow_ = false;
  ValueSlider* slider_ = nullptr;  // of a single field
  std::vector<InspectedAction> actions_;
  std::vector<QToolButton*> buttons_;  // at the right of the fields
};

}  // namespace carom
