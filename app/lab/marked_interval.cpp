#include "app/lab/marked_interval.h"

#include <QMetaObject>
#include <algorithm>
#include <exception>
#include <stop_token>
#include <utility>

namespace carom {

std::shared_ptr<const RunInterval> MarkedInterval::between(const Frame& newest, double a, double b) {
  const Asked asked{newest.setup, std::min(a, b), std::max(a, b)};
  if (asked.setup == nullptr || asked.from < start_time(asked.setup->saved) || asked.to > newest.time)
    return nullptr;
  if (std::exchange(asked_, asked) != asked) ask(newest);
  return found_;
}

void MarkedInterval::ask(const Frame& newest) {
  found_.reset();
  thread_ = std::jthread([this, asked = asked_, key_frames = newest.key_frames](const std::stop_token& stop) {
    std::shared_ptr<const RunInterval> interval;
    try {
      auto result = run_interval(*asked.setup, key_frames, asked.from, asked.to,
                                 [&stop] { return !stop.stop_requested(); });
      if (result) interval = std::make_shared<const RunInterval>(std::move(*result));
    } catch (const std::exception&) {
      return;  // the run itself reports what it lacks, as memory
    }
    QMetaObject::invokeMethod(
        this, [this, asked, interval] { take(asked, interval); }, Qt::QueuedConnection);
  });
}

void MarkedInterval::take(const Asked& asked, const std::shared_ptr<const RunInterval>& interval) {
  if (asked != asked_ || interval == nullptr) return;
  found_ = interval;
  emit found();
}

}  // namespace carom
