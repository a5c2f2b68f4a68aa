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

  // The hand is at its place now. Methods that allow none become others, as a part of the same step of undo.
  // Nothing happens where the record is played (EditHistory::refuse()).
  void pull(const Hand& hand);
  void let_go();

 private:
  void forget_lost_hand();

  EditHistory& history_;
  LabRuns& runs_;            // its
  Worker::EditId edit_ = 0;  // of the hand that pulls; 0: none does
  bool refused_ = false;     // until it is let go
  int lost_ = 0;             // frames in a row with a hand that nobody moves
};

}  // namespace carom
