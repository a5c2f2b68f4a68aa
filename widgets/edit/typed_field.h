#pragma once

#include <QLineEdit>
#include <optional>

namespace carom {

// A line of text that takes what is typed at Enter and when it loses the focus. What can't be taken marks the
// field (property "fault", which the style sheet shows) until it is changed, what can't be mended already while
// it is typed; Esc, or leaving the field, brings
// the last good text back.
class TypedField : public QLineEdit {
  Q_OBJECT

 public:
  explicit TypedField(QWidget* parent = nullptr);

  // Shows this unless the user is typing.
  void show_text(const QString& text);
  [[nodiscard]] const QString& shown_text() const { return shown_; }
  [[nodiscard]] bool is_typing() const { return isModified(); }
  // While changes are watched, a text that differs from the one at the beginning marks the field (property
  // "changes").
  void watch_changes(bool watch);
  // Forgets what was typed.
  void restore();

 signals:
  // Why the text can't be taken, in one sentence; empty: nothing is wrong any more.
  void refused(const QString& sentence);
  // The value of the formula that is typed, "= 3.96 m/s"; empty: there is none, or none any more.
  void valued(const QString& text);
  // Enter was pressed, and what was typed, if anything, was taken.
  void entered();
  // The field was left with a text that can't be taken; empty: another one is typed now.
  void dropped(const QString& sentence);

 protected:
  // Takes the text, which differs from the one shown last, or returns one sentence on why it can't.
  virtual QString take(const QString& text) = 0;
  // What is wrong already and no further digit mends, in one sentence; empty: nothing so far.
  [[nodiscard]] virtual QString early_fault(const QString& /*text*/) const { return {}; }
  // The value of the text, where that is worth being shown.
  [[nodiscard]] virtual QString value_of(const QString& /*text*/) const { return {}; }
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

  // Takes what was typed, if anything; false if it can't be taken.
  bool accept_typed();

  // What stands there while it has no focus.
  [[nodiscard]] virtual QString fitted(const QString& text) const { return text; }
  void resizeEvent(QResizeEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;

 private:
  [[nodiscard]] QString displayed() const { return hasFocus() ? shown_ : fitted(shown_); }
  void show_displayed();
  void set_fault(const QString& sentence);
  void show_change();
  void set_look(const char* property, bool on);
  void set_value(const QString& text);

  QString shown_;
  QString fault_;
  QString value_;
  std::optional<QString> watched_;  // at the beginning
};

}  // namespace carom
