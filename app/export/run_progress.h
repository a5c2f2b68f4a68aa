#pragma once

#include <QElapsedTimer>
#include <QProgressDialog>

namespace carom {

// Tells how far something is that goes through a run once more, with a way to cancel it; shown only where that
// takes a while. Meanwhile the window goes on.
class RunProgress {
 public:
  RunProgress(const QString& title, QWidget* parent);
  // `share` of the work is done, 0 to 1. False: the user has cancelled it.
  bool operator()(double share);

 private:
  QProgressDialog dialog_;
  QElapsedTimer told_;
};

}  // namespace carom
