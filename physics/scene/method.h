#pragma once

namespace carom {

enum class IntegratorId {
  kExplicitEuler,
  kSemiImplicitEuler,
  kVelocityVerlet,
  kRk4,
  kDormandPrince,
  kAdaptiveDormandPrince,
  kExactFlight
};
enum class ImpactsId { kStepEnd, kLocated };
enum class ContactsId { kImpulse, kLasting };

// How a run is computed: three named choices and the step. See physics/dynamics/integrators/integrators.h and
// physics/step/.
struct Method {
  IntegratorId integrator = IntegratorId::kRk4;
  ImpactsId impacts = ImpactsId::kLocated;
  ContactsId contacts = ContactsId::kImpulse;
  // s, > 0. For integrators without a fixed step (adaptive, exact flight): the interval of the results.
  double step = 0.005;
  double tolerance = 1e-9;  // m and m/s per step, > 0; adaptive integrator only

  bool operator==(const Method&) const = default;
};

}  // namespace carom
