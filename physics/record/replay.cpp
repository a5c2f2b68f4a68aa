#include "physics/record/replay.h"

namespace carom {

const Edit* Replay::edit(const RunLog& log) {
  if (next_ >= log.edits.size() || log.edits[next_].step > simulation_.steps()) return nullptr;
  const Edit& edit = log.edits[next_++];
  apply(edit, simulation_);
  return &edit;
}

}  // namespace carom
