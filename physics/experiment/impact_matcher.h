#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace carom {

// Tells of the impacts of two runs, as they come, which belong together: an impact of a pair of bodies belongs
// to the oldest of that pair in the other run that still waits for its partner. Until it comes the two bodies'
// velocities differ by as much as the impact changes them, whatever the order of the method. What has waited
// too long has no partner.
class ImpactMatcher {
 public:
  enum class From { kRun, kReference };

  void add(From from, int a, int b, double time) {
    const auto partner = std::find_if(waiting_.begin(), waiting_.end(),
                                      [&](const Waiting& w) { return w.from != from && w.a == a && w.b == b; });
    if (partner == waiting_.end()) {
      waiting_.push_back({from, a, b, time});
      return;
    }
    largest_difference_ = std::max(largest_difference_, std::abs(time - partner->time));
    ++matched_;
    waiting_.erase(partner);
  }
  // Gives those up that wait since before `time`.
  void give_up(double time) {
    unmatched_ += static_cast<int>(std::erase_if(waiting_, [time](const Waiting& w) { return w.time < time; }));
  }
  // Sets to 1 which bodies had an impact in one of the two runs only, so far; the others to 0.
  void mark(std::vector<std::uint8_t>& awaiting) const {
    std::fill(awaiting.begin(), awaiting.end(), std::uint8_t{0});
    for (const Waiting& w : waiting_) {
      awaiting[static_cast<std::size_t>(w.a)] = 1;
      awaiting[static_cast<std::size_t>(w.b)] = 1;
    }
  }
  [[nodiscard]] bool awaits_any() const { return !waiting_.empty(); }

  [[nodiscard]] int matched() const { return matched_; }
  [[nodiscard]] int unmatched() const { return unmatched_; }
  [[nodiscard]] double largest_difference() const { return largest_difference_; }  // s, of matched ones

 private:
  struct Waiting {
    From from;
    int a;
    int b;
    double time;
  };
  std::vector<Waiting> waiting_;
  int matched_ = 0;
  int unmatched_ = 0;
  double largest_difference_ = 0.0;
};

}  // namespace carom
