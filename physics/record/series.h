#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace carom {

// The newest `capacity` records of a sequence, oldest first.
template <class Record>
class Ring {
 public:
  explicit Ring(std::size_t capacity) : capacity_(capacity) {}

  [[nodiscard]] std::size_t size() const { return records_.size(); }
  [[nodiscard]] bool full() const { return records_.size() == capacity_; }
  [[nodiscard]] const Record& operator[](std::size_t i) const {
    const std::size_t at = oldest_ + i;
    return records_[at < records_.size() ? at : at - records_.size()];
  }
  [[nodiscard]] const Record& back() const { return (*this)[size() - 1]; }
  // A full ring drops its oldest record.
  void push(const Record& record) {
    if (!full()) {
      records_.push_back(record);
      return;
    }
    records_[oldest_] = record;
    oldest_ = oldest_ + 1 == capacity_ ? 0 : oldest_ + 1;
  }
  // Drops the newest records for which the predicate is true.
  template <class Predicate>
  void drop_back_while(const Predicate& is_to_go) {
    std::rotate(records_.begin(), records_.begin() + static_cast<std::ptrdiff_t>(oldest_), records_.end());
    oldest_ = 0;
    while (!records_.empty() && is_to_go(records_.back())) records_.pop_back();
  }
  // The first record not before `time` (lower) or after it (upper), by the records' function time().
  [[nodiscard]] std::size_t lower_bound(double time) const {
    return first([time](const Record& r) { return r.time() >= time; });
  }
  [[nodiscard]] std::size_t upper_bound(double time) const {
    return first([time](const Record& r) { return r.time() > time; });
  }

 private:
  // The first record for which the predicate is true; it must be true for all that follow.
  template <class Predicate>
  [[nodiscard]] std::size_t first(const Predicate& is_past) const {
    std::size_t low = 0;
    std::size_t high = size();
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (is_past((*this)[middle])) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }

  std::size_t capacity_;
  std::size_t oldest_ = 0;
  std::vector<Record> records_;
};

// K values at one time.
template <int K>
struct SeriesPoint {
  double at = 0.0;  // s
  std::array<double, K> value{};

  [[nodiscard]] double time() const { return at; }
  bool operator==(const SeriesPoint&) const = default;
};

// K quantities over time in almost constant memory: the newest points, and levels of buckets for all points.
// A bucket keeps the first and the last of its points and those with the smallest and the largest of each
// value, so that a spike of one point is seen at any scale. A bucket of the finest level covers 16 points,
// one of each further level four of the level before. Each level keeps its newest 8192 buckets; a coarser
// level is added when a level is full. So one level always reaches back to the start, with at least 2048
// buckets.
template <int K>
class Series {
 public:
  using Point = SeriesPoint<K>;
  static constexpr std::size_t kPoints = 32768;
  static constexpr std::size_t kBuckets = 8192;
  static constexpr int kFirstFan = 16;  // points to a bucket of the finest level
  static constexpr int kFan = 4;        // buckets to one of the next

  // In the order of time; equal times are a jump. A point with a non-finite value is left out.
  void append(const Point& point) {
    const bool finite =
        std::all_of(point.value.begin(), point.value.end(), [](double v) { return std::isfinite(v); });
    if (!finite || !std::isfinite(point.at)) return;
    ++count_;
    if (levels_.empty() && points_.full()) {
      levels_.emplace_back();
      for (std::size_t i = 0; i < points_.size(); ++i) take(0, points_[i]);
    }
    points_.push(point);
    if (!levels_.empty()) take(0, point);
  }

  // Drops the points from `time` on. Where more than the newest points go, the coarser levels end with what
  // their last buckets kept.
  void cut(double time) {
    points_.drop_back_while([time](const Point& p) { return p.at >= time; });
    for (std::size_t k = 0; k < levels_.size(); ++k) {
      Level& level = levels_[k];
      Open rest;
      level.closed.drop_back_while([&](const Bucket& bucket) {
        if (bucket.back().at < time) return false;
        rest = {};
        for (const Point& p : bucket) {
          if (p.at < time) rest.add(p);
        }
        rest.taken = rest.order > 0 ? 1 : 0;
        return true;
      });
      // From the points or the finer buckets that follow the last closed one, if they are still there.
      const double closed = level.closed.size() > 0 ? level.closed.back().back().at : -kInfinity;
      level.open = {};
      const auto take_after = [&](const auto& ring, const auto& add) {
        for (std::size_t i = ring.upper_bound(closed); i < ring.size(); ++i, ++level.open.taken) add(ring[i]);
      };
      if (k == 0) {
        take_after(points_, [&](const Point& p) { level.open.add(p); });
      } else {
        take_after(levels_[k - 1].closed, [&](const Bucket& bucket) {
          for (const Point& p : bucket) level.open.add(p);
        });
      }
      if (level.open.taken == 0 && (k == 0 ? points_.size() : levels_[k - 1].closed.size()) == 0)
        level.open = rest;
    }
  }

