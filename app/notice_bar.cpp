#include "app/notice_bar.h"

#include <QHBoxLayout>
#include <QPushButton>

#include "widgets/plain_text.h"

namespace carom {

NoticeBar::NoticeBar(QWidget* parent)
    : QFrame(parent), text_(new PlainLabel), accept_(new QPushButton), dismiss_(new QPushButton) {
  setObjectName("notice");
  text_->setWordWrap(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 6, 8, 6);
  row->setSpacing(8);
  row->addWidget(text_, 1);
  for (QPushButton* button : {accept_, dismiss_}) {
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button, 0, Qt::AlignVCenter);
  }
  connect(accept_, &QPushButton::clicked, this, &NoticeBar::accepted);
  connect(dismiss_, &QPushButton::clicked, this, &NoticeBar::dismissed);
  hide();
}

void NoticeBar::say(const QString& text, const QString& accept, const QString& dismiss) {
  text_->setText(text);
  accept_->setText(accept);
  accept_->setVisible(!accept.isEmpty());
  dismiss_->setText(dismiss);
  show();
}

}  // namespace carom
