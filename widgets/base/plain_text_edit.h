#pragma once

#include <QMimeData>
#include <QPlainTextEdit>

namespace carom {

// Pasting from an empty clipboard, or from an empty X11 selection by a middle click, does nothing. Qt 6.4
// reads the first of the offered formats even where there is none.
class PlainTextEdit : public QPlainTextEdit {
 public:
  using QPlainTextEdit::QPlainTextEdit;

 protected:
  [[nodiscard]] bool canInsertFromMimeData(const QMimeData* source) const override {
    return offers_something(source) && QPlainTextEdit::canInsertFromMimeData(source);
  }
  void insertFromMimeData(const QMimeData* source) override {
    if (offers_something(source)) QPlainTextEdit::insertFromMimeData(source);
  }

 private:
  [[nodiscard]] static bool offers_something(const QMimeData* source) {
    return source != nullptr && !source->formats().isEmpty();
  }
};

}  // namespace carom
