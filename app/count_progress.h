#pragma once

#include <mutex>

namespace carom {

// A line on a terminal that says how much of the work is done; nothing in a pipe.
class CountProgress {
 public:
  explicit CountProgress(int all);
  CountProgress(const CountProgress&) = delete;
  CountProgress& operator=(const CountProgress&) = delete;
  ~CountProgress();
  // From any thread.
  void one_more();

 private:
  void show() const;
  std::mutex mutex_;
  int done_ = 0;
  int all_;
  bool terminal_;
};

}  // namespace carom
