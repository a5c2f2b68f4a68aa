#pragma once

#include "physics/dynamics/integrators/integrators.h"
#include "physics/scene/fields.h"
#include "physics/scene/method.h"

namespace carom {

// What a file or a new scene does not say of its method: contacts last, and are modelled where the scene needs
// them.
[[nodiscard]] inline Method unstated_method() {
  Method method;
  method.contacts = ContactsId::kLasting;
  return method;
}

// The fields of a method: see physics/scene/fields.h.
template <class V>
void fields(V& v, Is<Method> auto& m) {
  v.choice({"integrator", "how free motion is advanced"}, kIntegrators, m.integrator);
  v.choice({"impacts", "when impacts are resolved"}, kImpacts, m.impacts);
  v.choice({"contacts", "how lasting contacts are treated"}, kContacts, m.contacts);
  v.field({"step", "length of a step, or interval of the results"}, m.step, kStepRange);
  v.field({"tolerance", "of the adaptive integrator, a step"}, m.tolerance, kToleranceRange);
  v.keep({"integrator", "impacts", "contacts", "step"});
  if (choice_of(kIntegrators, m.integrator).adaptive) v.keep({"tolerance"});
}

}  // namespace carom
