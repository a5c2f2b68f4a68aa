#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/math/bounds.h"
#include "physics/model/index.h"

namespace carom {

// A grid of square cells, each with the bodies whose bounds touch it. Finding the neighbours of one body
// costs a time that does not grow with their number. Cells wrap around (a hash of the coordinates that keeps
// neighbours apart), so the plane has no edge; bodies that wrap onto each other are told apart by their
// bounds. Bodies over more than kMostCells cells, or in full cells, are in one list that every query reads; so
// are all where there are few.
class CellGrid {
 public:
  struct FilledCell {
    std::size_t number;
    std::vector<BodyIndex> bodies;
  };
  // All that decides the order in which neighbours are visited.
  struct Order {
    double inverse_size = 1.0;   // 1/m
    std::vector<Bounds> bounds;  // by body
    std::vector<FilledCell> cells;
    std::vector<BodyIndex> large;
  };
  [[nodiscard]] Order order() const;
  // `order` is that of a grid with all bodies.
  void restore(const Order& order);

  // Empties the grid and sizes it for bodies 0 .. bodies - 1 and cells of `size` (m; 0: any).
  void reset(int bodies, double size) {
    const auto side = std::bit_ceil(static_cast<std::uint32_t>(std::sqrt(static_cast<double>(bodies)) + 1.0));
    if (static_cast<int>(bounds_.size()) != bodies || side != mask_ + 1) {
      mask_ = side - 1;
      cells_.assign(static_cast<std::size_t>(side) * side, {});
      bounds_.resize(bodies);
      range_.resize(bodies);
      seen_.assign(bodies, 0);
    } else {
      for (Cell& cell : cells_) cell.count = 0;
    }
    large_.clear();
    for (Range& range : range_) range.state = kOut;
    inverse_size_ = size > 0.0 ? 1.0 / size : 1.0;  // there may be nothing but points at rest
  }

  // Inserts a body, or moves it.
  void put(BodyIndex body, const Bounds& bounds) {
    bounds_[body] = bounds;
    Range range = range_of(bounds);
    Range& old = range_[body];
    if (old.state == range.state && old.low_x == range.low_x && old.low_y == range.low_y &&
        old.high_x == range.high_x && old.high_y == range.high_y) {
      return;
    }
    take_out(body);
    old = range;
    bool room = range.state == kIn;
    if (room) each_cell(range, [&](const Cell& cell) { room = room && cell.count < kMostInCell; });
    if (room) {
      each_cell(range, [&](Cell& cell) { cell.bodies[cell.count++] = body; });
    } else {
      old.state = kLarge;
      large_.push_back(body);
    }
  }

  // Calls visit(other) once for each other body whose bounds overlap those of `body`.
  template <class Visit>
  void each_near(BodyIndex body, const Visit& visit) {
    const Bounds& mine = bounds_[body];
    const Range range = range_[body];
    if (range.state == kLarge) {
      for (BodyIndex other{0}; other < static_cast<int>(bounds_.size()); ++other) {
        if (other != body && range_[other].state != kOut && mine.overlaps(bounds_[other])) visit(other);
      }
      return;
    }
    if (++query_ == 0) {
      std::fill(seen_.begin(), seen_.end(), 0);
      query_ = 1;
    }
    seen_[body] = query_;
    // Found before any is visited, without branches, because it is unpredictable which ones are.
    std::size_t found = 0;
    each_cell(range, [&](const Cell& cell) {
      for (int i = 0; i < cell.count; ++i) {
        const BodyIndex other = cell.bodies[i];
        const unsigned counts = unsigned(seen_[other] != query_) & unsigned(mine.overlaps(bounds_[other]));
        seen_[other] += counts * (query_ - seen_[other]);
        found_[found] = other;
        found += counts;
      }
    });
    for (std::size_t i = 0; i < found; ++i) visit(found_[i]);
    for (const BodyIndex other : large_) {
      if (mine.overlaps(bounds_[other])) visit(other);
    }
  }

 private:
  // To compare so few bounds costs less than to keep cells.
  static constexpr int kFew = 24;
  static constexpr std::int64_t kMostCells = 32;
  static constexpr int kMostInCell = 15;
  struct alignas(64) Cell {
    int count = 0;
    std::array<BodyIndex, kMostInCell> bodies;
  };
  enum State : std::uint8_t { kOut, kIn, kLarge };
  struct Range {
    std::int64_t low_x = 0, low_y = 0, high_x = 0, high_y = 0;
    State state = kOut;
  };

  [[nodiscard]] Range range_of(const Bounds& b) const {
    if (static_cast<int>(bounds_.size()) <= kFew) return {0, 0, 0, 0, kLarge};
    // Clamped far beyond any scene's coordinates: the integers must not overflow.
    const Eigen::Array2d low = (b.low * inverse_size_).floor().max(-1e15).min(1e15);
    const Eigen::Array2d high = (b.high * inverse_size_).floor().max(-1e15).min(1e15);
    Range r{static_cast<std::int64_t>(low.x()), static_cast<std::int64_t>(low.y()),
            static_cast<std::int64_t>(high.x()), static_cast<std::int64_t>(high.y()), kIn};
    const std::int64_t wide = r.high_x - r.low_x + 1;
    const std::int64_t tall = r.high_y - r.low_y + 1;
    const std::int64_t side = static_cast<std::int64_t>(mask_) + 1;
    if (wide > kMostCells || tall > kMostCells || wide * tall > kMostCells || wide > side || tall > side)
      return {0, 0, 0, 0, kLarge};
    return r;
  }
  template <class Do>
  void each_cell(const Range& r, const Do& action) {
    for (std::int64_t y = r.low_y; y <= r.high_y; ++y) {
      const std::size_t row = static_cast<std::size_t>(static_cast<std::uint64_t>(y) & mask_) * (mask_ + 1U);
      for (std::int64_t x = r.low_x; x <= r.high_x; ++x)
        action(cells_[row + (static_cast<std::uint64_t>(x) & mask_)]);
    }
  }
  void take_out(BodyIndex body) {
    const Range range = range_[body];
    if (range.state == kLarge) {
      *std::find(large_.begin(), large_.end(), body) = large_.back();
      large_.pop_back();
    } else if (range.state == kIn) {
      each_cell(range, [body](Cell& cell) {
        *std::find(cell.bodies.begin(), cell.bodies.begin() + cell.count, body) = cell.bodies[cell.count - 1];
        --cell.count;
      });
    }
  }

  std::uint32_t mask_ = 0;
  double inverse_size_ = 1.0;
  std::vector<Cell> cells_;
  std::vector<Bounds> bounds_;
  std::vector<Range> range_;
  std::vector<BodyIndex> large_;
  std::vector<std::uint32_t> seen_;
  std::array<BodyIndex, kMostCells * kMostInCell + 1> found_;  // scratch
  std::uint32_t query_ = 0;
};

}  // namespace carom
