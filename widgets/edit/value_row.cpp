#include "widgets/edit/value_row.h"

#include <QGridLayout>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "widgets/base/plain_text.h"
#include "widgets/edit/drag_label.h"
#include "widgets/edit/quantity_field.h"
#include "widgets/edit/value_slider.h"

namespace carom {
namespace {

constexpr int kLeastField = 40;   // px
constexpr int kInsets = 16;       // px, of a field beside its text
constexpr int kRoomForTwo = 270;  // px, with the label
constexpr int kButton = 26;       // px
constexpr int kFieldShare = 6;    // of the width that a field and its slider share
constexpr int kSliderShare = 5;

}  // namespace

ValueRow::ValueRow(const InspectedRow& row, QWidget* parent)
    : InspectorRow(row, row.values.size() > 1 ? new PlainLabel(row.label) : new DragLabel(row.label), parent) {
  for (const Inspected& value : row.values) add_field(value);
  for (std::size_t i = 0; i < row.actions.size(); ++i) add_button();
  place_fields(false);
  show_row(row);
}

void ValueRow::resizeEvent(QResizeEvent* event) {
  InspectorRow::resizeEvent(event);
  const bool narrow = width() < kRoomForTwo;
  if (std::exchange(narrow_, narrow) != narrow) place_fields(narrow);
}

void ValueRow::place_fields(bool narrow) {
  for (std::size_t i = 0; i < handles_.size(); ++i) {
    const int row = narrow ? static_cast<int>(i) : 0;
    const int column = narrow ? 1 : 1 + 2 * static_cast<int>(i);
    for (QWidget* each : {handles_[i], static_cast<QWidget*>(fields_[i])}) grid()->removeWidget(each);
    grid()->addWidget(handles_[i], row, column);
    grid()->addWidget(fields_[i], row, column + 1, 1, narrow ? kColumns - 1 : 1);
    grid()->setColumnStretch(column + 1, 1);
  }
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    const int number = static_cast<int>(i);
    grid()->removeWidget(buttons_[i]);
    grid()->addWidget(buttons_[i], narrow ? number : 0, kColumns + 1 + (narrow ? 0 : number));
  }
  if (!handles_.empty()) grid()->setColumnStretch(kColumns, narrow ? 0 : 1);
}

void ValueRow::add_field(const Inspected& value) {
  auto* field = new QuantityField(this);
  const int index = static_cast<int>(fields_.size());
  fields_.push_back(field);
  auto* handle = qobject_cast<DragLabel*>(label());
  if (value.label.isEmpty()) {
    grid()->addLayout(with_slider(field), 0, 1, 1, kColumns);
  } else {
    handle = new DragLabel(value.label, this);
    handle->setObjectName("muted");
    handles_.push_back(handle);
  }
  field->setMinimumWidth(kLeastField);
  connect(handle, &DragLabel::began, field, &QuantityField::begin_pull);
  connect(handle, &DragLabel::moved, field, &QuantityField::pull);
  connect(field, &QuantityField::burst_began, this,
          [this, index](bool is_pull) { emit burst_began(index, is_pull); });
  connect(field, &QLineEdit::textEdited, this, [this, index] { emit typed(index); });
  connect(field, &QuantityField::changed, this,
          [this, index](const std::vector<double>& values, bool burst) { emit changed(index, values, burst); });
  connect(field, &QuantityField::emptied, this,
          [this, index] { emit edited(emptied_[static_cast<std::size_t>(index)]); });
  connect(field, &TypedField::refused, this, &ValueRow::say);
  connect(field, &TypedField::valued, this, &ValueRow::show_value);
  connect(field, &TypedField::dropped, this, &ValueRow::dropped);
}

void ValueRow::add_button() {
  auto* button = new QToolButton(this);
  button->setFocusPolicy(Qt::TabFocus);
  button->setFixedWidth(kButton);
  const std::size_t index = buttons_.size();
  buttons_.push_back(button);
  connect(button, &QToolButton::clicked, this, [this, index] { act(actions_[index]); });
}

QLayout* ValueRow::with_slider(QuantityField* field) {
  slider_ = new ValueSlider(this);
  auto* line = new QHBoxLayout;
  line->setSpacing(8);
  line->addWidget(field, kFieldShare);
  line->addWidget(slider_, kSliderShare);
  connect(slider_, &ValueSlider::began, field, &QuantityField::begin_pull);
  connect(slider_, &ValueSlider::moved, field, &QuantityField::pull_to);
  connect(slider_, &ValueSlider::cancelled, field, [field] { field->pull(0.0); });
  return line;
}

void ValueRow::show_row(const InspectedRow& row) {
  emptied_.clear();
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    emptied_.push_back(row.values[i].emptied.value_or(NamedEdits{}));
    fields_[i]->show_value(row.values[i]);
  }
  actions_ = row.actions;
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    const InspectedAction& action = actions_[i];
    buttons_[i]->setText(action.text);
    buttons_[i]->setToolTip(plain_tip(action.refusal.isEmpty() ? action.meaning : action.refusal));
    buttons_[i]->setAccessibleName(action.name);
    buttons_[i]->setEnabled(action.refusal.isEmpty());
  }
  if (slider_ != nullptr) {
    // The slider takes what the number leaves.
    const QuantityField& field = *fields_.front();
    const int needed = field.fontMetrics().horizontalAdvance(field.shown_text()) + kInsets;
    fields_.front()->setMinimumWidth(std::max(kLeastField, needed));
    const std::vector<double>& values = row.values.front().values;
    const bool same = std::equal(values.begin() + 1, values.end(), values.begin());
    slider_->setEnabled(same && row.values.front().refusal.isEmpty());
    slider_->show_value(row.values.front().range, values.front());
    slider_->setToolTip(fields_.front()->toolTip());
    slider_->setAccessibleName(fields_.front()->accessibleName());
  }
  const QString tip = fields_.front()->toolTip();
  if (fields_.size() == 1 && label()->toolTip() != tip) label()->setToolTip(tip);
}

void ValueRow::refuse(int field, const QString& sentence) {
  fields_[static_cast<std::size_t>(field)]->refuse(sentence);
}

void ValueRow::restore() {
  for (QuantityField* field : fields_) field->restore();
}

}  // namespace carom
