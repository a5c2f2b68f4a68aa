#pragma once

#include <QObject>
#include <optional>

#include "app/lab/lab_runs.h"

namespace carom {

// A drag through the record of the runs. A run that played plays on from where the mouse lets go. Escape,
// whoever has the keyboard's focus, goes back to where the drag began, and the rest of the drag moves nothing.
class Scrubbing : public QObject {
 public:
  explicit Scrubbing(LabRuns& runs) : runs_(runs) {}
  void begin();
  void to(double time);  // s
  void end();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  LabRuns& runs_;
  std::optional<LabRuns::ShownMoment> from_;  // none: no drag, or it is taken back
  bool plays_ = false;
};

}  // namespace carom
