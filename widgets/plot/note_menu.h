#pragma once

#include <QPoint>
#include <functional>

class QMenu;
class QWidget;

namespace carom {

class RunPlot;

// The entries of a plot's menu for the notes at this point of its canvas (px): to put one there, or to change
// or remove the one that is there. `changed` is called when the reader has done so.
void add_note_entries(QMenu& menu, RunPlot& plot, const QPoint& at, QWidget* parent,
                      const std::function<void()>& changed);

}  // namespace carom
