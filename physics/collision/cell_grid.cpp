#include "physics/collision/cell_grid.h"

#include <cstddef>

namespace carom {

CellGrid::Order CellGrid::order() const {
  // Names all members, so that a new one does not compile until it is handled here.
  const auto& [mask, inverse_size, cells, bounds, ranges, large, seen, query] = *this;
  Order order{inverse_size, bounds, {}, large};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (cells[k].count == 0) continue;
    std::vector<int>& cell = order.cells.emplace_back(1, static_cast<int>(k));
    cell.insert(cell.end(), cells[k].bodies.begin(), cells[k].bodies.begin() + cells[k].count);
  }
  return order;
}

bool CellGrid::restore(int bodies, const Order& order) {
  if (!(order.inverse_size > 0.0) || order.bounds.size() != static_cast<std::size_t>(bodies)) return false;
  reset(bodies, 1.0);
  inverse_size_ = order.inverse_size;
  bounds_ = order.bounds;
  for (int i = 0; i < bodies; ++i) range_[i] = range_of(bounds_[i]);
  // The list has the bodies that are too large for cells and those whose cells were full.
  std::size_t large = 0;
  for (const Range& range : range_) large += range.state == kLarge ? 1 : 0;
  std::vector<std::uint8_t> listed(bounds_.size(), 0);
  for (const int i : order.large) {
    if (i < 0 || i >= bodies || listed[i] != 0) return false;
    listed[i] = 1;
    large -= range_[i].state == kLarge ? 1 : 0;
    range_[i].state = kLarge;
  }
  if (large != 0) return false;
  large_ = order.large;
  // Each body is once in each cell that its bounds touch.
  std::int64_t places = 0;
  for (const Range& r : range_) {
    if (r.state == kIn) places += (r.high_x - r.low_x + 1) * (r.high_y - r.low_y + 1);
  }
  const std::int64_t side = static_cast<std::int64_t>(mask_) + 1;
  const auto covers = [&](std::int64_t low, std::int64_t high, std::int64_t cell) {
    return ((cell - low) & static_cast<std::int64_t>(mask_)) <= high - low;
  };
  std::int64_t last = -1;
  for (const std::vector<int>& from : order.cells) {
    if (from.size() < 2 || from.size() > kMostInCell + 1 || from[0] <= last || from[0] >= side * side)
      return false;
    last = from[0];
    Cell& cell = cells_[static_cast<std::size_t>(from[0])];
    for (std::size_t k = 1; k < from.size(); ++k) {
      const int i = from[k];
      if (i < 0 || i >= bodies ||
          std::find(from.begin() + 1, from.begin() + static_cast<std::ptrdiff_t>(k), i) !=
              from.begin() + static_cast<std::ptrdiff_t>(k)) {
        return false;
      }
      const Range& r = range_[i];
      if (r.state != kIn || !covers(r.low_x, r.high_x, last % side) || !covers(r.low_y, r.high_y, last / side))
        return false;
      cell.bodies[cell.count++] = i;
    }
    places -= cell.count;
  }
  return places == 0;
}

}  // namespace carom
