#include "physics/run/step_again.h"

namespace carom {

void StepAgain::begins(const Simulation& run, double h) {
  start_.reset();
  ++steps_;
  if (!copy_ || !whole_ || steps_ >= kStepsBetweenCopies) {
    copy_ = std::make_unique<Simulation>(run);
    steps_ = 0;
  }
  whole_ = h == run.method().step;
}

Simulation StepAgain::made(double length) {
  if (!start_) {
    start_ = std::make_unique<Simulation>(*copy_);
    for (int i = 0; i < steps_; ++i) start_->step();
    while (start_->due() != nullptr) start_->apply_due();
  }
  Simulation again = *start_;
  if (length > 0.0) again.step(length);
  return again;
}

}  // namespace carom
