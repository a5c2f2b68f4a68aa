#include "widgets/edit/typed_field.h"

#include <QKeyEvent>
#include <QStyle>

namespace carom {

TypedField::TypedField(QWidget* parent) : QLineEdit(parent) {
  connect(this, &QLineEdit::textEdited, this, [this](const QString& text) {
    emit dropped({});
    const QString fault = early_fault(text);
    set_fault(fault);
    set_value(fault.isEmpty() ? value_of(text) : QString());
  });
}

void TypedField::show_text(const QString& text) {
  shown_ = text;
  if (!is_typing()) show_displayed();
  show_change();
}

void TypedField::watch_changes(bool watch) {
  watched_ = watch ? std::optional(shown_) : std::nullopt;
  show_change();
}

void TypedField::show_change() { set_look("changes", watched_ && *watched_ != shown_); }

void TypedField::set_look(const char* property, bool on) {
  if (this->property(property).toBool() == on) return;
  setProperty(property, on);
  style()->unpolish(this);
  style()->polish(this);
}

void TypedField::show_displayed() {
  const QString text = displayed();
  if (this->text() == text) return;
  // Of a value that changes while a run plays what is marked stays so, to be typed over.
  const bool all_marked = hasSelectedText() && selectedText() == this->text();
  const int cursor = hasFocus() ? cursorPosition() : 0;
  setText(text);
  setCursorPosition(cursor);
  if (all_marked) selectAll();
}

void TypedField::resizeEvent(QResizeEvent* event) {
  QLineEdit::resizeEvent(event);
  if (!is_typing()) show_displayed();
}

void TypedField::focusInEvent(QFocusEvent* event) {
  if (!is_typing()) show_displayed();
  QLineEdit::focusInEvent(event);
}

void TypedField::restore() {
  set_fault({});
  set_value({});
  show_displayed();
  setModified(false);
}

bool TypedField::accept_typed() {
  if (!is_typing()) return true;
  if (text().trimmed() == shown_) {
    restore();
    return true;
  }
  // Taken before the receiver shows the scene with the edit.
  setModified(false);
  const QString fault = take(text());
  set_value({});
  if (!fault.isEmpty()) setModified(true);
  set_fault(fault);
  return fault.isEmpty();
}

void TypedField::set_fault(const QString& sentence) {
  if (fault_ == sentence) return;
  fault_ = sentence;
  set_look("fault", !sentence.isEmpty());
  emit refused(sentence);
}

void TypedField::set_value(const QString& text) {
  if (value_ == text) return;
  value_ = text;
  emit valued(text);
}

bool TypedField::event(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return QLineEdit::event(event);
  const auto* key = static_cast<QKeyEvent*>(event);
  // Esc and Enter are the field's while it is typed in, and so is undo; else they are the window's.
  const bool ends = key->key() == Qt::Key_Escape || key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
  if (is_typing() && ends) {
    event->accept();
    return true;
  }
  // Nor does a text begin with a space, which plays.
  const bool begins = key->key() == Qt::Key_Space && selectedText() == text();
  if (!is_typing() && (begins || key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo))) {
    event->ignore();
    return false;
  }
  return QLineEdit::event(event);
}

void TypedField::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && is_typing()) {
    restore();
    selectAll();
  } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    if (!accept_typed()) return;
    selectAll();
    emit entered();
  } else {
    QLineEdit::keyPressEvent(event);
  }
}

void TypedField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  // Another window, or a menu of the field, doesn't end typing.
  if (event->reason() == Qt::PopupFocusReason || event->reason() == Qt::ActiveWindowFocusReason) return;
  if (!accept_typed()) {
    const QString sentence = fault_;
    restore();
    emit dropped(sentence);
  }
  if (!is_typing()) show_displayed();
  setCursorPosition(0);  // a long text shows its beginning
}

}  // namespace carom
