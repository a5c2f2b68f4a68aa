#include "widgets/edit/words_row.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QPushButton>

#include "widgets/base/plain_text.h"

namespace carom {

WordsRow::WordsRow(const InspectedRow& row, QWidget* parent)
    : InspectorRow(row, new PlainLabel(row.label), parent), words_(new QButtonGroup(this)) {
  auto* line = new QHBoxLayout;
  line->setSpacing(0);
  const auto count = static_cast<int>(row.choice->words.size());
  for (int i = 0; i < count; ++i) {
    auto* word = new QPushButton(this);
    word->setCheckable(true);
    word->setAutoDefault(false);
    word->setObjectName("word");
    // The style sheet rounds the outer corners.
    word->setProperty("side", i == 0 ? "left" : i + 1 == count ? "right" : "middle");
    words_->addButton(word, i);
    line->addWidget(word, 1);
  }
  grid()->addLayout(line, 0, 1, 1, kColumns);
  connect(words_, &QButtonGroup::idClicked, this, &WordsRow::choose);
  show_row(row);
}

void WordsRow::show_row(const InspectedRow& row) {
  choice_ = *row.choice;
  for (int i = 0; i < choice_.words.size(); ++i) {
    QAbstractButton* word = words_->button(i);
    word->setText(choice_.words[i]);
    word->setToolTip(plain_tip(choice_.refusal.isEmpty() ? choice_.meanings.value(i) : choice_.refusal));
    word->setAccessibleName(choice_.name + ": " + choice_.words[i]);
    word->setEnabled(choice_.refusal.isEmpty());
  }
  restore();
}

void WordsRow::restore() {
  words_->setExclusive(false);
  for (QAbstractButton* word : words_->buttons()) word->setChecked(words_->id(word) == choice_.chosen);
  words_->setExclusive(true);
}

void WordsRow::choose(int index) {
  if (index == choice_.chosen) return;
  // Shown anew, or not at all where it could not be.
  const NamedEdits edits = choice_.edits(index);
  emit edited(edits);
}

}  // namespace carom
