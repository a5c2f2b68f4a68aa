#pragma once

#include <QPoint>
#include <functional>

class QMenu;
class QWidget;

namespace carom {

class RunPlot;

// The entries of a plot's menu for the notes at this point of its canvas (px): to add one, or to change or
// remove the existing one. `changed` is called after that.
void add_note_entries(QMenu& menu, RunPlot& plot, const QPoint& at, QWidget* parent,
                      const std::function<void()>& changed);

}  // namespace carom
