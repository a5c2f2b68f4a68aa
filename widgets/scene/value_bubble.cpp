#include "widgets/scene/value_bubble.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <utility>

#include "widgets/base/plain_text.h"

namespace carom {

ValueField::ValueField(Take take, QWidget* parent) : TypedField(parent), take_(std::move(take)) {}

QString ValueField::take(const QString& text) { return take_(text, yields_); }

bool ValueField::event(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return TypedField::event(event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key != Qt::Key_Escape && key != Qt::Key_Return && key != Qt::Key_Enter) return TypedField::event(event);
  event->accept();
  return true;
}

bool ValueField::focusNextPrevChild(bool next) {
  if (accept_typed()) emit nextAsked(next);
  return true;
}

void ValueField::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    emit cancelled();
  } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    yields_ = event->modifiers().testFlag(Qt::ControlModifier);
    const bool accepted = accept_typed();
    yields_ = false;
    if (accepted) emit finished();
  } else {
    TypedField::keyPressEvent(event);
  }
}

void ValueField::focusOutEvent(QFocusEvent* event) {
  TypedField::focusOutEvent(event);
  const bool stays = event->reason() == Qt::PopupFocusReason || event->reason() == Qt::ActiveWindowFocusReason;
  if (!stays) emit finished();
}

ValueBubble::ValueBubble(ValueField::Take take, QWidget* parent)
    : QFrame(parent),
      name_(new PlainLabel(this)),
      field_(new ValueField(std::move(take), this)),
      unit_(new PlainLabel(this)),
      line_(new PlainLabel(this)),
      fault_(new PlainLabel(this)) {
  constexpr int kFieldWidth = 96;  // px
  constexpr int kLongestLine = 260;
  setObjectName("bubble");
  setCursor(Qt::ArrowCursor);
  field_->setFixedWidth(kFieldWidth);
  fault_->setObjectName("fault");
  line_->setObjectName("caption");
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(10, 6, 10, 6);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(3);
  grid->addWidget(name_, 0, 0);
  grid->addWidget(field_, 0, 1);
  grid->addWidget(unit_, 0, 2);
  for (QLabel* label : {line_, fault_}) {
    label->setMaximumWidth(kLongestLine);
    label->setWordWrap(true);
    grid->addWidget(label, label == line_ ? 1 : 2, 0, 1, 4);
    label->hide();
  }
  grid->setColumnStretch(3, 1);
  connect(field_, &TypedField::refused, this, [this](const QString& sentence) {
    show_line(sentence.isEmpty() ? detail_ : sentence, !sentence.isEmpty());
  });
  hide();
}

void ValueBubble::show_value(const Shown& shown) {
  name_->setText(shown.name);
  unit_->setText(shown.unit);
  detail_ = shown.detail;
  field_->setAccessibleName(shown.name + " of " + shown.subject +
                            (shown.unit.isEmpty() ? QString() : ", " + shown.unit));
  field_->show_text(shown.text);
  show_line(detail_, false);
}

void ValueBubble::show_detail(const QString& text) {
  detail_ = text;
  if (!fault_->isVisibleTo(this)) show_line(detail_, false);
}

void ValueBubble::begin(const QString& first) {
  show();
  raise();
  field_->setFocus(Qt::OtherFocusReason);
  field_->selectAll();
  if (!first.isEmpty()) field_->insert(first);
}

void ValueBubble::end() {
  field_->restore();
  hide();
}

void ValueBubble::show_line(const QString& text, bool fault) {
  line_->setText(text);
  fault_->setText(text);
  line_->setVisible(!fault && !text.isEmpty());
  fault_->setVisible(fault);
  layout()->activate();
  adjustSize();
  emit resized();
}

}  // namespace carom
