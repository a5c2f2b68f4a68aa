#pragma once

#include <QUndoCommand>
#include <optional>
#include <vector>

#include "physics/compare/reference.h"
#include "physics/preset/preset.h"
#include "physics/worker/worker.h"

namespace carom {

class Session;

// The methods of a scene's runs, side by side, and their reference.
struct Methods {
  Method own;
  std::vector<Method> others;
  ReferenceId reference = ReferenceId::kNone;
};

// All parts of a document that edits change.
struct Edited {
  Methods methods;
  std::optional<Methods> before_usual;  // while Euler, RK4 and the exact run are compared
  std::vector<RunEdit> added;           // bodies that come in during the runs
  std::vector<Plot> plots;
};

// One change of the document, already made when it is pushed on the stack. Its change of the runs has an id.
class DocumentEdit : public QUndoCommand {
 public:
  struct What {
    QString text;               // "Undo ..."
    Worker::EditId runs = 0;    // 0: the runs do not change
    bool is_work = true;        // false: not worth saving
    std::optional<int> drag{};  // edits of one drag are undone together
  };

  DocumentEdit(Session& session, const What& what, Edited before, Edited after);
  [[nodiscard]] const What& what() const { return what_; }

  void undo() override;
  void redo() override;
  [[nodiscard]] int id() const override { return what_.drag ? 1 : -1; }
  bool mergeWith(const QUndoCommand* later) override;

 private:
  Session& session_;
  What what_;
  Edited before_, after_;
  bool made_ = true;
};

}  // namespace carom
