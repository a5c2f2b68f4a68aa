#pragma once

#include <QUndoCommand>
#include <QUndoStack>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/lab/document_change.h"
#include "app/lab/lab_runs.h"
#include "physics/worker/worker.h"

namespace carom {

class EditHistory;

// One step of undo, already made when it is pushed on the stack. It holds the change that it makes next: the
// one back, or the one forth again.
class DocumentEdit : public QUndoCommand {
 public:
  struct What {
    QString text;                           // "Undo ..."
    Worker::EditId runs = 0;                // of the runs as they go on; 0: none
    bool begins = false;                    // the runs begin again, from the changed start
    Worker::EditId left = 0;                // the runs that it leaves, to return to; 0: none
    bool cuts = false;                      // it leaves them to go on from an earlier moment, unless it begins
    bool is_work = true;                    // false: not worth saving
    std::optional<int> drag{};              // edits of one drag are undone together
    std::vector<std::string> selection{};   // before it; names of bodies
    std::shared_ptr<const Start> leaves{};  // the start before it, if it is another one then
    std::shared_ptr<LabRuns::Entered> run{};  // it is a run
    SceneEdits asked{};                       // of the moment that became the new start
    QString said{};                           // what it changed unasked, in one sentence; empty: nothing
  };

  DocumentEdit(EditHistory& history, const What& what, DocumentChange back);
  [[nodiscard]] const What& what() const { return what_; }
  [[nodiscard]] const DocumentChange& next() const { return next_; }

  void undo() override;
  void redo() override;
  [[nodiscard]] int id() const override { return what_.drag ? 1 : -1; }
  bool mergeWith(const QUndoCommand* later) override;

 private:
  EditHistory& history_;
  What what_;
  DocumentChange next_;
  bool made_ = true;
};

// What the edits of the runs as they go on are called, by their ids.
[[nodiscard]] std::map<Worker::EditId, QString> names_of_run_edits(const QUndoStack& stack);

}  // namespace carom
