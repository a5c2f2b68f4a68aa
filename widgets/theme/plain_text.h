#pragma once

#include <QLabel>
#include <QString>

namespace carom {

// What somebody else wrote, such as the title of a preset or the name of a file, is shown letter for letter. Qt
// takes a text that looks like HTML for HTML, and opens the files that it names.

// A label that never takes its text for HTML.
class PlainLabel : public QLabel {
 public:
  explicit PlainLabel(QWidget* parent = nullptr) : PlainLabel(QString(), parent) {}
  explicit PlainLabel(const QString& text, QWidget* parent = nullptr) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setText(text);
  }
};

// A tooltip that shows `text` as it is, also where Qt guesses its format: lines stay lines, long ones wrap.
[[nodiscard]] QString plain_tip(const QString& text);

// From now on message boxes of Qt's own, such as a file dialog's that names a file, show plain text as well.
void keep_messages_plain();

}  // namespace carom
