#include <cmath>
#include <utility>

#include "physics/step/gauss_island.h"
#include "physics/step/pair_motion.h"

// Faces of contacts: where forces of several contacts are determined only as a sum.
namespace carom {
namespace {

// Of the size, and in rad: contacts on one line.
constexpr double kSameLine = 1e-9;

// The first of these contacts between the same bodies as contact i, or such that move as one with them, whose
// normal is the same and of which `fits` is true of the way from it to contact i, in m. Null if there is none.
template <class Closed, class Fits>
auto earlier_contact(Closed& closed, const GaussStep& step, int i, const Fits& fits)
    -> decltype(closed.data()) {
  const Contacts& found = step.found.contacts;
  const auto point = [&](int k) { return step.found.point[static_cast<std::size_t>(k)]; };
  for (auto& other : closed) {
    const int k = other.contact;
    const double sign = step.world.same_sides(other.a, other.b, found.a[i], found.b[i]);
    if (sign != 0.0 && (sign * found.normal[k] - found.normal[i]).norm() <= kSameLine &&
        fits(other, point(i) - point(k)))
      return &other;
  }
  return nullptr;
}

}  // namespace

// One that presses at the same point with the same law, as where two fixed bodies have a corner in common: only
// the sum of their forces is determined.
GaussContact* GaussIsland::same_contact(const GaussStep& step, int i) {
  const Contacts& found = step.found.contacts;
  const double near = kSameLine * smaller_size(step.world, found.a[i], found.b[i]);
  return earlier_contact(closed_, step, i, [&](const GaussContact& other, const Vec2& way) {
    return other.presses && way.norm() <= near &&
           found.kinetic_friction[other.contact] == found.kinetic_friction[i] &&
           found.static_friction[other.contact] == found.static_friction[i];
  });
}

// That of an earlier contact with the same line of tangential force, or a new one: between two flat faces only
// the sum of the tangential forces is determined.
int GaussIsland::face_of(const GaussStep& step, int i) const {
  const Contacts& found = step.found.contacts;
  const double near = kSameLine * smaller_size(step.world, found.a[i], found.b[i]);
  const GaussContact* same = earlier_contact(closed_, step, i, [&](const GaussContact&, const Vec2& way) {
    return std::abs(found.normal[i].dot(way)) <= near;
  });
  return same == nullptr ? static_cast<int>(held_.size()) : same->face;
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
