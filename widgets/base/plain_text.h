#pragma once

#include <QLabel>
#include <QString>

namespace carom {

// Foreign text, such as the title of a preset or the name of a file, is shown letter for letter. Otherwise Qt
// interprets text that looks like HTML, and opens the files that it names.

// A label that never interprets its text as HTML.
class PlainLabel : public QLabel {
 public:
  explicit PlainLabel(QWidget* parent = nullptr) : PlainLabel(QString(), parent) {}
  explicit PlainLabel(const QString& text, QWidget* parent = nullptr) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setText(text);
  }
};

// A tooltip that shows `text` unchanged although Qt guesses the format: line breaks are kept, long lines wrap.
[[nodiscard]] QString plain_tip(const QString& text);

// From now on Qt's own message boxes, such as that of a file dialog, show plain text too.
void keep_messages_plain();

}  // namespace carom
