#pragma once

#include <optional>
#include <span>
#include <vector>

#include "physics/scene/scene.h"

namespace carom {

// The bodies beside the edited ones, and the joints between any of them. Bodies that can't collide (of one
// group, both of infinite mass, pinned or welded to each other) may overlap.
struct Surroundings {
  std::vector<Body> bodies;
  std::vector<Joint> joints;
};

struct Overlap {
  Body body;
  Body other;
  double depth = 0.0;      // m, the shortest way out of it
  Vec2 at = Vec2::Zero();  // m, in the middle of it
};

// Of the bodies with their neighbours, and with each other if that is asked, the deepest first. Bodies that
// touch to rounding do not overlap.
[[nodiscard]] std::vector<Overlap> overlaps_of(std::span<const Body> bodies, const Surroundings& neighbours,
                                               bool with_each_other = false);

// Of the bodies with each other, deeper than written numbers are rounded.
[[nodiscard]] std::vector<Overlap> overlaps_among(std::span<const Body> bodies,
                                                  const std::vector<Joint>& joints);

// The bodies moved as one, the shortest way that leaves no overlap with a neighbour; nothing if there is no
// such place within a few times their size. Finds the shortest way among several obstacles from a number of
// first guesses, so in a crowd a shorter one may exist.
[[nodiscard]] std::optional<std::vector<Body>> moved_out(std::span<const Body> bodies,
                                                         const Surroundings& neighbours);

// Between `before` and `after`, the same bodies with other sizes: the last ones on the way that overlap nothing
// they were clear of before, each other included.
[[nodiscard]] std::vector<Body> grown_to_touch(std::span<const Body> before, std::span<const Body> after,
                                               const Surroundings& neighbours);

// The body moved along the line of centres, or that of a half-plane's normal, to where it touches the other.
[[nodiscard]] Body in_touch(const Body& body, const Body& other);

}  // namespace carom
