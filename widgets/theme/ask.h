#pragma once

#include <QString>
#include <functional>
#include <vector>

class QDialog;
class QWidget;

namespace carom {

// Questions to the reader. Each stands over the window of its parent and returns at once; the answer comes
// later, or never where the reader cancels or the window goes. No event loop runs within another.

// Shows a dialog, which is deleted after the answer; `then` is called if that is yes.
void ask(QDialog* dialog, const std::function<void()>& then);

// A message with one button: `text` in a line, `details` below it.
void tell(QWidget* parent, const QString& title, const QString& text, const QString& details = {});

// What a dialog for files offers: "Pictures (*.png *.svg)", and what a name without a suffix is given.
struct FileKind {
  QString filter;
  QString suffix;
};
// Under which name to save. A file that is there is replaced only where the reader says so.
void ask_for_file(QWidget* parent, const QString& title, const QString& suggestion,
                  const std::vector<FileKind>& kinds, const std::function<void(const QString&)>& then);

}  // namespace carom
