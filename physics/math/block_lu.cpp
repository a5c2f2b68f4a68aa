#include "physics/math/block_lu.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace carom {

void BlockLu::analyse(int n, std::span<const std::pair<int, int>> edges) {
  if (static_cast<int>(neighbours_.size()) < n) neighbours_.resize(n);
  for (int i = 0; i < n; ++i) neighbours_[i].clear();
  for (const auto& [i, j] : edges) {
    neighbours_[i].push_back(j);
    neighbours_[j].push_back(i);
  }
  for (int i = 0; i < n; ++i) {
    std::vector<int>& near = neighbours_[i];
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  }

  // Eliminating a block makes its neighbours adjacent to one another. The next block comes from a heap of
  // (degree, block); entries with an outdated degree are skipped.
  const auto degree = [&](int i) { return static_cast<int>(neighbours_[i].size()); };
  queue_.clear();
  for (int i = 0; i < n; ++i) queue_.emplace_back(degree(i), i);
  std::make_heap(queue_.begin(), queue_.end(), std::greater<>{});
  place_.assign(n, -1);
  order_.clear();
  while (static_cast<int>(order_.size()) < n) {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>{});
    const auto [least, k] = queue_.back();
    queue_.pop_back();
    if (place_[k] >= 0 || least != degree(k)) continue;
    place_[k] = static_cast<int>(order_.size());
    order_.push_back(k);
    for (const int i : neighbours_[k]) {
      merged_.clear();
      std::set_union(neighbours_[i].begin(), neighbours_[i].end(), neighbours_[k].begin(), neighbours_[k].end(),
                     std::back_inserter(merged_));
      neighbours_[i].clear();
      for (const int j : merged_) {
        if (j != i && j != k) neighbours_[i].push_back(j);
      }
      queue_.emplace_back(degree(i), i);
      std::push_heap(queue_.begin(), queue_.end(), std::greater<>{});
    }
  }

  first_.assign(1, 0);
  index_.clear();
  for (const int k : order_) {
    for (const int j : neighbours_[k]) index_.push_back(place_[j]);
    std::sort(index_.begin() + first_.back(), index_.end());
    first_.push_back(static_cast<int>(index_.size()));
  }
  diagonal_.resize(n);
  upper_.resize(index_.size());
  lower_.resize(index_.size());
  permuted_.resize(3 * n);
}

void BlockLu::clear() {
  for (std::vector<Block>* blocks : {&diagonal_, &upper_, &lower_})
    std::fill(blocks->begin(), blocks->end(), Block::Zero());
}

BlockLu::Slot BlockLu::slot(int i, int j) const {
  const int low = std::min(place_[i], place_[j]);
  const int high = std::max(place_[i], place_[j]);
  const auto found = std::lower_bound(index_.begin() + first_[low], index_.begin() + first_[low + 1], high);
  return {static_cast<int>(found - index_.begin()), place_[i] == low};
}

bool BlockLu::factorise() {
  const int n = static_cast<int>(diagonal_.size());
  for (int k = 0; k < n; ++k) {
    const Block inverse = diagonal_[k].partialPivLu().inverse();
    if (!inverse.allFinite()) return false;
    diagonal_[k] = inverse;
    const int begin = first_[k];
    const int end = first_[k + 1];
    for (int s = begin; s < end; ++s) {
      const Block scaled = lower_[s].lazyProduct(inverse);
      lower_[s] = scaled;
    }
    // A(i, j) -= L(i, k) U(k, j) for all i and j in the pattern of row k. The row of the smaller index stores
    // both blocks, in the same order.
    for (int s = begin; s < end; ++s) {
      const int i = index_[s];
      diagonal_[i] -= lower_[s].lazyProduct(upper_[s]);
      int slot = first_[i];
      for (int other = s + 1; other < end; ++other) {
        while (index_[slot] != index_[other]) ++slot;
        upper_[slot] -= lower_[s].lazyProduct(upper_[other]);
        lower_[slot] -= lower_[other].lazyProduct(upper_[s]);
      }
    }
  }
  return true;
}

void BlockLu::solve(Eigen::Ref<Eigen::VectorXd> x) {
  const int n = static_cast<int>(diagonal_.size());
  for (int k = 0; k < n; ++k) permuted_.segment<3>(3 * k) = x.segment<3>(3 * order_[k]);
  for (int k = 0; k < n; ++k) {
    const Eigen::Vector3d xk = permuted_.segment<3>(3 * k);
    for (int s = first_[k]; s < first_[k + 1]; ++s)
      permuted_.segment<3>(3 * index_[s]) -= lower_[s].lazyProduct(xk);
  }
  for (int k = n - 1; k >= 0; --k) {
    Eigen::Vector3d xk = permuted_.segment<3>(3 * k);
    for (int s = first_[k]; s < first_[k + 1]; ++s)
      xk -= upper_[s].lazyProduct(permuted_.segment<3>(3 * index_[s]));
    permuted_.segment<3>(3 * k) = diagonal_[k].lazyProduct(xk);
  }
  for (int k = 0; k < n; ++k) x.segment<3>(3 * order_[k]) = permuted_.segment<3>(3 * k);
}

}  // namespace carom
