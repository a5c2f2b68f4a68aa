#include "physics/experiment/run_log.h"

namespace carom {

void apply(const Edit& edit, Simulation& simulation) {
  if (const auto* method = std::get_if<Method>(&edit.what)) simulation.set_method(*method);
  if (const auto* body = std::get_if<Body>(&edit.what)) simulation.add_body(*body);
}

const Edit* Replay::edit(const RunLog& log) {
  if (next_ >= log.edits.size() || log.edits[next_].step > simulation_.steps()) return nullptr;
  const Edit& edit = log.edits[next_++];
  apply(edit, simulation_);
  return &edit;
}

}  // namespace carom
