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

void CellGrid::restore(const Order& order) {
  const auto bodies = static_cast<int>(order.bounds.size());
  reset(bodies, 1.0);
  inverse_size_ = order.inverse_size;
  bounds_ = order.bounds;
  for (int i = 0; i < bodies; ++i) range_[i] = range_of(bounds_[i]);
  large_ = order.large;
  for (const int i : large_) range_[i].state = kLarge;
  for (const std::vector<int>& from : order.cells) {
    Cell& cell = cells_[static_cast<std::size_t>(from[0])];
    for (std::size_t k = 1; k < from.size(); ++k) cell.bodies[cell.count++] = from[k];
  }
}

}  // namespace carom
