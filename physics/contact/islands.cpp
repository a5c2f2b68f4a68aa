#include "physics/contact/islands.h"

#include <cstddef>

namespace carom {

namespace {

int root(std::vector<int>& parent, int i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

}  // namespace

void find_islands(const std::vector<BodyIndex>& a, const std::vector<BodyIndex>& b,
                  const Eigen::VectorXd& inverse_mass, const Eigen::VectorXd& inverse_inertia,
                  Islands& islands) {
  const auto movable = [&](BodyIndex i) { return inverse_mass[i] > 0.0 || inverse_inertia[i] > 0.0; };
  const int bodies = static_cast<int>(inverse_mass.size());
  const int contacts = static_cast<int>(a.size());
  std::vector<int>& parent = islands.parent;
  // The second half has the island of each root.
  parent.assign(2 * static_cast<std::size_t>(bodies), -1);
  for (BodyIndex i{0}; i < bodies; ++i) parent[i] = i;
  for (int c = 0; c < contacts; ++c) {
    if (movable(a[c]) && movable(b[c])) parent[root(parent, a[c])] = root(parent, b[c]);
  }

  // A counting sort by island keeps the given order.
  const auto island_of = [&](int c) -> int* {
    if (movable(a[c])) return &parent[bodies + root(parent, a[c])];
    return movable(b[c]) ? &parent[bodies + root(parent, b[c])] : nullptr;
  };
  std::vector<int>& first = islands.first;
  first.assign(1, 0);
  for (int c = 0; c < contacts; ++c) {
    int* const island = island_of(c);
    if (island == nullptr) continue;
    if (*island < 0) {
      *island = static_cast<int>(first.size()) - 1;
      first.push_back(0);
    }
    ++first[*island + 1];
  }
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  islands.contacts.resize(first.back());
  for (int c = contacts - 1; c >= 0; --c) {
    const int* const island = island_of(c);
    if (island != nullptr) islands.contacts[--first[*island + 1]] = c;
  }
  // The backward pass left in first[i + 1] where island i starts.
  for (std::size_t i = 1; i + 1 < first.size(); ++i) first[i] = first[i + 1];
  if (first.size() > 1) first.back() = static_cast<int>(islands.contacts.size());
}

}  // namespace carom
