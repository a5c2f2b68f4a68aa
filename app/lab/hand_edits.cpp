#include "app/lab/hand_edits.h"

#include <algorithm>

namespace carom {

HandEdits::HandEdits(EditHistory& history) : history_(history), runs_(history.runs()) {
  // Other steps of undo, made or taken back meanwhile, end it.
  connect(&history.stack(), &QUndoStack::indexChanged, this, [this] {
    const DocumentEdit* last = history_.last_edit();
    if (edit_ == 0 || (last != nullptr && last->what().runs == edit_)) return;
    edit_ = 0;
    refused_ = true;
  });
  connect(&runs_, &LabRuns::framesChanged, this, &HandEdits::forget_lost_hand);
}

void HandEdits::pull(const Hand& hand) {
  if (refused_) return;
  if (edit_ != 0) {
    runs_.worker().edit_scene({SetHand{hand}}, edit_);
    return;
  }
  refused_ = runs_.in_past() || runs_.replayed();
  if (runs_.in_past()) return history_.refuse(tr("The record is played: G goes on from here."));
  if (runs_.replayed()) return history_.refuse(tr("The run is replayed after an edit."));
  Scene scene = history_.document().preset.scene;
  scene.forces.hand = hand;
  const DocumentChange change = change_of_methods(history_.document(), scene);
  const auto methods = methods_changed(history_.document(), change);
  const Worker::EditId edit = runs_.edit(methods, {SetHand{hand}}, 0);
  history_.push(
      {.text =
           tr("Throw %1 at %2 s").arg(QString::fromStdString(hand.body)).arg(runs_.frame()->time, 0, 'f', 3),
       .runs = edit,
       .is_work = !methods.empty(),
       .said = said_of_methods(history_.document(), change, scene)},
      change);
  edit_ = edit;
}

void HandEdits::let_go() {
  if (edit_ != 0) runs_.worker().edit_scene({SetHand{}}, edit_);
  edit_ = 0;
  refused_ = false;
}

// A hand that nobody moves any more, as after redo of a throw that undo has broken off, is let go. Frames from
// before an undo may still have one.
void HandEdits::forget_lost_hand() {
  constexpr int kSurely = 4;  // frames
  const Frame& newest = *runs_.newest().front();
  const bool lost = newest.hand && edit_ == 0 && !runs_.replayed() && runs_.plays();
  lost_ = lost ? lost_ + 1 : 0;
  if (lost_ != kSurely) return;
  const std::vector<RunEdit>& edits = newest.setup->edits;
  const auto of_hand = std::find_if(edits.rbegin(), edits.rend(), moves_hand);
  if (of_hand != edits.rend()) runs_.worker().edit_scene({SetHand{}}, of_hand->id);
}

}  // namespace carom
