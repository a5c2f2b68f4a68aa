#pragma once

#include <QObject>
#include <QUndoStack>
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "app/lab/document_change.h"
#include "app/lab/document_edit.h"
#include "app/lab/lab_runs.h"

namespace carom {

// A document, its runs, and the undo stack of what was done to both. Who edits changes the runs and pushes the
// change of the document, as one step of undo.
class EditHistory : public QObject {
  Q_OBJECT

 public:
  explicit EditHistory(const Document& document);

  // Another document, at t = 0, whose runs record these curves. There is nothing to undo then.
  void load(const Document& document, const std::vector<Curve>& curves);
  [[nodiscard]] const Document& document() const { return document_; }
  // All bodies as they start, in the order of the runs.
  [[nodiscard]] const std::vector<Body>& bodies() const { return bodies_; }
  [[nodiscard]] LabRuns& runs() { return runs_; }
  [[nodiscard]] const LabRuns& runs() const { return runs_; }
  [[nodiscard]] QUndoStack& stack() { return stack_; }
  [[nodiscard]] const QUndoStack& stack() const { return stack_; }
  [[nodiscard]] std::uint64_t revision() const { return revision_; }  // changes with each edit

  // --- what an edit does
  // Makes the change, as a step of undo.
  void push(const DocumentEdit::What& what, const DocumentChange& change);
  // Whether the shown moment is there; tells why there can be no edit otherwise.
  [[nodiscard]] bool may_edit_moment();
  // Where a moment of the past is shown, the runs go on from there, under the methods of the document; what
  // came later is in `what`.
  void cut_at_shown(DocumentEdit::What& what);
  // The edits of the document's runs that such a cut leaves: what comes later is gone, but for the edits of the
  // file.
  [[nodiscard]] std::vector<RunEdit> edits_left() const;
  void refuse(const QString& why) { emit editRefused(why); }
  // The names of the bodies that are selected now: undo of a later edit of the scene asks for them again.
  void set_selection(const std::vector<std::string>& names) { selection_ = names; }
  // Without a step of undo: how the start came about, theories of other scenes, and one more id given to a
  // part.
  void set_origin(const StartOrigin& origin) { document_.start = origin; }
  void set_own_theories(const std::vector<OwnTheory>& theories) { document_.own_theories = theories; }
  void set_first_theories(const std::vector<Plot>& plots) { document_.first_theories = plots; }
  void count_id() { ++document_.preset.scene.ids_given; }
  void count_ids_to(std::uint32_t given) {
    document_.preset.scene.ids_given = std::max(document_.preset.scene.ids_given, given);
  }

  // --- what was done
  [[nodiscard]] const DocumentEdit* last_edit() const;  // none: nullptr
  // The last edit, if the undo stack makes one of it and another of this drag: not with a saved state.
  [[nodiscard]] const DocumentEdit* last_edit_of(int drag) const;
  [[nodiscard]] const DocumentEdit& edit_at(int place) const;

 signals:
  void documentChanged();
  void bodiesChanged();  // of the document, with its plots
  void plotsChanged();   // of the document, or which theories on them are of another scene
  void runsReturned();   // undo or redo shows runs as they were
  void editRefused(const QString& why);
  void editSaid(const QString& sentence);  // what an edit changed unasked; after documentChanged
  void selectionReturned(const std::vector<std::string>& names);

 private:
  friend class DocumentEdit;
  // Undo and redo of an edit; each returns the change that does the opposite.
  DocumentChange take_back(const DocumentChange& change, const DocumentEdit::What& what);
  DocumentChange make_again(const DocumentChange& change, const DocumentEdit::What& what);
  DocumentChange go_to(const DocumentChange& change, const DocumentEdit::What& what);
  // `begins`: the runs begin anew with it.
  DocumentChange assign(const DocumentChange& change, bool begins);
  void take_times_of_edits();

  Document document_;
  LabRuns runs_;
  std::vector<Body> bodies_;
  std::vector<std::string> selection_;
  QUndoStack stack_;
  std::uint64_t revision_ = 0;
};

}  // namespace carom
