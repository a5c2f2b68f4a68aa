#include "app/lab/document_edit.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "app/lab/edit_history.h"

namespace carom {
namespace {

// Whether both set the same thing, so that the earlier value alone is needed to take both back.
bool same_target(const SceneEdit& earlier, const SceneEdit& later) {
  if (earlier.index() != later.index()) return false;
  return std::visit(
      [&]<class Edit>(const Edit& edit) {
        if constexpr (
            requires { edit.at; } || requires { edit.id; }) {
          return false;  // adds or removes a part
        } else if constexpr (requires { edit.part; }) {
          return edit.part.id == std::get<Edit>(later).part.id;
        } else {
          return true;
        }
      },
      earlier);
}

bool restores(const DocumentChange& earlier, const SceneEdit& later) {
  return std::any_of(earlier.begin(), earlier.end(), [&](const auto& part) {
    if (std::holds_alternative<SetScene>(part)) return true;
    const auto* edits = std::get_if<SceneEdits>(&part);
    return edits != nullptr && std::any_of(edits->begin(), edits->end(),
                                           [&](const SceneEdit& edit) { return same_target(edit, later); });
  });
}

// Whether a change back undoes all that a later one would.
bool covers(const DocumentChange& earlier, const DocumentChange& later) {
  return std::all_of(later.begin(), later.end(), [&](const auto& part) {
    const auto* edits = std::get_if<SceneEdits>(&part);
    if (edits == nullptr) {
      return std::any_of(earlier.begin(), earlier.end(),
                         [&](const auto& other) { return other.index() == part.index(); });
    }
    return std::all_of(edits->begin(), edits->end(),
                       [&](const SceneEdit& edit) { return restores(earlier, edit); });
  });
}

// A later edit of a body in the same drag takes the place of an earlier one.
void take_up(SceneEdits& asked, const SceneEdits& later) {
  for (const SceneEdit& edit : later) {
    const auto* body = std::get_if<Replace<Body>>(&edit);
    const auto same = std::find_if(asked.begin(), asked.end(), [body](const SceneEdit& each) {
      const auto* earlier = std::get_if<Replace<Body>>(&each);
      return body != nullptr && earlier != nullptr && earlier->part.name == body->part.name;
    });
    if (same == asked.end()) {
      asked.push_back(edit);
    } else {
      Body& kept = std::get<Replace<Body>>(*same).part;
      const Id<Body> id = kept.id;  // that of a run's body may be another one in the start
      kept = body->part;
      kept.id = id;
    }
  }
}

}  // namespace

DocumentEdit::DocumentEdit(EditHistory& history, const What& what, DocumentChange back)
    : QUndoCommand(what.text), history_(history), what_(what), next_(std::move(back)) {}

void DocumentEdit::undo() { next_ = history_.take_back(next_, what_); }

void DocumentEdit::redo() {
  if (!std::exchange(made_, false)) next_ = history_.make_again(next_, what_);
}

bool DocumentEdit::mergeWith(const QUndoCommand* later) {
  const auto& other = static_cast<const DocumentEdit&>(*later);
  if (other.what_.drag != what_.drag) return false;
  setText(other.text());
  what_.text = other.what_.text;
  what_.begins = what_.begins || other.what_.begins;
  if (what_.left == 0) what_.left = other.what_.left;
  if (what_.leaves == nullptr) what_.leaves = other.what_.leaves;
  if (what_.said.isEmpty()) what_.said = other.what_.said;
  take_up(what_.asked, other.what_.asked);
  if (covers(next_, other.next_)) return true;
  DocumentChange both = other.next_;
  both.insert(both.end(), next_.begin(), next_.end());
  next_ = std::move(both);
  return true;
}

std::map<Worker::EditId, QString> names_of_run_edits(const QUndoStack& stack) {
  std::map<Worker::EditId, QString> names;
  for (int i = 0; i < stack.count(); ++i) {
    const DocumentEdit::What& what = static_cast<const DocumentEdit*>(stack.command(i))->what();
    if (what.runs != 0) names.emplace(what.runs, what.text);
  }
  return names;
}

}  // namespace carom
