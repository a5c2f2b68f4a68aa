#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace carom {

// Receives the completed share of some work, 0 to 1, now and then. Returns false to cancel the work.
using Progress = std::function<bool(double share)>;

// Runs long work, such as a replay, on a thread of its own, then calls `then` on this thread. If it takes
// long, a dialog over the window shows its progress and can cancel it; the event loop keeps running. An
// exception of the work is shown as a message with the title `failure`. `then` is not called after that, after
// Cancel, or when the window is gone.
void with_progress(QWidget* window, const QString& title, const QString& failure,
                   const std::function<void(const Progress&)>& work, const std::function<void()>& then = {});

}  // namespace carom
