#include "widgets/edit/choice_row.h"

#include <QGridLayout>
#include <QLabel>

#include "widgets/base/plain_text.h"
#include "widgets/edit/choice_box.h"

namespace carom {

ChoiceRow::ChoiceRow(const InspectedRow& row, QWidget* parent)
    : InspectorRow(row, new PlainLabel(row.label), parent),
      box_(new ChoiceBox(this)),
      remark_(new PlainLabel(this)) {
  grid()->addWidget(box_, 0, 1, 1, kColumns - 1);
  grid()->addWidget(remark_, 0, kColumns);
  grid()->setColumnStretch(1, 1);
  remark_->setObjectName("muted");
  connect(box_, &QComboBox::activated, this, [this](int index) {
    if (index == choice_.chosen) return;
    if (choice_.is_keeps) return emit keepsChosen(static_cast<Keeps>(index));
    emit edited(choice_.edits(index));
  });
  show_row(row);
}

void ChoiceRow::show_row(const InspectedRow& row) {
  choice_ = *row.choice;
  box_->list(choice_.words);
  for (int i = 0; i < choice_.meanings.size(); ++i)
    box_->setItemData(i, plain_tip(choice_.meanings[i]), Qt::ToolTipRole);
  QStringList lines{choice_.meaning};
  if (choice_.chosen >= 0 && choice_.chosen < choice_.meanings.size())
    lines << choice_.words[choice_.chosen] + ": " + choice_.meanings[choice_.chosen];
  box_->setToolTip(plain_tip(lines.join('\n')));
  label()->setToolTip(box_->toolTip());
  box_->setAccessibleName(choice_.name);
  box_->setPlaceholderText(choice_.other);
  remark_->setText(choice_.remark);
  remark_->setVisible(!choice_.remark.isEmpty());
  restore();
}

void ChoiceRow::restore() { box_->setCurrentIndex(choice_.chosen); }

}  // namespace carom
