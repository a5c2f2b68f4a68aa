#pragma once

#include <QMimeData>
#include <QPlainTextEdit>

namespace carom {

// Qt asks a text field to paste also where the clipboard, or the X11 selection that a middle click pastes, is
// empty; its own answer to that reads what isn't there.
class PlainTextEdit : public QPlainTextEdit {
 public:
  using QPlainTextEdit::QPlainTextEdit;

 protected:
  [[nodiscard]] bool canInsertFromMimeData(const QMimeData* source) const override {
    return source != nullptr && QPlainTextEdit::canInsertFromMimeData(source);
  }
  void insertFromMimeData(const QMimeData* source) override {
    if (source != nullptr) QPlainTextEdit::insertFromMimeData(source);
  }
};

}  // namespace carom
