#pragma once

#include <QObject>
#include <utility>
#include <vector>

#include "app/lab/edit_history.h"

namespace carom {

// The edits of the methods under which a document's runs go on, side by side, and of their reference; each is a
// step of undo. Run 0 has the scene's own method.
class MethodEdits : public QObject {
  Q_OBJECT

 public:
  explicit MethodEdits(EditHistory& history);

  // Changes a method from now on, of one or several runs. Changes of one `drag` are undone together.
  void change(const Method& method, std::size_t run = 0);
  void change_step(double step, const std::vector<std::size_t>& runs, int drag);
  // Adds a method, or replaces the last one if there are too many.
  void add(const Method& method);
  void remove(std::size_t run);
  void choose_reference(ReferenceId reference);
  // Restarts under the method of the reference, explicit Euler and RK4; or returns to the earlier comparison.
  // Shows `plots` then.
  void compare_usual(const std::vector<Plot>& plots, const std::vector<Curve>& curves);
  [[nodiscard]] bool compares_usual() const { return document().before_usual.has_value(); }

 private:
  [[nodiscard]] const Document& document() const { return history_.document(); }
  [[nodiscard]] bool is_run(std::size_t run) const { return run <= document().preset.compare.size(); }
  [[nodiscard]] SetMethods set(const Methods& methods) const { return {methods, document().before_usual}; }
  // The runs whose methods have changed to those of `after` go on under them from the shown moment.
  void go_on_under(const std::vector<std::pair<std::size_t, Method>>& changed, const Methods& after,
                   DocumentEdit::What what);

  EditHistory& history_;
  LabRuns& runs_;  // its
};

}  // namespace carom
