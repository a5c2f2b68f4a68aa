#include "app/restore_bar.h"

#include <QHBoxLayout>
#include <QPushButton>

#include "widgets/plain_text.h"

namespace carom {

RestoreBar::RestoreBar(QWidget* parent)
    : QFrame(parent),
      text_(new PlainLabel),
      restore_(new QPushButton(tr("Restore"))),
      discard_(new QPushButton(tr("Discard"))) {
  setObjectName("restore");
  text_->setWordWrap(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 7, 10, 7);
  row->setSpacing(8);
  row->addWidget(text_, 1);
  for (QPushButton* button : {restore_, discard_}) {
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button, 0, Qt::AlignTop);
  }
  connect(restore_, &QPushButton::clicked, this, &RestoreBar::restoreClicked);
  connect(discard_, &QPushButton::clicked, this, &RestoreBar::discardClicked);
  hide();
}

void RestoreBar::offer(const QString& text) {
  text_->setText(text);
  restore_->show();
  discard_->setText(tr("Discard"));
  show();
}

void RestoreBar::tell(const QString& text) {
  text_->setText(text);
  restore_->hide();
  discard_->setText(tr("OK"));
  show();
}

}  // namespace carom
