#pragma once

#include <algorithm>
#include <cstdint>
#include <stop_token>
#include <utility>

namespace carom {

// Thrown within a step that somebody asked to stop (see Simulation::interrupt_on).
struct StepInterrupted {};

// What the search for impacts may cost in one step, in units of about 0.1 µs, counted and not timed so
// that a run is the same on every machine. Where it is spent, what is left of the step's impacts is resolved at
// its end, and the run says so; from then on steps get a fiftieth of it, and shorter ones than kUsualStep less
// still, so that a run for which it is never enough goes on at a bearable pace.
class StepWork {
 public:
  static constexpr std::int64_t kStep = 6'000'000;
  static constexpr std::int64_t kPerBody = 20'000;  // of the first kFew, of the others a tenth
  static constexpr int kFew = 1'000;
  static constexpr std::int64_t kReserve = 200'000'000;  // of a run: see spend_reserve()
  static constexpr double kOnceSpent = 0.02;
  static constexpr double kUsualStep = 0.005;  // s
  static constexpr double kLeastShare = 0.02;

  // What it remembers from step to step.
  struct Kept {
    bool scarce = false;
    std::int64_t reserve = kReserve;
  };
  [[nodiscard]] Kept kept() const { return {scarce_ || left_ <= 0, reserve_}; }
  void put_back(const Kept& kept) {
    scarce_ = kept.scarce;
    reserve_ = kept.reserve;
    left_ = 1;
  }

  // A step of h s of so many bodies.
  void begin(int bodies, double h) {
    if (left_ <= 0) scarce_ = true;
    left_ = kStep + kPerBody * std::min(bodies, kFew) + kPerBody / 10 * std::max(bodies - kFew, 0);
    if (scarce_) {
      const double share = kOnceSpent * std::clamp(h / kUsualStep, kLeastShare, 1.0);
      left_ = static_cast<std::int64_t>(share * static_cast<double>(left_));
    }
  }
  // Throws StepInterrupted if the step is to stop; looked at now and then.
  void spend(std::int64_t units) {
    left_ -= units;
    pass(units);
  }
  // The same for a search that is short as long as impacts are told apart, such as that of a disc and a fixed
  // box: from a reserve of the whole run, which is large enough for the most impacts that a step may have.
  void spend_reserve(std::int64_t units) {
    reserve_ -= units;
    if (reserve_ < 0) left_ -= units;
    pass(units);
  }
  // Work that another limit is for.
  void pass(std::int64_t units) {
    since_look_ += units;
    if (since_look_ >= kLook) {
      since_look_ = 0;
      if (stop_.stop_requested()) throw StepInterrupted{};
    }
  }
  [[nodiscard]] bool spent() const { return left_ <= 0; }
  void stop_on(std::stop_token stop) { stop_ = std::move(stop); }

 private:
  static constexpr std::int64_t kLook = 10'000;
  std::int64_t left_ = 1;
  std::int64_t reserve_ = kReserve;
  std::int64_t since_look_ = 0;
  bool scarce_ = false;
  std::stop_token stop_;
};

}  // namespace carom
