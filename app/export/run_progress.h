#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace carom {

// Told now and then which share of some work is done, 0 to 1. False: the work is to be left.
using Progress = std::function<bool(double share)>;

// Does work that goes through a run once more on a thread of its own, then calls `then` here. Where it takes
// long, a dialog over the window tells how far it is and can cancel it: the event loop goes on meanwhile. What
// the work throws is told as a message under the title `failure`. `then` isn't called after that, nor after
// Cancel, nor when the window is gone.
void with_progress(QWidget* window, const QString& title, const QString& failure,
                   const std::function<void(const Progress&)>& work, const std::function<void()>& then = {});

}  // namespace carom
