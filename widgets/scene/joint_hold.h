#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "widgets/scene/overlap.h"

namespace carom {

// A joint's own name, or "Rod 1".
[[nodiscard]] std::string name_for_people(const Joint& joint, std::span<const Joint> joints);

// The neighbours that come along with the bodies: all that are welded to them, and moving ones that are pinned.
[[nodiscard]] std::vector<Body> followers_of(std::span<const Body> bodies, const Surroundings& neighbours);

// Moves them as a rigid body, of which `before` and `after` are the same part.
void move_along(std::vector<Body>& followers, const Body& before, const Body& after);

// A joint of the edited bodies to something else, with its ends in the world.
struct Hold {
  Joint joint;
  std::size_t body;                // that it holds, of the edited ones
  std::vector<std::size_t> moves;  // that one and those that joints among the edited ones couple to it
  bool at_body;                    // that one is its `body`, else its `to`
  Vec2 point;                      // m, its end on that body, along the body's own axes
  Vec2 anchor;                     // m, its other end
  double length;                   // m
  double turned = 0.0;             // rad, the other body's angle
  double angle = 0.0;              // rad, weld only: between the held body and that one
  Vec2 velocity;                   // m/s, of the other end
  std::string name;                // for people: its own, or "Rod 1"
};
// Springs hold nothing. Lengths that a joint does not state are those between the bodies as they are.
[[nodiscard]] std::vector<Hold> holds_of(std::span<const Body> bodies, const Surroundings& neighbours);

// m, from its body's end to the other one.
[[nodiscard]] double length_of(const Hold& hold, std::span<const Body> bodies);
[[nodiscard]] bool keeps(const Hold& hold, std::span<const Body> bodies);

// The places next to the wanted ones that all holds allow; nothing if there are none. Coupled bodies are moved
// as one, those that nothing holds go where they are wanted. A pinned body that is moved turns about its pin,
// with the point that was at `grip` (m) towards where it is wanted. Velocities change as little as keeps rods
// and pins at their lengths.
[[nodiscard]] std::optional<std::vector<Body>> held(std::span<const Body> from, std::span<const Body> wanted,
                                                    std::span<const Hold> holds, const Vec2& grip);

// Takes out what the holds don't allow of the bodies' velocities; false if all was allowed.
bool hold_velocities(std::vector<Body>& bodies, std::span<const Hold> holds);

// The joint with the length, or the place of its other end, that the bodies need.
[[nodiscard]] Joint refitted(const Hold& hold, std::span<const Body> bodies);

}  // namespace carom
