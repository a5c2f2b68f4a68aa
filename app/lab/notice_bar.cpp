#include "app/lab/notice_bar.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>

#include "widgets/base/plain_text.h"

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
    button->installEventFilter(this);
    row->addWidget(button, 0, Qt::AlignVCenter);
  }
  connect(accept_, &QPushButton::clicked, this, &NoticeBar::accepted);
  connect(dismiss_, &QPushButton::clicked, this, &NoticeBar::dismissed);
  hide();
}

// Keys that press the focused button, although the window uses them otherwise.
bool NoticeBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
    return QFrame::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool is_return = key == Qt::Key_Return || key == Qt::Key_Enter;
  if (event->type() == QEvent::ShortcutOverride && (is_return || key == Qt::Key_Space)) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::KeyPress && is_return) {
    static_cast<QPushButton*>(watched)->click();
    return true;
  }
  return QFrame::eventFilter(watched, event);
}

void NoticeBar::say(const QString& text, const QString& accept, const QString& dismiss) {
  text_->setText(text);
  accept_->setText(accept);
  accept_->setVisible(!accept.isEmpty());
  dismiss_->setText(dismiss);
  show();
}

}  // namespace carom
