#pragma once

#include <array>
#include <string_view>

#include "physics/motion/explicit_euler.h"
#include "physics/motion/force_field.h"
#include "physics/motion/rk4.h"
#include "physics/motion/semi_implicit_euler.h"
#include "physics/motion/velocity_verlet.h"
#include "physics/scene/scene.h"

namespace carom {

// A named choice of a method: `name` for files and the command line, `label` for people.
template <class Id>
struct Choice {
  Id id;
  std::string_view name;
  std::string_view label;
  std::string_view tip;
};

struct IntegratorChoice : Choice<IntegratorId> {
  int order;        // of the error of a smooth motion at a fixed time
  int evaluations;  // of the acceleration, a step
};

// The table that window, command line and tests iterate. One file a method beside this one.
inline constexpr std::array<IntegratorChoice, 4> kIntegrators = {{
    {{IntegratorId::kExplicitEuler, "explicit-euler", "Explicit Euler",
      "order 1; gains energy in oscillations"},
     1,
     1},
    {{IntegratorId::kSemiImplicitEuler, "semi-implicit-euler", "Semi-implicit Euler",
      "order 1, symplectic; the Euler of the founding report"},
     1,
     1},
    {{IntegratorId::kVelocityVerlet, "velocity-verlet", "Velocity Verlet",
      "order 2, symplectic where forces don't depend on the velocity"},
     2,
     2},
    {{IntegratorId::kRk4, "rk4", "RK4", "order 4, the classical Runge-Kutta method"}, 4, 4},
}};

inline constexpr std::array<Choice<ImpactsId>, 2> kImpacts = {{
    {ImpactsId::kStepEnd, "step-end", "impacts at the step's end",
     "overlaps are found after each step: the founding report's way, order 1 at best"},
    {ImpactsId::kLocated, "located", "impacts at their own time",
     "each impact is located in time, so that the integrator keeps its order"},
}};

inline constexpr std::array<Choice<ContactsId>, 1> kContacts = {{
    {ContactsId::kImpulse, "impulse", "impulses only",
     "every contact is an impact; nothing holds a body at rest"},
}};

// The entry of a table with this id; the tables hold every id.
template <class Table, class Id>
[[nodiscard]] constexpr const auto& choice_of(const Table& table, Id id) {
  for (const auto& choice : table) {
    if (choice.id == id) return choice;
  }
  return table.front();
}

// One step of length h >= 0 of body `body` from `y` under `field`: the one place that dispatches on the
// integrator.
[[nodiscard]] inline Motion integrator_step(IntegratorId id, const ForceField& field, int body, const Motion& y,
                                            double h) {
  const auto rate = [&field, body](const Motion& m) { return field.rate(body, m); };
  switch (id) {
    case IntegratorId::kExplicitEuler:
      return explicit_euler_step(rate, y, h);
    case IntegratorId::kSemiImplicitEuler:
      return semi_implicit_euler_step(rate, y, h);
    case IntegratorId::kVelocityVerlet:
      return velocity_verlet_step(rate, y, h);
    case IntegratorId::kRk4:
      return rk4_step(rate, y, h);
    default:
      return y;
  }
}

}  // namespace carom
