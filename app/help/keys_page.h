#pragma once

#include <QString>
#include <span>

class QMenuBar;

namespace carom {

// Keys of the scene that no menu has, and what they do.
struct KeyText {
  int key;  // one of them
  Qt::KeyboardModifiers modifiers;
  const char* keys;  // all of them, for people
  const char* what;
};
[[nodiscard]] std::span<const KeyText> selection_keys();

// The page of keys, in Markdown: a table for each menu with the keys of its actions and submenus, and one for
// the keys that change the selected bodies.
[[nodiscard]] QString keys_page(const QMenuBar& menus);

}  // namespace carom
