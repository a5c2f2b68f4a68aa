#include "physics/world/edit.h"

#include "physics/scene/method.h"

namespace carom {

void apply(const Edit& edit, Simulation& simulation) {
  if (const auto* method = std::get_if<Method>(&edit.what)) simulation.set_method(*method);
  if (const auto* body = std::get_if<Body>(&edit.what)) simulation.add_body(*body);
}

}  // namespace carom
