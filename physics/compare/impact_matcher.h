#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <unordered_map>
#include <vector>

#include "physics/model/index.h"

namespace carom {

// Matches the impacts of two runs. Partners are impacts of the same two bodies, one in each run. In order,
// the k-th impact of the pair belongs to the k-th: right for runs of a scene that are known up to their end,
// however late a coarse method is. Nearest in time, an impact belongs to the nearest one that waits in the
// other run, and older ones stay without a partner: right for runs that continue, where one missed impact
// must not shift all that follow. Until the partner comes, the two bodies' velocities differ by the whole
// change of the impact, whatever the order of the method.
class ImpactMatcher {
 public:
  enum class From { kRun, kReference };
  enum class Partners { kInOrder, kNearest };

  explicit ImpactMatcher(Partners partners) : partners_(partners) {}

  void add(From from, BodyIndex a, BodyIndex b, double time) {
    if (take_partner(from, a, b, time)) return;
    Waiting& waiting = waiting_[key(a, b)];
    waiting.from = from;
    waiting.times.push_back(time);
  }
  // Matches the impact if its partner waits; otherwise it is not stored.
  bool take_partner(From from, BodyIndex a, BodyIndex b, double time) {
    const auto found = waiting_.find(key(a, b));
    if (found == waiting_.end() || found->second.times.empty() || found->second.from == from) return false;
    std::deque<double>& times = found->second.times;
    while (partners_ == Partners::kNearest && times.size() > 1 &&
           std::abs(times[1] - time) <= std::abs(times[0] - time)) {
      times.pop_front();
      ++unmatched_;
    }
    largest_difference_ = std::max(largest_difference_, std::abs(time - times.front()));
    ++matched_;
    times.pop_front();
    return true;
  }
  // Drops those that have waited since before `time`.
  void give_up(double time) {
    for (auto at = waiting_.begin(); at != waiting_.end();) {
      std::deque<double>& times = at->second.times;
      while (!times.empty() && times.front() < time) {
        times.pop_front();
        ++unmatched_;
      }
      at = times.empty() ? waiting_.erase(at) : std::next(at);
    }
  }
  void give_all_up() { give_up(std::numeric_limits<double>::infinity()); }
  // Sets `awaiting` to 1 for bodies that so far had an impact in one of the two runs only, and to 0 for the
  // others.
  void mark(std::vector<std::uint8_t>& awaiting) const {
    std::fill(awaiting.begin(), awaiting.end(), std::uint8_t{0});
    for (const auto& [pair, waiting] : waiting_) {
      if (waiting.times.empty()) continue;
      awaiting[static_cast<std::size_t>(pair >> 32U)] = 1;
      awaiting[static_cast<std::size_t>(pair & 0xFFFFFFFFU)] = 1;
    }
  }
  [[nodiscard]] bool awaits_any() const {
    return std::any_of(waiting_.begin(), waiting_.end(), [](const auto& w) { return !w.second.times.empty(); });
  }

  [[nodiscard]] std::int64_t matched() const { return matched_; }
  [[nodiscard]] std::int64_t unmatched() const { return unmatched_; }
  [[nodiscard]] double largest_difference() const { return largest_difference_; }  // s, of matched ones

 private:
  // Waiting impacts of one pair, from one of the two runs, in the order of time.
  struct Waiting {
    From from = From::kRun;
    std::deque<double> times;  // s
  };
  static std::uint64_t key(BodyIndex a, BodyIndex b) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32U | static_cast<std::uint32_t>(b);
  }

  Partners partners_;
  std::unordered_map<std::uint64_t, Waiting> waiting_;
  std::int64_t matched_ = 0;
  std::int64_t unmatched_ = 0;
  double largest_difference_ = 0.0;
};

}  // namespace carom
