#include "widgets/edit/inspector_row.h"

#include <QGridLayout>

#include "widgets/base/plain_text.h"
#include "widgets/edit/action_row.h"
#include "widgets/edit/choice_row.h"
#include "widgets/edit/name_row.h"
#include "widgets/edit/value_row.h"
#include "widgets/edit/words_row.h"

namespace carom {

InspectorRow::InspectorRow(const InspectedRow& row, QLabel* label, QWidget* parent)
    : QWidget(parent),
      grid_(new QGridLayout(this)),
      label_(label),
      fault_(new PlainLabel(this)),
      value_(new PlainLabel(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(6);
  grid_->setVerticalSpacing(2);
  label_->setObjectName("muted");
  grid_->addWidget(label_, 0, 0);
  if (row.label.isEmpty()) label_->hide();
  fault_->setObjectName("fault");
  fault_->setWordWrap(true);
  value_->setObjectName("caption");
  for (QLabel* line : {fault_, value_}) {
    line->hide();
    grid_->addWidget(line, 2, 1, 1, kColumns);  // under two lines of fields
  }
}

InspectorRow::InspectorRow(const InspectedRow& row, QWidget* parent)
    : InspectorRow(row, new PlainLabel(row.label), parent) {
  text_ = new PlainLabel(row.text, this);
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setToolTip(plain_tip(row.tip));
  grid_->addWidget(text_, 0, 1, 1, kColumns);
  grid_->setColumnStretch(1, 1);
}

void InspectorRow::show_row(const InspectedRow& row) {
  if (text_->text() != row.text) text_->setText(row.text);
  if (const QString tip = plain_tip(row.tip); text_->toolTip() != tip) text_->setToolTip(tip);
}

void InspectorRow::say(const QString& sentence) {
  fault_->setText(sentence);
  fault_->setVisible(!sentence.isEmpty());
}

void InspectorRow::show_value(const QString& text) {
  value_->setText(text);
  value_->setVisible(!text.isEmpty());
}

void InspectorRow::act(const InspectedAction& action) {
  say(action.refusal);
  if (!action.refusal.isEmpty()) return;
  if (action.folds) {
    emit folded(*action.folds);
  } else if (action.opens_stops) {
    emit stopsAsked();
  } else if (action.opens) {
    emit opened(*action.opens);
  } else {
    emit edited(action.edits);
  }
}

int InspectorRow::label_width() const { return label_->text().isEmpty() ? 0 : label_->sizeHint().width(); }

void InspectorRow::set_label_width(int width) { label_->setFixedWidth(width); }

InspectorRow* new_row(const InspectedRow& row, QWidget* parent) {
  if (!row.values.empty()) return new ValueRow(row, parent);
  if (row.choice && row.choice->side_by_side) return new WordsRow(row, parent);
  if (row.choice) return new ChoiceRow(row, parent);
  if (row.named) return new NameRow(row, parent);
  if (!row.actions.empty()) return new ActionRow(row, parent);
  return new InspectorRow(row, parent);
}

}  // namespace carom
