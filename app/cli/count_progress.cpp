#include "app/cli/count_progress.h"

#include <fmt/format.h>
#include <unistd.h>
#include <utility>

#include "app/cli/standard_output.h"

namespace carom {

CountProgress::CountProgress(int all, const char* what)
    : all_(all), what_(what), terminal_(isatty(STDERR_FILENO) != 0) {
  show();
}

CountProgress::~CountProgress() {
  if (terminal_) write_err("\r\033[K");
}

void CountProgress::one_more() {
  const std::lock_guard lock(mutex_);
  ++done_;
  show();
}

void CountProgress::reach(int done) {
  const std::lock_guard lock(mutex_);
  if (std::exchange(done_, done) != done) show();
}

void CountProgress::show() const {
  if (terminal_) write_err(fmt::format("\r{} of {} {} ", done_, all_, what_));
}

}  // namespace carom
