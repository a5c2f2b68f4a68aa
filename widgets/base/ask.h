#pragma once

#include <QString>
#include <functional>
#include <vector>

class QDialog;
class QWidget;

namespace carom {

// Questions to the user. Each function opens a dialog over the parent's window and returns at once; the answer
// comes later, or never if the user cancels or the window closes. There are no nested event loops.

// Shows a dialog and deletes it after the answer; `then` is called if the dialog was accepted.
void ask(QDialog* dialog, const std::function<void()>& then);

// What a message offers to do instead.
struct Offer {
  QString text;  // of its button; empty: nothing is offered
  std::function<void()> accept;
};
// A message to close: `text` in one line, `details` below it.
void show_message(QWidget* parent, const QString& title, const QString& text, const QString& details = {},
                  const Offer& offer = {});

// A filter of a file dialog, "Pictures (*.png *.svg)", and the default suffix.
struct FileKind {
  QString filter;
  QString suffix;
};
// Asks for a name to save under. An existing file is replaced only if the user confirms it.
void ask_for_file(QWidget* parent, const QString& title, const QString& suggestion,
                  const std::vector<FileKind>& kinds, const std::function<void(const QString&)>& then);

}  // namespace carom
