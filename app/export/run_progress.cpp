#include "app/export/run_progress.h"

#include <QCoreApplication>

namespace carom {
namespace {

constexpr int kParts = 1000;
constexpr int kPeriod = 30;       // ms between two looks at the window's events
constexpr int kShownAfter = 500;  // ms

}  // namespace

RunProgress::RunProgress(const QString& title, QWidget* parent)
    : dialog_(QCoreApplication::translate("RunProgress", "Going through the run once more"),
              QCoreApplication::translate("RunProgress", "Cancel"), 0, kParts, parent) {
  dialog_.setWindowTitle(title);
  dialog_.setWindowModality(Qt::WindowModal);
  dialog_.setMinimumDuration(kShownAfter);
  told_.start();
}

bool RunProgress::operator()(double share) {
  if (told_.elapsed() >= kPeriod) {
    dialog_.setValue(static_cast<int>(kParts * share));
    QCoreApplication::processEvents();
    told_.restart();
  }
  return !dialog_.wasCanceled();
}

}  // namespace carom
