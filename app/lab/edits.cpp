#include "app/lab/edits.h"

#include <utility>

#include "app/lab/session.h"

namespace carom {

DocumentEdit::DocumentEdit(Session& session, const What& what, Edited before, Edited after)
    : QUndoCommand(what.text),
      session_(session),
      what_(what),
      before_(std::move(before)),
      after_(std::move(after)) {}

void DocumentEdit::undo() { session_.undo(before_, what_.runs); }

void DocumentEdit::redo() {
  if (!std::exchange(made_, false)) session_.redo(after_, what_.runs);
}

// The runs return to their state before the first of them.
bool DocumentEdit::mergeWith(const QUndoCommand* later) {
  const auto& other = static_cast<const DocumentEdit&>(*later);
  if (other.what_.drag != what_.drag) return false;
  after_ = other.after_;
  return true;
}

}  // namespace carom
