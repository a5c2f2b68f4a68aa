#pragma once

#include <QObject>
#include <memory>
#include <thread>

#include "physics/record/frame.h"
#include "physics/record/run_interval.h"

namespace carom {

// The run between the marks A and B: repeated on a thread of its own, once for each run and its marks.
class MarkedInterval : public QObject {
  Q_OBJECT

 public:
  // Of the run of this newest frame, between two times (s) in any order. nullptr: it is not known yet, and
  // found() follows; or the run has not got there.
  [[nodiscard]] std::shared_ptr<const RunInterval> between(const Frame& newest, double a, double b);

 signals:
  void found();

 private:
  struct Asked {
    std::shared_ptr<const RunSetup> setup{};
    double from = 0.0;  // s
    double to = 0.0;    // s

    bool operator==(const Asked&) const = default;
  };
  void ask(const Frame& newest);
  void take(const Asked& asked, const std::shared_ptr<const RunInterval>& interval);

  Asked asked_;
  std::shared_ptr<const RunInterval> found_;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace carom
