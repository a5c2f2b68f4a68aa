#include "app/count_progress.h"

#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace carom {

CountProgress::CountProgress(int all) : all_(all), terminal_(isatty(STDERR_FILENO) != 0) { show(); }

CountProgress::~CountProgress() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

void CountProgress::one_more() {
  const std::lock_guard lock(mutex_);
  ++done_;
  show();
}

void CountProgress::show() const {
  if (terminal_) fmt::print(stderr, "\r{} of {} runs ", done_, all_);
}

}  // namespace carom
