#pragma once

#include <array>
#include <string_view>

#include "physics/dynamics/integrators/dormand_prince.h"
#include "physics/dynamics/integrators/exact_flight.h"
#include "physics/dynamics/integrators/explicit_euler.h"
#include "physics/dynamics/integrators/rk4.h"
#include "physics/dynamics/integrators/semi_implicit_euler.h"
#include "physics/dynamics/integrators/velocity_verlet.h"
#include "physics/scene/method.h"

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
  int order;                 // of the error of a smooth motion at a fixed time; 0: no error but rounding
  int evaluations;           // of the right-hand side, per step and body
  bool exact_under_gravity;  // a constant acceleration gives the parabola at any step
  bool adaptive;             // a tolerance takes the step's place
};

// The table that window, command line and tests iterate. Each method has a file beside this one.
inline constexpr std::array<IntegratorChoice, 7> kIntegrators = {{
    {{IntegratorId::kExplicitEuler, "explicit-euler", "Explicit Euler",
      "order 1; gains energy in oscillations"},
     1,
     1,
     false,
     false},
    {{IntegratorId::kSemiImplicitEuler, "semi-implicit-euler", "Semi-implicit Euler",
      "order 1, symplectic; the Euler of the founding report"},
     1,
     1,
     false,
     false},
    {{IntegratorId::kVelocityVerlet, "velocity-verlet", "Velocity Verlet",
      "order 2; symplectic where forces don't depend on the velocity"},
     2,
     2,
     true,
     false},
    {{IntegratorId::kRk4, "rk4", "RK4", "order 4, the classical Runge-Kutta method"}, 4, 4, true, false},
    {{IntegratorId::kDormandPrince, "dormand-prince", "Dormand-Prince 5",
      "order 5 at a fixed step, the fifth-order method of the 5(4) pair"},
     5,
     6,
     true,
     false},
    {{IntegratorId::kAdaptiveDormandPrince, "dormand-prince-adaptive", "Dormand-Prince 5(4), adaptive",
      "the step follows an error estimate; a tolerance takes the step's place"},
     5,
     7,
     true,
     true},
    {{IntegratorId::kExactFlight, "exact-flight", "Exact flight",
      "the parabola in closed form, where only uniform gravity and constant forces act"},
     0,
     0,
     true,
     false},
}};

inline constexpr std::array<Choice<ImpactsId>, 2> kImpacts = {{
    {ImpactsId::kStepEnd, "step-end", "impacts at the step's end",
     "overlaps are found after each step: the founding report's way, order 1 at best"},
    {ImpactsId::kLocated, "located", "impacts at their own time",
     "each impact is located in time, so that the integrator keeps its order"},
}};

inline constexpr std::array<Choice<ContactsId>, 2> kContacts = {{
    {ContactsId::kImpulse, "impulse", "impulses only",
     "every contact is an impact; nothing holds a body at rest"},
    {ContactsId::kLasting, "lasting", "contacts that last",
     "forces hold what touches: static and kinetic friction, stacks that stand; order 4 at most while they "
     "act"},
}};

// The entry of a table with this id; the tables contain every id.
template <class Table, class Id>
[[nodiscard]] constexpr const auto& choice_of(const Table& table, Id id) {
  for (const auto& choice : table) {
    if (choice.id == id) return choice;
  }
  return table.front();
}

// One step of length h >= 0 from time t and `y` into `out`: the only dispatch on the integrator. The adaptive
// one takes a step of exactly this length too; its error control is in trajectories.cpp.
template <class System, class Y>
void integrator_step(IntegratorId id, const System& f, double t, const Y& y, double h, Stages<Y>& s, Y& out) {
  switch (id) {
    case IntegratorId::kExplicitEuler:
      return explicit_euler_step(f, t, y, h, s, out);
    case IntegratorId::kSemiImplicitEuler:
      return semi_implicit_euler_step(f, t, y, h, s, out);
    case IntegratorId::kVelocityVerlet:
      return velocity_verlet_step(f, t, y, h, s, out);
    case IntegratorId::kRk4:
      return rk4_step(f, t, y, h, s, out);
    case IntegratorId::kDormandPrince:
    case IntegratorId::kAdaptiveDormandPrince:
      return dormand_prince_step(f, t, y, h, s, out);
    case IntegratorId::kExactFlight:
      return exact_flight_step(f, t, y, h, s, out);
  }
}

}  // namespace carom
