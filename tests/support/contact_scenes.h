#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "physics/contact/contact_solver.h"
#include "physics/model/mass.h"

// Bodies and contacts for the contact solver, without a scene or a time step.
namespace carom::test {

class ContactScene {
 public:
  MassProperties mass;
  Eigen::Matrix3Xd v;
  Contacts contacts;
  std::vector<Vec2> position;

  // A mass of 0 means static.
  int body(const Vec2& at, double m, double inertia, const Eigen::Vector3d& velocity = {0.0, 0.0, 0.0}) {
    const int i = static_cast<int>(position.size());
    position.push_back(at);
    v.conservativeResize(3, i + 1);
    v.col(i) = velocity;
    mass.inverse_mass.conservativeResize(i + 1);
    mass.inverse_inertia.conservativeResize(i + 1);
    mass.inverse_mass[i] = m > 0.0 ? 1.0 / m : 0.0;
    mass.inverse_inertia[i] = inertia > 0.0 ? 1.0 / inertia : 0.0;
    return i;
  }
  int fixed(const Vec2& at = {0.0, 0.0}) { return body(at, 0.0, 0.0); }
  int box(const Vec2& at, double width, double height, double m) {
    return body(at, m, m * (width * width + height * height) / 12.0);
  }
  int disc(const Vec2& at, double radius, double m) { return body(at, m, 0.5 * m * radius * radius); }

  // A contact at `point` with its normal from a to b, one friction coefficient, sticking at first.
  int contact(int a, int b, const Vec2& point, const Vec2& normal, double friction) {
    const int c = contacts.size();
    contacts.resize(c + 1);
    contacts.a[c] = BodyIndex{a};
    contacts.b[c] = BodyIndex{b};
    contacts.normal[c] = normal;
    contacts.arm_a[c] = point - position[a];
    contacts.arm_b[c] = point - position[b];
    contacts.static_friction[c] = contacts.kinetic_friction[c] = friction;
    contacts.sticks[c] = 1;
    return c;
  }
  // Both corners of a box's lower edge on the body below.
  void corners(int below, int above, double width, double height, double friction) {
    for (const double side : {-0.5, 0.5})
      contact(below, above, position[above] + Vec2(side * width, -0.5 * height), {0.0, 1.0}, friction);
  }
  // The velocity that an acceleration gives to every movable body in h.
  void accelerate(const Vec2& acceleration, double h) {
    for (Eigen::Index i = 0; i < v.cols(); ++i) {
      if (mass.inverse_mass[i] > 0.0) v.col(i).head<2>() += h * acceleration;
    }
  }
  [[nodiscard]] double kinetic_energy() const {
    double k = 0.0;
    for (Eigen::Index i = 0; i < v.cols(); ++i) {
      if (mass.inverse_mass[i] > 0.0) k += 0.5 * v.col(i).head<2>().squaredNorm() / mass.inverse_mass[i];
      if (mass.inverse_inertia[i] > 0.0) k += 0.5 * v(2, i) * v(2, i) / mass.inverse_inertia[i];
    }
    return k;
  }
  ContactSolverReport solve(const ContactSolverOptions& options = {}) {
    ContactWorkspace workspace;
    return solve_contacts(mass, contacts, v, options, workspace);
  }
};

// A stack of boxes of side 1 m on a floor, masses from the bottom up; each rests on two corners.
inline ContactScene stack_of(const std::vector<double>& masses, double friction) {
  ContactScene s;
  int below = s.fixed();
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const int above = s.box({0.0, 0.5 + static_cast<double>(i)}, 1.0, 1.0, masses[i]);
    s.corners(below, above, 1.0, 1.0, friction);
    below = above;
  }
  return s;
}

