#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "physics/model/index.h"

namespace carom {

// A scheduled event: bodies a and b collide, or (b < 0) the trajectory of a's island ends. The stamps are those
// of the islands of a and b when the event was scheduled; it is stale once one of them has changed.
struct Event {
  double time = 0.0;  // s after the epoch
  BodyIndex a;
  BodyIndex b;
  std::uint32_t stamp_a = 0;
  std::uint32_t stamp_b = 0;
};

// Events in the order of time. At one time trajectories end first, then impacts follow in the order of index
// pairs. A binary heap; stale events stay in it until their time comes or a sweep removes them.
class EventQueue {
 public:
  void clear() {
    heap_.clear();
    sweep_at_ = kFewest;
  }
  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] const std::vector<Event>& all() const { return heap_; }  // in no order
  [[nodiscard]] const Event& next() const { return heap_.front(); }
  // Makes all times `by` earlier. Rounding may make two times equal, so the heap is rebuilt.
  void shift(double by) {
    for (Event& event : heap_) event.time -= by;
    std::make_heap(heap_.begin(), heap_.end(), Later{});
  }
  // Drops the events for which is_stale(event) is true, once they may outnumber the others: in constant time
  // per event, amortized. The queue never exceeds twice the largest number of valid events (or kFewest).
  template <class IsStale>
  void sweep(const IsStale& is_stale) {
    if (heap_.size() < sweep_at_) return;
    heap_.erase(std::remove_if(heap_.begin(), heap_.end(), is_stale), heap_.end());
    std::make_heap(heap_.begin(), heap_.end(), Later{});
    sweep_at_ = std::max(kFewest, 2 * heap_.size());
  }
  void push(const Event& event) {
    heap_.push_back(event);
    std::push_heap(heap_.begin(), heap_.end(), Later{});
  }
  void pop() {
    std::pop_heap(heap_.begin(), heap_.end(), Later{});
    heap_.pop_back();
  }

 private:
  struct Later {
    bool operator()(const Event& x, const Event& y) const {
      if (x.time != y.time) return x.time > y.time;
      const bool x_is_pair = x.b >= 0;
      const bool y_is_pair = y.b >= 0;
      return std::tie(x_is_pair, x.a, x.b) > std::tie(y_is_pair, y.a, y.b);
    }
  };
  static constexpr std::size_t kFewest = 1024;
  std::vector<Event> heap_;
  std::size_t sweep_at_ = kFewest;
};

}  // namespace carom
