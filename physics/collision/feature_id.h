#pragma once

#include <cstdint>

#include "physics/scene/shape.h"

namespace carom {

// Which features of two shapes touch at a point of a manifold (pair_contact.h): an edge of each, with the end
// of the stretch that they share, or a vertex of each. Of a half-plane and a body, the half-plane is the first.
enum class Ends : std::uint32_t { kOne, kLow, kHigh, kVertices };

struct Features {
  Ends ends = Ends::kOne;
  int of_a = 0, of_b = 0;  // edges, or vertices
};

// Two bits for the kind, then four for each body's edge or vertex.
static_assert(kMostVertices <= 16);
[[nodiscard]] constexpr std::uint32_t feature_id(Ends ends, int of_a, int of_b) {
  return static_cast<std::uint32_t>(ends) | static_cast<std::uint32_t>(of_a) << 2U |
         static_cast<std::uint32_t>(of_b) << 6U;
}
[[nodiscard]] constexpr Features features_of(std::uint32_t id) {
  return {static_cast<Ends>(id & 3U), static_cast<int>(id >> 2U & 15U), static_cast<int>(id >> 6U & 15U)};
}

}  // namespace carom
