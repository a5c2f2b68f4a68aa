#include "widgets/edit/value_row.h"

#include <QGridLayout>

#include "widgets/edit/drag_label.h"
#include "widgets/edit/quantity_field.h"

namespace carom {
namespace {

constexpr int kColumns = 4;      // right of the label: two fields with a label each
constexpr int kLeastField = 40;  // px

}  // namespace

ValueRow::ValueRow(const InspectedRow& row, QWidget* parent)
    : QWidget(parent),
      label_(row.values.size() > 1 ? new PlainLabel(row.label, this) : new DragLabel(row.label, this)),
      fault_(new PlainLabel(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(2);
  label_->setObjectName("muted");
  grid->addWidget(label_, 0, 0);
  fault_->setObjectName("fault");
  fault_->setWordWrap(true);
  fault_->hide();
  for (const Inspected& value : row.values) add_field(grid, value);
  grid->addWidget(fault_, 1, 1, 1, kColumns);
  show_row(row);
}

void ValueRow::add_field(QGridLayout* grid, const Inspected& value) {
  auto* field = new QuantityField(this);
  const int index = static_cast<int>(fields_.size());
  fields_.push_back(field);
  auto* handle = qobject_cast<DragLabel*>(label_);
  if (value.label.isEmpty()) {
    grid->addWidget(field, 0, 1, 1, kColumns);
  } else {
    handle = new DragLabel(value.label, this);
    handle->setObjectName("muted");
    grid->addWidget(handle, 0, 1 + 2 * index);
    grid->addWidget(field, 0, 2 + 2 * index);
    grid->setColumnStretch(2 + 2 * index, 1);
  }
  field->setMinimumWidth(kLeastField);
  connect(handle, &DragLabel::began, field, &QuantityField::begin_pull);
  connect(handle, &DragLabel::moved, field, &QuantityField::pull);
  connect(field, &QuantityField::burst_began, this, [this, index] { emit burst_began(index); });
  connect(field, &QuantityField::changed, this,
          [this, index](const std::vector<double>& values, bool burst) { emit changed(index, values, burst); });
  connect(field, &TypedField::refused, this, [this](const QString& sentence) {
    fault_->setText(sentence);
    fault_->setVisible(!sentence.isEmpty());
  });
  connect(field, &TypedField::dropped, this, &ValueRow::dropped);
}

void ValueRow::show_row(const InspectedRow& row) {
  for (std::size_t i = 0; i < fields_.size(); ++i) fields_[i]->show_value(row.values[i]);
  const QString tip = fields_.front()->toolTip();
  if (fields_.size() == 1 && label_->toolTip() != tip) label_->setToolTip(tip);
}

void ValueRow::restore() {
  for (QuantityField* field : fields_) field->restore();
}

int ValueRow::label_width() const { return label_->sizeHint().width(); }

void ValueRow::set_label_width(int width) { label_->setFixedWidth(width); }

}  // namespace carom
