#include <algorithm>
#include <utility>

#include "widgets/scene/hit.h"
#include "widgets/scene/scene_tools.h"

// Bodies that the scene's tools leave alone.
namespace carom {

bool SceneTools::all_locked() const {
  const std::vector<std::string>& names = selection_.names();
  return std::all_of(names.begin(), names.end(), [this](const std::string& n) { return locked_.contains(n); });
}

void SceneTools::toggle_lock() {
  const bool unlock = all_locked();
  for (const std::string& name : selection_.names()) {
    if (locked_.contains(name) == unlock) locked_.toggle(name);
  }
  row_ = {};
  emit changed();
}

void SceneTools::unlock_all() {
  locked_.set({});
  emit changed();
}

// Locks stay on bodies that get another name.
void SceneTools::rename_locked(const std::vector<Body>& before, const std::vector<Body>& after) {
  std::vector<std::string> names = locked_.names();
  for (std::string& name : names) {
    const auto old = std::find_if(before.begin(), before.end(), [&](const Body& b) { return b.name == name; });
    if (old == before.end() || old->id.number == 0) continue;
    const auto now = std::find_if(after.begin(), after.end(), [&](const Body& b) { return b.id == old->id; });
    if (now != after.end()) name = now->name;
  }
  locked_.set(names);
}

std::optional<std::string> SceneTools::locked_among(const std::vector<Body>& bodies) const {
  for (const Body& body : bodies) {
    if (locked_.contains(body.name)) return body.name;
  }
  return std::nullopt;
}

void SceneTools::say_locked(const std::string& name) {
  const SceneSight sight = sight_();
  const QPointF at = sight.camera.to_screen(body_now(*sight.frame, index_.at(name)).position);
  note({QStringLiteral("%1 is locked").arg(QString::fromStdString(name)), QStringLiteral("L unlocks it"), at,
        at, true});
}

void SceneTools::show_locks(Overlay& out) const {
  const SceneSight sight = sight_();
  if (!sight.frame || locked_.empty()) return;
  for (int i = 0; i < body_count(*sight.frame); ++i) {
    Body body = body_now(*sight.frame, i);
    if (locked_.contains(body.name)) out.locked.push_back(std::move(body));
  }
}

}  // namespace carom
