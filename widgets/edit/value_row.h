#pragma once

#include <QWidget>
#include <vector>

#include "widgets/edit/inspected.h"

class QGridLayout;
class QLabel;

namespace carom {

class QuantityField;

// One line of the inspector in a grid of three columns: its label, and its field or two, under which the
// sentence on a wrong value stands.
class ValueRow : public QWidget {
  Q_OBJECT

 public:
  explicit ValueRow(const InspectedRow& row, QWidget* parent = nullptr);

  void show_row(const InspectedRow& row);
  // Forgets what is typed.
  void restore();
  // All rows of one inspector give their labels the same width.
  [[nodiscard]] int label_width() const;
  void set_label_width(int width);

 signals:
  // The values of one of the row's fields.
  void changed(int field, const std::vector<double>& values, bool in_burst);
  void burst_began(int field);
  // A field was left with a wrong value.
  void dropped(const QString& sentence);

 private:
  void add_field(QGridLayout* grid, const Inspected& value);

  QLabel* label_;
  QLabel* fault_;
  std::vector<QuantityField*> fields_;
};

}  // namespace carom
