#pragma once

#include <string>
#include <vector>

#include "physics/measure/observables.h"
#include "physics/preset/object_reader.h"

namespace carom {

// The members "observable" and "bodies" of an object, as many bodies as the observable asks for.
[[nodiscard]] inline const Observable& read_observable(ObjectReader& r, std::string& name,
                                                       std::vector<std::string>& bodies) {
  r.require_text("observable", name);
  const Observable* observable = find_observable(name);
  if (observable == nullptr) {
    std::string names;
    for (const Observable& o : observables()) names += fmt::format("{}{}", names.empty() ? "" : ", ", o.name);
    refuse_value(r.at("observable"), "\"" + name + "\"", names);
  }
  r.read_array("bodies",
               [&](const Json& v, const std::string& at) { bodies.push_back(ObjectReader::text(v, at)); });
  if (static_cast<int>(bodies.size()) != observable->bodies) {
    refuse_value(r.at("bodies"), fmt::format("{} names", bodies.size()),
                 fmt::format("{} for \"{}\"", observable->bodies, name));
  }
  return *observable;
}

}  // namespace carom
