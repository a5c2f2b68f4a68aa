#include "physics/run/step_again.h"

#include <utility>

namespace carom {

void StepAgain::begins(const Simulation& run, double h) {
  ++steps_;
  if (start_) {  // steps that are made again often come one after the other
    copy_ = std::exchange(start_, std::nullopt);
    steps_ = 1;
  }
  if (!copy_ || !whole_ || steps_ >= kStepsBetweenCopies) {
    copy_ = run;
    steps_ = 0;
  }
  whole_ = h == run.next_step();
}

Simulation StepAgain::made(double length) {
  if (!start_) {
    start_ = copy_;
    for (int i = 0; i < steps_; ++i) start_->step();
    while (start_->due() != nullptr) start_->apply_due();
  }
  Simulation again = *start_;
  if (length > 0.0) again.step(length);
  return again;
}

}  // namespace carom
