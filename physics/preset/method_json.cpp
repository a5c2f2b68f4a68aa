#include "physics/preset/method_json.h"

#include "physics/dynamics/integrators/integrators.h"
#include "physics/scene/method.h"

namespace carom {

void read_method(FieldReader& r, Method& m) {
  r.read_choice({"integrator", "how free motion is advanced"}, kIntegrators, m.integrator);
  r.read_choice({"impacts", "when impacts are resolved"}, kImpacts, m.impacts);
  r.read_choice({"contacts", "how lasting contacts are treated"}, kContacts, m.contacts);
  r.read({"step", "length of a step, or interval of the results"}, m.step, kStepRange);
  r.read({"tolerance", "of the adaptive integrator, a step"}, m.tolerance, kToleranceRange);
}

Json method_json(const Method& m, bool all) {
  Json j = {{"integrator", choice_of(kIntegrators, m.integrator).name},
            {"impacts", choice_of(kImpacts, m.impacts).name},
            {"contacts", choice_of(kContacts, m.contacts).name},
            {"step", m.step}};
  if (all || choice_of(kIntegrators, m.integrator).adaptive || m.tolerance != Method{}.tolerance)
    j["tolerance"] = m.tolerance;
  return j;
}

}  // namespace carom
