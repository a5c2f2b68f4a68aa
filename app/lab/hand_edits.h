#pragma once

#include <QObject>

#include "app/lab/edit_history.h"

namespace carom {

// The hand on a body of the runs, while they play: from the first pull until it is let go one step of undo. It
// belongs to the runs, not to the document.
class HandEdits : public QObject {
  Q_OBJECT

 public:
  explicit HandEdits(EditHistory& history);

  // The hand is at its place now. Nothing happens where the methods allow none (EditHistory::refuse()).
  void pull(const Hand& hand);
  void let_go();

 private:
  [[nodiscard]] QString why_not(const Hand& hand) const;  // empty: it may pull
  void forget_lost_hand();

  EditHistory& history_;
  LabRuns& runs_;             // its
  Worker::EditId edit_ = 0;   // of the hand that pulls; 0: none does
  bool refused_ = false;      // until it is let go
  bool let_go_since_ = true;  // by an edit that no frame has shown yet
};

}  // namespace carom
