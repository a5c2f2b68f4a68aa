#pragma once

#include <functional>

#include "widgets/edit/typed_field.h"

namespace carom {

// The text of one cell of a table while it is edited.
class CellField : public TypedField {
  Q_OBJECT

 public:
  // What takes the text, or returns one sentence on why it can't be.
  using Take = std::function<QString(const QString&)>;
  // The value of a text, where that is worth being shown.
  using Value = std::function<QString(const QString&)>;
  CellField(Take take, Value value, QWidget* parent);

  using TypedField::accept_typed;

 signals:
  void left();  // the focus is elsewhere: the text is taken or dropped

 protected:
  QString take(const QString& text) override { return take_(text); }
  [[nodiscard]] QString value_of(const QString& text) const override { return value_of_(text); }
  void focusOutEvent(QFocusEvent* event) override;

 private:
  Take take_;
  Value value_of_;
};

}  // namespace carom
