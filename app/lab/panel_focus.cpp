#include "app/lab/panel_focus.h"

#include <QApplication>
#include <QWidget>
#include <algorithm>

namespace carom {
namespace {

bool holds(const QWidget* panel, const QWidget* inner) {
  return inner != nullptr && (panel == inner || panel->isAncestorOf(inner));
}

QWidget* first_stop(QWidget* panel) {
  QWidget* each = panel;
  do {
    const bool stops = (each->focusPolicy() & Qt::TabFocus) == Qt::TabFocus && each->focusProxy() == nullptr;
    if (stops && holds(panel, each) && each->isVisible() && each->isEnabled()) return each;
    each = each->nextInFocusChain();
  } while (each != panel);
  return nullptr;
}

}  // namespace

void focus_next_panel(const std::vector<QWidget*>& panels, bool forward) {
  const auto count = static_cast<int>(panels.size());
  const auto now = std::find_if(panels.begin(), panels.end(),
                                [](const QWidget* panel) { return holds(panel, QApplication::focusWidget()); });
  int index = now == panels.end() ? (forward ? -1 : count) : static_cast<int>(now - panels.begin());
  for (int k = 0; k < count; ++k) {
    index = (index + (forward ? 1 : count - 1)) % count;
    QWidget* panel = panels[static_cast<std::size_t>(index)];
    QWidget* stop = panel->isVisible() ? first_stop(panel) : nullptr;
    if (stop == nullptr) continue;
    stop->activateWindow();
    return stop->setFocus(forward ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  }
}

}  // namespace carom
