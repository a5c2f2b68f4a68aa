#pragma once

#include <QWidget>
#include <vector>

#include "physics/scene/part_id.h"
#include "widgets/edit/inspected.h"

class QGridLayout;
class QLabel;

namespace carom {

// One line of the inspector: its label, what stands right of it, here a text that only informs, and under that
// the sentence on a wrong value.
class InspectorRow : public QWidget {
  Q_OBJECT

 public:
  explicit InspectorRow(const InspectedRow& row, QWidget* parent = nullptr);

  virtual void show_row(const InspectedRow& row);
  // Forgets what is typed.
  virtual void restore() {}
  // Why the values that a field is handing out could not be.
  virtual void refuse(int /*field*/, const QString& /*sentence*/) {}
  // In red under the field.
  void say(const QString& sentence);
  // All rows of one inspector give their labels the same width.
  [[nodiscard]] int label_width() const;
  void set_label_width(int width);

 signals:
  // The values of one of the row's fields.
  void changed(int field, const std::vector<double>& values, bool in_burst);
  void burst_began(int field, bool pulled);
  void typed(int field);
  // Any other edit.
  void edited(const carom::NamedEdits& edits);
  // What could not be, in one sentence: a field was left with a wrong value, or a button is refused. Empty:
  // what was said is over, as something is typed.
  void dropped(const QString& sentence);
  void opened(const carom::PartId& part);
  void folded(const QString& list);
  void stopsAsked();
  void keepsChosen(carom::Keeps keeps);

 protected:
  InspectorRow(const InspectedRow& row, QLabel* label, QWidget* parent);

  static constexpr int kColumns = 4;  // right of the label: two fields with a label each

  [[nodiscard]] QGridLayout* grid() const { return grid_; }
  [[nodiscard]] QLabel* label() const { return label_; }
  // The value of what is typed, there too.
  void show_value(const QString& text);
  // Does what a button of the row is for, or says why not.
  void act(const InspectedAction& action);

 private:
  QGridLayout* grid_;
  QLabel* label_;
  QLabel* text_ = nullptr;
  QLabel* fault_;
  QLabel* value_;
};

// The row that shows this.
[[nodiscard]] InspectorRow* new_row(const InspectedRow& row, QWidget* parent);

}  // namespace carom
