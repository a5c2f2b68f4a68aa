#include "physics/collision/cell_grid.h"

#include <cstddef>

namespace carom {

CellGrid::Order CellGrid::order() const {
  // Names all members, so that a new one does not compile until it is handled here.
  const auto& [mask, inverse_size, cells, bounds, ranges, large, seen, found, query] = *this;
  Order order{inverse_size, bounds, {}, large};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (cells[k].count == 0) continue;
    const auto& bodies = cells[k].bodies;
    order.cells.push_back({k, {bodies.begin(), bodies.begin() + cells[k].count}});
  }
  return order;
}

void CellGrid::restore(const Order& order) {
  const auto bodies = static_cast<int>(order.bounds.size());
  reset(bodies, 1.0);
  inverse_size_ = order.inverse_size;
  bounds_ = order.bounds;
  for (BodyIndex i{0}; i < bodies; ++i) range_[i] = range_of(bounds_[i]);
  large_ = order.large;
  for (const BodyIndex i : large_) range_[i].state = kLarge;
  for (const auto& [number, from] : order.cells) {
    Cell& cell = cells_[number];
    for (const BodyIndex body : from) cell.bodies[cell.count++] = body;
  }
}

}  // namespace carom
