#pragma once

#include <Eigen/Core>
#include <vector>

#include "physics/model/index.h"
#include "physics/scene/scene.h"

namespace carom {

// Where the bodies are at the start of a run and how they move there; a column a body.
struct BodyStarts {
  Eigen::Matrix3Xd q;  // m, m, rad
  Eigen::Matrix3Xd v;  // m/s, m/s, rad/s
};

// Kinematic bodies have the position and velocity of their drive at `time` (s).
[[nodiscard]] BodyStarts body_starts(const std::vector<Body>& bodies, double time);

// A kinematic body: its motion, and the place (m) that the motion is about.
struct DriveTerm {
  Drive law;
  Vec2 home;
};

// The kinematic bodies of a scene.
struct DriveTerms {
  std::vector<DriveTerm> all;
  std::vector<int> of;  // by body, or -1; empty without kinematic bodies

  [[nodiscard]] bool drives(BodyIndex body) const { return !of.empty() && of[body] >= 0; }
  [[nodiscard]] const DriveTerm& at(BodyIndex body) const { return all[static_cast<std::size_t>(of[body])]; }
};

[[nodiscard]] DriveTerms drive_terms(const std::vector<Body>& bodies);

}  // namespace carom
