#include "app/run_export.h"

#include <span>

#include "app/run_files.h"
#include "physics/experiment/sampler.h"

namespace carom {

bool export_data(const DataExport& what, const std::string& file, const std::function<bool(double)>& progress) {
  std::vector<Curve> curves;
  for (const Quantity& column : what.columns) curves.push_back({column, std::nullopt});
  const std::shared_ptr<const KeyFrame> moment = latest_before(what.key_frames, what.from, curves);
  Replay replay = moment ? Replay(moment->simulation, moment->edits) : Replay(what.log.start);
  Sampler sampler(curves);
  if (moment) {
    sampler = moment->sampler;
    sampler.set_curves(curves);
  } else {
    if (what.reference != ReferenceId::kNone) sampler.compare_with(Companion(what.log.start, what.reference));
    sampler.begin(replay.simulation());
  }
  TextFile out(file);
  std::vector<Body> bodies = all_bodies(what.log.start);
  for (const Edit& edit : what.log.edits) {
    if (const auto* body = std::get_if<Body>(&edit.what)) bodies.push_back(*body);
  }
  out.line(csv_header(what.columns, bodies));
  while (true) {
    while (const Edit* edit = replay.edit(what.log)) sampler.after_edit(replay.simulation(), *edit);
    const Rows rows = sampler.take();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows.times[i] < what.from || rows.times[i] > what.to) continue;
      out.line(csv_line(rows.times[i], std::span(rows.values).subspan(i * curves.size(), curves.size())));
    }
    const std::int64_t done = replay.simulation().steps();
    if (done >= what.steps || replay.simulation().time() > what.to) break;
    if (done % 64 == 0 && !progress(static_cast<double>(done) / static_cast<double>(what.steps))) return false;
    replay.step();
    sampler.after_step(replay.simulation());
  }
  out.finish();
  return true;
}

}  // namespace carom
