#include "widgets/edit/name_row.h"

#include <QGridLayout>
#include <QLabel>

#include "widgets/base/plain_text.h"
#include "widgets/edit/name_field.h"

namespace carom {

NameRow::NameRow(const InspectedRow& row, QWidget* parent)
    : InspectorRow(row, new PlainLabel(row.label), parent), field_(new NameField(this)) {
  field_->set_of(row.named->of);
  grid()->addWidget(field_, 0, 1, 1, kColumns);
  grid()->setColumnStretch(1, 1);
  connect(field_, &NameField::named, this, [this](const QString& name) { emit edited(named_.edits(name)); });
  connect(field_, &TypedField::refused, this, &NameRow::say);
  connect(field_, &TypedField::dropped, this, &NameRow::dropped);
  show_row(row);
}

void NameRow::show_row(const InspectedRow& row) {
  named_ = *row.named;
  field_->setAccessibleName(named_.name);
  field_->setPlaceholderText(named_.unset);
  field_->show_text(named_.text);
}

void NameRow::restore() { field_->restore(); }

}  // namespace carom
