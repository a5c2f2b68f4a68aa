#pragma once

#include <QElapsedTimer>
#include <functional>
#include <vector>

#include "widgets/edit/inspected.h"
#include "widgets/edit/typed_field.h"

namespace carom {

// The next value of a field by one step of the arrow keys: a tenth of the leading digit's place, never finer
// than a hundredth (an angle: a degree) where 0 is allowed, so that steps reach it. Within the range.
[[nodiscard]] double stepped(double value, const Range& range, int steps);

// The value after the mouse has pulled a label by `pixels`: 100 px double what is positive, and 2 px are a
// hundredth (of an angle a degree) for all else. Within the range.
[[nodiscard]] double pulled(double value, const Range& range, double pixels);

// A field for one value, or for the same value of several bodies, with its unit at the right. Takes what
// typed_quantity() reads; Up and Down step.
class QuantityField : public TypedField {
  Q_OBJECT

 public:
  explicit QuantityField(QWidget* parent = nullptr);

  // Values that differ read "2 values".
  void show_value(const Inspected& value);

  // Why the values that changed() hands out could not be.
  void refuse(const QString& sentence) { answer_ = sentence; }

  // While the mouse pulls the label of the field: the values are those at the beginning, changed.
  void begin_pull();
  void pull(double pixels);
  // While a slider is pulled.
  void pull_to(double value);

 signals:
  // New values in SI, all in range. Those of one burst, of quick steps or of a pull, are one edit.
  void changed(const std::vector<double>& values, bool in_burst);
  // The field is empty now, where it may be.
  void emptied();
  // A burst begins, of steps or by a pull.
  void burst_began(bool pulled);

 protected:
  QString take(const QString& text) override;
  // More digits make no number smaller, and none positive.
  [[nodiscard]] QString early_fault(const QString& text) const override;
  [[nodiscard]] QString value_of(const QString& text) const override;
  // With as many digits as fit, if possible beside the unit.
  [[nodiscard]] QString fitted(const QString& text) const override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void step(int steps);
  [[nodiscard]] int room_beside_unit() const;  // px, for the text
  void set_in_burst(const std::vector<double>& values);

  Range range_;
  Range typed_range_;
  QString name_;
  QString unit_;
  std::vector<double> values_;
  std::vector<FormulaNames> formula_names_;
  bool is_given_ = true;
  bool may_be_empty_ = false;
  QString refusal_;
  QString answer_;  // to the values that were handed out last
  std::function<QString(const std::vector<double>&)> value_fault_;
  std::vector<double> pulled_from_;
  QElapsedTimer last_step_;
};

}  // namespace carom
