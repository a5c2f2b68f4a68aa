#include "widgets/edit/cell_field.h"

#include <QFocusEvent>

namespace carom {

CellField::CellField(Take take, Value value, QWidget* parent)
    : TypedField(parent), take_(std::move(take)), value_of_(std::move(value)) {
  setObjectName("cell");
}

void CellField::focusOutEvent(QFocusEvent* event) {
  TypedField::focusOutEvent(event);
  if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason) emit left();
}

}  // namespace carom
