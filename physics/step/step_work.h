#pragma once

#include <algorithm>
#include <cstdint>
#include <stop_token>
#include <utility>

namespace carom {

// Thrown within a step after a stop was requested (see Simulation::interrupt_on).
struct StepInterrupted {};

// Budget of one step for the search for impacts, in units of about 0.1 µs. It is counted, not timed, so that
// a run is the same on every machine. When it is spent, the rest of the step's impacts are resolved at its
// end, and a notice reports it. From then on a step gets a fiftieth of the budget, and one shorter than
// kUsualStep even less, so that a run that always exceeds it continues at a bearable pace.
class StepWork {
 public:
  static constexpr std::int64_t kStep = 6'000'000;
  static constexpr std::int64_t kPerBody = 20'000;  // for each of the first kFew; a tenth for the others
  static constexpr int kFew = 1'000;
  static constexpr std::int64_t kReserve = 200'000'000;  // for a run: see spend_reserve()
  static constexpr double kOnceSpent = 0.02;
  static constexpr double kUsualStep = 0.005;  // s
  static constexpr double kLeastShare = 0.02;

  // What is kept from step to step.
  struct Kept {
    bool scarce = false;
    std::int64_t reserve = kReserve;
    bool impacts_capped = false;
  };
  [[nodiscard]] Kept kept() const { return {scarce_ || left_ <= 0, reserve_, impacts_capped_}; }
  void restore(const Kept& kept) {
    scarce_ = kept.scarce;
    reserve_ = kept.reserve;
    impacts_capped_ = kept.impacts_capped;
    left_ = 1;
  }

  // Starts a step of h s for so many bodies.
  void begin(int bodies, double h) {
    if (left_ <= 0) scarce_ = true;
    left_ = kStep + kPerBody * std::min(bodies, kFew) + kPerBody / 10 * std::max(bodies - kFew, 0);
    if (scarce_) {
      const double share = kOnceSpent * std::clamp(h / kUsualStep, kLeastShare, 1.0);
      left_ = static_cast<std::int64_t>(share * static_cast<double>(left_));
    }
  }
  // Throws StepInterrupted if a stop was requested, which is checked now and then.
  void spend(std::int64_t units) {
    left_ -= units;
    pass(units);
  }
  // The same for a search that is short while impacts are well separated, such as that of a disc and a static
  // box. It draws on a reserve for the whole run, large enough for the most impacts that a step may have.
  void spend_reserve(std::int64_t units) {
    reserve_ -= units;
    if (reserve_ < 0) left_ -= units;
    pass(units);
  }
  // Counts work that another limit covers.
  void pass(std::int64_t units) {
    since_look_ += units;
    if (since_look_ >= kLook) {
      since_look_ = 0;
      if (stop_.stop_requested()) throw StepInterrupted{};
    }
  }
  [[nodiscard]] bool spent() const { return left_ <= 0; }
  // A step has had as many impacts as one may have: later ones get fewer.
  void cap_impacts() { impacts_capped_ = true; }
  [[nodiscard]] bool impacts_capped() const { return impacts_capped_; }
  void stop_on(std::stop_token stop) { stop_ = std::move(stop); }

 private:
  static constexpr std::int64_t kLook = 10'000;
  std::int64_t left_ = 1;
  std::int64_t reserve_ = kReserve;
  std::int64_t since_look_ = 0;
  bool scarce_ = false;
  bool impacts_capped_ = false;
  std::stop_token stop_;
};

}  // namespace carom
