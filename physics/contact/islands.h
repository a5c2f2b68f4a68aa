#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "physics/model/index.h"

namespace carom {

// Contacts that can affect one another: connected components of the graph of contacts over movable bodies.
// Bodies of infinite mass connect nothing.
struct Islands {
  std::vector<int> contacts;  // contact indices, island by island, in the given order within each
  std::vector<int> first;     // island i is contacts[first[i]] .. contacts[first[i + 1] - 1]
  std::vector<int> parent;    // scratch, by body

  [[nodiscard]] int size() const { return static_cast<int>(first.size()) - 1; }
  [[nodiscard]] std::span<const int> of(int i) const {
    return {contacts.data() + first[i], static_cast<std::size_t>(first[i + 1] - first[i])};
  }
};

// Islands of the contacts between bodies a[c] and b[c], ordered by their first contact; a body is movable if
// its inverse mass or inertia is above 0. Contacts without a movable body are in none. Allocates nothing once
// `islands` has held as many.
void find_islands(const std::vector<BodyIndex>& a, const std::vector<BodyIndex>& b,
                  const Eigen::VectorXd& inverse_mass, const Eigen::VectorXd& inverse_inertia,
                  Islands& islands);

}  // namespace carom