  [[nodiscard]] std::int64_t count() const { return count_; }         // of all that were appended
  [[nodiscard]] const Point& last() const { return points_.back(); }  // of at least one
  // s: from here on every point is kept.
  [[nodiscard]] double whole_since() const {
    if (levels_.empty()) return -kInfinity;
    return points_.size() == 0 ? kInfinity : points_[0].at;
  }
  // The newest known point that is not after `time`; nullptr if there is none. It is certain that no other
  // point came after it only from whole_since() on.
  [[nodiscard]] const Point* at(double time) const {
    if (time >= whole_since()) {
      const std::size_t after = points_.upper_bound(time);
      return after == 0 ? nullptr : &points_[after - 1];
    }
    for (const Level& level : levels_) {
      const std::size_t after = level.closed.upper_bound(time);
      if (after == 0) continue;
      const Bucket& bucket = level.closed[after - 1];
      return &*std::find_if(bucket.rbegin(), bucket.rend(), [&](const Point& p) { return p.at <= time; });
    }
    return nullptr;
  }
  // The oldest point after `time` that is still kept; nullptr if there is none.
  [[nodiscard]] const Point* after(double time) const {
    const std::size_t next = points_.upper_bound(time);
    return next == points_.size() ? nullptr : &points_[next];
  }
  // The oldest known point after `time`; nullptr if there is none. It is certain that no other point came
  // before it only from whole_since() on.
  [[nodiscard]] const Point* known_after(double time) const {
    const Point* oldest = after(time);
    for (const Level& level : levels_) {
      const std::size_t next = level.closed.upper_bound(time);
      for (std::size_t i = next > 0 ? next - 1 : next; i < level.closed.size() && i <= next; ++i) {
        const Bucket& bucket = level.closed[i];
        const auto found =
            std::find_if(bucket.begin(), bucket.end(), [&](const Point& p) { return p.at > time; });
        if (found != bucket.end() && (oldest == nullptr || found->at < oldest->at)) oldest = &*found;
      }
    }
    return oldest;
  }
  // Bytes used by the records.
  [[nodiscard]] std::size_t memory() const {
    std::size_t sum = points_.size() * sizeof(Point);
    for (const Level& level : levels_) sum += level.closed.size() * sizeof(Bucket);
    return sum;
  }

  // Fills `out` with points for display within [from, to] and one beyond each end: the points themselves if
  // they are still kept, otherwise those of the finest level that reaches back to `from`. At most some
  // 33 000, in the order of time.
  void read(double from, double to, std::vector<Point>& out) const {
    out.clear();
    if (count_ == 0) return;
    if (from >= whole_since()) {
      read_ring(points_, from, to, [&](const Point& p) { out.push_back(p); });
      return;
    }
    std::size_t level = 0;
    const auto reaches = [&](const Level& l) { return l.closed.size() > 0 && l.closed[0].time() <= from; };
    while (level + 1 < levels_.size() && !reaches(levels_[level])) ++level;
    const auto put = [&](const Bucket& bucket) { out.insert(out.end(), bucket.begin(), bucket.end()); };
    read_ring(levels_[level].closed, from, to, put);
    // Points not yet in a closed bucket of the level are in its open bucket and then in those of the finer
    // levels.
    for (std::size_t k = level + 1; k-- > 0;) {
      const Open& open = levels_[k].open;
      if (open.taken == 0) continue;
      const Bucket rest = open.close();
      if (out.empty() || out.back().at <= to) put(rest);
    }
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  // The points of a bucket in the order of time; some may occur twice.
  struct Bucket : std::array<Point, 2 + 2 * K> {
    [[nodiscard]] double time() const { return this->front().at; }
  };

  // A bucket that is being filled.
  struct Open {
    struct Kept {
      Point point;
      int order = 0;
    };
    int taken = 0;
    int order = 0;
    Kept first, last;
    std::array<Kept, K> least, largest;

    void add(const Point& point) {
      const Kept now{point, order++};
      if (now.order == 0) {
        first = now;
        least.fill(now);
        largest.fill(now);
      }
      last = now;
      for (int k = 0; k < K; ++k) {
        if (point.value[k] < least[k].point.value[k]) least[k] = now;
        if (point.value[k] > largest[k].point.value[k]) largest[k] = now;
      }
    }
    [[nodiscard]] Bucket close() const {
      std::array<Kept, 2 + 2 * K> kept;
      kept[0] = first;
      kept[1] = last;
      for (int k = 0; k < K; ++k) {
        kept[2 + 2 * k] = least[k];
        kept[3 + 2 * k] = largest[k];
      }
      std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return a.order < b.order; });
      Bucket bucket;
      for (std::size_t i = 0; i < kept.size(); ++i) bucket[i] = kept[i].point;
      return bucket;
    }
  };

  struct Level {
    Ring<Bucket> closed{kBuckets};
    Open open;
  };

  void take(std::size_t level, const Point& point) {
    levels_[level].open.add(point);
    close_if_full(level, kFirstFan);
  }

  void take(std::size_t level, const Bucket& bucket) {
    for (const Point& point : bucket) levels_[level].open.add(point);
    close_if_full(level, kFan);
  }

  void close_if_full(std::size_t level, int fan) {
    if (++levels_[level].open.taken < fan) return;
    const Bucket bucket = levels_[level].open.close();
    levels_[level].open = {};
    if (level + 1 == levels_.size() && levels_[level].closed.full()) {
      levels_.emplace_back();
      for (std::size_t i = 0; i < kBuckets; ++i) take(level + 1, levels_[level].closed[i]);
    }
    levels_[level].closed.push(bucket);
    if (level + 1 < levels_.size()) take(level + 1, bucket);
  }

  // The records within the range, and one beyond each of its ends.
  template <class Record, class Put>
  static void read_ring(const Ring<Record>& ring, double from, double to, const Put& put) {
    std::size_t i = ring.lower_bound(from);
    if (i > 0) --i;
    for (; i < ring.size(); ++i) {
      put(ring[i]);
      if (ring[i].time() > to) return;
    }
  }

  std::int64_t count_ = 0;
  Ring<Point> points_{kPoints};
  std::vector<Level> levels_;
};

}  // namespace carom
