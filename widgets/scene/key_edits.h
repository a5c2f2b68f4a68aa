#pragma once

#include <QString>
#include <Qt>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/scene/edit.h"
#include "physics/scene/part_id.h"
#include "physics/scene/scene.h"
#include "widgets/edit/reshaping.h"

namespace carom {

enum class KeyEdit { kMove, kVelocity, kTurn, kResize, kRest, kReverse };

// What a key does to the selected bodies: arrows, with Ctrl for the velocity and with Shift ten times as much;
// [ and ], also < and >, which turn to the left and right; + and - for the size; 0; X. Nothing for other keys.
[[nodiscard]] std::optional<KeyEdit> key_edit(int key, Qt::KeyboardModifiers modifiers);
// The bodies after it; `step` (m) is that of a move.
[[nodiscard]] std::vector<Body> edited_by_key(std::span<const Body> bodies, int key,
                                              Qt::KeyboardModifiers modifiers, double step,
                                              Keeps keeps = Keeps::kDensity);
[[nodiscard]] QString name_of(KeyEdit edit, std::span<const Body> before, std::span<const Body> after);

// The value that it changed, with its unit; `scale` in px/m.
[[nodiscard]] QString value_of(KeyEdit edit, const Body& body, double scale);

struct Deletion {
  SceneEdits edits;
  QString name;   // "Delete light and 1 rod"
  QString links;  // "1 rod"; empty: none
};
// Takes bodies out, with all links and forces on them.
[[nodiscard]] Deletion deletion(const Scene& scene, std::span<const std::string> names);
// Takes out a part that is no body.
[[nodiscard]] Deletion deletion(const Scene& scene, const PartId& part);

}  // namespace carom
