#include <cmath>
#include <utility>

#include "physics/step/gauss_island.h"
#include "physics/step/pair_motion.h"

// Faces of contacts: where forces of several contacts are determined only as a sum.
namespace carom {
namespace {

// Of the size, and in rad: contacts on one line.
constexpr double kSameLine = 1e-9;

}  // namespace

// An earlier contact that presses the same body at the same point along the same normal, as where two fixed
// bodies with one law have a corner in common: only their sum is determined. Null if there is none.
GaussContact* GaussIsland::same_contact(const GaussStep& step, int i) {
  const World& world = step.world;
  const Contacts& found = step.found.contacts;
  if (world.infinite_mass(found.a[i]) == world.infinite_mass(found.b[i])) return nullptr;
  const auto mover = [&](int k) { return world.infinite_mass(found.a[k]) ? found.b[k] : found.a[k]; };
  const auto towards = [&](int k) {
    return Vec2(world.infinite_mass(found.a[k]) ? found.normal[k] : -found.normal[k]);
  };
  const double near = kSameLine * smaller_size(world, found.a[i], found.b[i]);
  for (GaussContact& other : closed_) {
    const int k = other.contact;
    if (found.kinetic_friction[k] != found.kinetic_friction[i] ||
        found.static_friction[k] != found.static_friction[i])
      continue;
    if (!other.presses || world.infinite_mass(found.a[k]) == world.infinite_mass(found.b[k])) continue;
    if (mover(k) == mover(i) && (towards(k) - towards(i)).norm() <= kSameLine &&
        (step.found.point[static_cast<std::size_t>(k)] - step.found.point[static_cast<std::size_t>(i)])
                .norm() <= near)
      return &other;
  }
  return nullptr;
}

// That of an earlier contact of the same bodies with the same line of tangential force, or a new one: between
// two flat faces only the sum of the tangential forces is determined. Those that nothing moves are one body,
// such as the tiles of a floor.
int GaussIsland::face_of(const GaussStep& step, const GaussContact& c) const {
  const World& world = step.world;
  const FoundContacts& found = step.found;
  const auto are_one = [&](BodyIndex i, BodyIndex j) {
    return i == j || (world.is_immovable(i) && world.is_immovable(j));
  };
  const Vec2& normal = found.contacts.normal[c.contact];
  const Vec2& point = found.point[static_cast<std::size_t>(c.contact)];
  const double near = kSameLine * smaller_size(world, c.a, c.b);
  for (const GaussContact& other : closed_) {
    const bool alike = are_one(other.a, c.a) && are_one(other.b, c.b);
    const bool swapped = are_one(other.a, c.b) && are_one(other.b, c.a);
    if (!alike && !swapped) continue;
    const Vec2& there = found.contacts.normal[other.contact];
    if (((alike ? 1.0 : -1.0) * there - normal).norm() <= kSameLine &&
        std::abs(normal.dot(found.point[static_cast<std::size_t>(other.contact)] - point)) <= near)
      return other.face;
  }
  return static_cast<int>(held_.size());
}

void GaussIsland::hold_face(GaussContact& holder) {
  for (GaussContact& other : closed_) {
    if (&other == &holder || other.face != holder.face || !other.sticks) continue;
    for (const std::size_t k : {0U, 1U})
      holder.at[k].tangential_force += std::exchange(other.at[k].tangential_force, 0.0);
  }
}

void GaussIsland::share_friction(const GaussStep& step) {
  const auto most = [&](const GaussContact& c, std::size_t k) {
    return step.found.contacts.static_friction[c.contact] * c.at[k].normal_force;
  };
  for (int face = 0; face < static_cast<int>(held_.size()); ++face) {
    for (const std::size_t k : {0U, 1U}) {
      double tangential = 0.0;
      double all = 0.0;
      for (const GaussContact& c : closed_) {
        if (c.face != face || !c.sticks) continue;
        tangential += c.at[k].tangential_force;
        all += most(c, k);
      }
      if (!(all > 0.0)) continue;
      for (GaussContact& c : closed_) {
        if (c.face == face && c.sticks) c.at[k].tangential_force = tangential * most(c, k) / all;
      }
    }
  }
}

}  // namespace carom
