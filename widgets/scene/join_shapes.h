#pragma once

#include <QString>
#include <span>
#include <string>
#include <vector>

#include "physics/scene/edit.h"
#include "physics/scene/scene.h"

// Several bodies made one rigid body, and one of several shapes taken apart.
namespace carom {

// The bodies as one, called as the first, with all shapes where they are: at the common centre of mass, with
// the sum of the masses, and with the velocity and spin of a perfectly inelastic joining, v = Σ m_i v_i / M and
// ω = Σ (I_i ω_i + m_i d_i × v_i) / I. Its inertia I = Σ (I_i + m_i d_i²) is stated where it is not that of a
// homogeneous body. All must be of one kind: fixed, of the same drive, or moving.
[[nodiscard]] Body joined(std::span<const Body> bodies);

// One body for each shape of a compound, where and how it moves, homogeneous, with its share of the mass. They
// have no name.
[[nodiscard]] std::vector<Body> taken_apart(const Body& body);

struct Regrouping {
  SceneEdits edits;
  QString name;                     // "Join A and B into one body"
  std::vector<std::string> bodies;  // that are there afterwards
  QString refusal;                  // why it can't be, in one sentence; nothing is edited then
};

// Joints and springs between the bodies go; others, and forces, hold the joined body at the same place, and
// joints take out what they forbid of the velocities.
[[nodiscard]] Regrouping joining(const Scene& scene, std::span<const std::string> names);

// Those of these bodies that have several shapes. All that holds or pushes them goes.
[[nodiscard]] Regrouping taking_apart(const Scene& scene, std::span<const std::string> names);

}  // namespace carom
