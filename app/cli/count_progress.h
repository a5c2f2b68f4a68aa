#pragma once

#include <mutex>

namespace carom {

// A progress line on a terminal, "3 of 12 runs"; nothing in a pipe.
class CountProgress {
 public:
  explicit CountProgress(int all, const char* what = "runs");
  CountProgress(const CountProgress&) = delete;
  CountProgress& operator=(const CountProgress&) = delete;
  ~CountProgress();
  // From any thread.
  void one_more();
  void reach(int done);

 private:
  void show() const;
  std::mutex mutex_;
  int done_ = 0;
  int all_;
  const char* what_;
  bool terminal_;
};

}  // namespace carom
