#pragma once

#include <vector>

class QWidget;

namespace carom {

// Gives the focus to the panel after, or before, the one that has it: to its first part that takes the focus
// by Tab, with the ring of the focus. Panels that are hidden, or have no such part, are passed over.
void focus_next_panel(const std::vector<QWidget*>& panels, bool forward);

}  // namespace carom
