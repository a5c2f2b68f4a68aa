#include <algorithm>
#include <utility>

#include "widgets/scene/hit.h"
#include "widgets/scene/scene_tools.h"

// What the scene's tools have selected.
namespace carom {

void SceneTools::set_selection(const std::vector<std::string>& names) {
  awaited_.clear();
  waiting_keys_.clear();
  stay_.set({});
  choose(std::nullopt);
  if (!selection_.set(names)) return;
  if (!note_of_ || names != std::vector{note_of_->body}) end_note();
  emit selectionChanged(selection_.names());
  emit changed();
}

void SceneTools::select(const std::vector<std::string>& names) {
  if (!names.empty() && !index_.contains(names.back())) return select_when_shown(names);
  std::vector<std::string> known;
  std::copy_if(names.begin(), names.end(), std::back_inserter(known),
               [this](const std::string& name) { return index_.contains(name); });
  set_selection(known);
}

void SceneTools::select_awaited() {
  if (awaited_.empty() || !index_.contains(awaited_.back())) return;
  auto keys = std::exchange(waiting_keys_, {});
  select(std::exchange(awaited_, {}));
  waiting_keys_ = std::move(keys);
}

bool SceneTools::select_next(bool forward) {
  if (!bodies_ || bodies_->empty()) return false;
  const int count = static_cast<int>(bodies_->size());
  int next = forward ? 0 : count - 1;
  if (!selection_.empty()) next = index_.at(selection_.names().back()) + (forward ? 1 : -1);
  if (next < 0 || next >= count) return false;
  const std::string& name = (*bodies_)[static_cast<std::size_t>(next)].name;
  Selection stay = stay_;
  std::vector<std::string> names = stay.names();
  std::erase(names, name);
  names.push_back(name);
  set_selection(names);
  stay_ = std::move(stay);
  return true;
}

// Of the selected bodies the last one, from which Tab goes on.
void SceneTools::toggle_stay() {
  const std::string& name = selection_.names().back();
  Selection stay = stay_;
  for (const std::string& other : selection_.names()) {
    if (other != name && !stay.contains(other)) stay.toggle(other);
  }
  stay.toggle(name);
  stay_ = std::move(stay);
  const SceneSight sight = sight_();
  const QPointF at = sight.camera.to_screen(body_now(*sight.frame, index_.at(name)).position);
  const QString shown = QString::fromStdString(name);
  if (stay_.contains(name)) {
    note({.value = QStringLiteral("%1 stays selected").arg(shown),
          .detail = QStringLiteral("Tab adds another one"),
          .mouse = at,
          .from = at});
  } else {
    note({.value = QStringLiteral("Tab goes on from %1").arg(shown), .detail = {}, .mouse = at, .from = at});
  }
}

std::vector<int> SceneTools::selected_indices() const {
  std::vector<int> indices;
  for (const std::string& name : selection_.names()) indices.push_back(index_.at(name));
  return indices;
}

}  // namespace carom
