#pragma once

#include <QFrame>
#include <functional>

#include "widgets/edit/typed_field.h"

class QLabel;

namespace carom {

// The field of a value at the mouse. Tab asks for the next one; Enter, and leaving it, ends typing; Esc takes
// all back. What can't be taken is red, with its sentence.
class ValueField : public TypedField {
  Q_OBJECT

 public:
  // Takes a text, or returns one sentence on why it can't; `yields` if Enter was pressed with Ctrl.
  using Take = std::function<QString(const QString& text, bool yields)>;
  ValueField(Take take, QWidget* parent);

 signals:
  void nextAsked(bool forward);
  void finished();
  void cancelled();

 protected:
  QString take(const QString& text) override;
  bool event(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  Take take_;
  bool yields_ = false;
};

// A bubble over the scene whose value is typed: its name, the field, its unit, and a line under it.
class ValueBubble : public QFrame {
  Q_OBJECT

 public:
  ValueBubble(ValueField::Take take, QWidget* parent);

  struct Shown {
    QString name;     // "Speed"
    QString subject;  // "light"
    QString unit;
    QString text;    // of the value
    QString detail;  // may be empty
  };
  void show_value(const Shown& shown);
  void show_detail(const QString& text);  // may be empty
  // Puts the cursor into the value; `first` is typed over it, if it is not empty.
  void begin(const QString& first);
  // Forgets what is typed.
  void end();
  [[nodiscard]] ValueField& field() { return *field_; }

 signals:
  void resized();  // it needs another place

 private:
  void show_line(const QString& text, bool fault);

  QLabel* name_;
  ValueField* field_;
  QLabel* unit_;
  QLabel* line_;
  QLabel* fault_;
  QString detail_;
};

}  // namespace carom