// Rows of boxes 1 m wide and 0.1 m apart, each on the two below it, four contacts a box.
inline ContactScene pyramid(int base, double friction) {
  ContactScene s;
  const int floor = s.fixed();
  std::vector<int> below;
  for (int row = 0; row < base; ++row) {
    std::vector<int> here;
    for (int i = 0; i < base - row; ++i) {
      const double x = 1.1 * (i + 0.5 * row);
      const int above = s.box({x, 0.5 + row}, 1.0, 1.0, 1.0);
      here.push_back(above);
      if (row == 0) {
        s.corners(floor, above, 1.0, 1.0, friction);
        continue;
      }
      for (const int side : {0, 1}) {
        const double outer = side == 0 ? -0.5 : 0.5;
        const double inner = side == 0 ? -0.05 : 0.05;
        for (const double dx : {outer, inner})
          s.contact(below[i + side], above, {x + dx, static_cast<double>(row)}, {0.0, 1.0}, friction);
      }
    }
    below = here;
  }
  return s;
}

class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

struct RandomIsland {
  int most_contacts = 40;
  double mass_spread = 1.0;  // masses are e^±this
  double most_friction = 0.8;
  bool kinematic = false;
};

// Bodies at random places and speeds, some of them static, with contacts between neighbours whose normals are
// only roughly along the line of centres; some frictionless, some with rolling resistance, some with a gap. The
// same with every compiler: no two draws are arguments of one call, which may be evaluated in any order.
inline ContactScene random_island(std::uint64_t seed, const RandomIsland& kind) {
  Uniform draw(seed);
  ContactScene s;
  const int bodies = 2 + static_cast<int>(draw(0.0, 0.5 * kind.most_contacts));
  const double room = std::sqrt(bodies);
  for (int i = 0; i < bodies; ++i) {
    const double y = draw(0.0, room);
    const Vec2 at(draw(0.0, room), y);
    const double m = std::exp(draw(-kind.mass_spread, kind.mass_spread));
    if (i == 0 || draw(0.0, 1.0) < 0.15) {
      const double speed = kind.kinematic ? 0.3 : 0.0;
      s.body(at, 0.0, 0.0, {draw(-speed, speed), draw(-speed, speed), 0.0});
    } else {
      const Eigen::Vector3d v{draw(-1.0, 1.0), draw(-1.0, 1.0), draw(-1.0, 1.0)};
      s.body(at, m, m * draw(0.02, 0.2), v);
    }
  }
  const int contacts = 1 + static_cast<int>(draw(0.0, kind.most_contacts));
  for (int c = 0; c < contacts; ++c) {
    const int a = static_cast<int>(draw(0.0, bodies));
    int b = -1;
    const int rank = static_cast<int>(draw(0.0, 4.0));
    double beyond = -1.0;
    for (int k = 0; k <= rank; ++k) {  // the rank-th nearest
      double nearest = 1e300;
      for (int j = 0; j < bodies; ++j) {
        const double d = (s.position[j] - s.position[a]).squaredNorm();
        if (j != a && d > beyond && d < nearest) {
          nearest = d;
          b = j;
        }
      }
      beyond = nearest < 1e300 ? nearest : beyond;
    }
    const Vec2 line = s.position[b] - s.position[a];
    const double angle = std::atan2(line.y(), line.x()) + draw(-0.7, 0.7);
    const double mu = draw(0.0, 1.0) < 0.2 ? 0.0 : draw(0.0, kind.most_friction);
    const double up = draw(-0.1, 0.1);
    const Vec2 beside(draw(-0.1, 0.1), up);
    const Vec2 point = s.position[a] + draw(0.3, 0.7) * line + beside;
    const int i = s.contact(a, b, point, {std::cos(angle), std::sin(angle)}, mu);
    if (draw(0.0, 1.0) < 0.3) s.contacts.rolling[i] = draw(0.0, 0.1);
    if (draw(0.0, 1.0) < 0.3) s.contacts.target[i] = draw(-0.5, 0.0);
  }
  return s;
}

}  // namespace carom::test
