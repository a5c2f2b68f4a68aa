#pragma once

#include <QUndoCommand>
#include <optional>
#include <vector>

#include "physics/compare/reference.h"
#include "physics/preset/preset.h"
#include "physics/session/worker.h"

namespace carom {

class Session;

// The methods that a scene runs under, side by side, and what they are compared with.
struct Methods {
  Method own;
  std::vector<Method> others;
  ReferenceId reference = ReferenceId::kNone;
};

// All of a document that edits change.
struct Edited {
  Methods methods;
  std::optional<Methods> before_usual;  // while Euler, RK4 and the exact run are compared
  std::vector<Body> put_in;
  std::vector<Plot> plots;
};

// One change of the document, made already when it comes onto the stack. What it did to the runs has a name.
class DocumentEdit : public QUndoCommand {
 public:
  struct What {
    QString text;               // "Undo ..."
    Worker::EditId runs = 0;    // 0: they don't change
    bool is_work = true;        // false: nothing that could be lost
    std::optional<int> drag{};  // edits of one drag are undone as one
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
