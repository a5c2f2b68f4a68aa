#include "physics/preset/method_json.h"

#include "physics/motion/integrators.h"
#include "physics/preset/object_reader.h"

namespace carom {

Method read_method(const Json& json, const std::string& place) {
  Method m;
  ObjectReader r(json, place);
  r.read_choice("integrator", kIntegrators, m.integrator);
  r.read_choice("impacts", kImpacts, m.impacts);
  r.read_choice("contacts", kContacts, m.contacts);
  r.read("step", m.step);
  r.read("tolerance", m.tolerance);
  r.finish();
  return m;
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
