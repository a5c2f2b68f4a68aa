#include "app/export/run_export.h"

#include <span>

#include "app/export/run_files.h"
#include "physics/files/output_file.h"
#include "physics/record/replay.h"
#include "physics/record/sampler.h"

namespace carom {
namespace {

// Replays the run and passes its rows to `put`, the header first. Stops and returns false if `put` or
// `progress` returns false.
bool write_lines(const DataExport& what, char separator, const std::function<bool(const std::string&)>& put,
                 const std::function<bool(double)>& progress) {
  std::vector<Curve> curves;
  for (const Quantity& column : what.columns) curves.push_back({column, std::nullopt});
  const bool impacts = curves.empty();
  const auto wanted = [&](double time) { return time >= what.from && time <= what.to; };
  const std::shared_ptr<const KeyFrame> moment = latest_before(what.key_frames, what.from, curves);
  Replay replay = moment ? Replay(*moment, what.setup.edits) : Replay(what.setup);
  const Simulation& simulation = replay.simulation();
  Sampler sampler(curves);
  if (moment) {
    sampler = moment->sampler;
    sampler.set_curves(curves);
  } else {
    if (what.reference != ReferenceId::kNone) sampler.compare_with(ReferenceRun(what.setup, what.reference));
    sampler.begin(simulation);
  }
  const std::vector<Body> bodies = all_bodies(what.setup);
  if (!put(impacts ? events_csv_header(separator) : csv_header(what.columns, bodies, separator))) return false;
  bool whole = true;
  const auto put_rows = [&] {
    const Rows rows = sampler.take();
    for (std::size_t i = 0; i < rows.size() && !impacts; ++i) {
      const auto values = std::span(rows.values).subspan(i * curves.size(), curves.size());
      if (wanted(rows.times[i]) && !put(csv_line(rows.times[i], values, separator))) return false;
    }
    return true;
  };
  replay.go_through([&](const RunEdit& edit) { sampler.after_edit(simulation, edit); },
                    [&](const Simulation& s) {
                      whole = whole && put_rows();
                      const bool ends = s.steps() >= what.steps || s.time() > what.to;
                      if (!ends && s.steps() % 64 == 0) {
                        whole =
                            whole && progress(static_cast<double>(s.steps()) / static_cast<double>(what.steps));
                      }
                      return whole && !ends;
                    },
                    [&](const Simulation& s) {
                      sampler.after_step(s);
                      for (const ImpactRecord& impact : s.last_impacts()) {
                        if (impacts && wanted(impact.time))
                          whole = whole && put(events_csv_line(s, impact, separator));
                      }
                    });
  return whole;
}

}  // namespace

std::optional<Simulation> run_at(const RunSetup& setup,
                                 const std::vector<std::shared_ptr<const KeyFrame>>& key_frames, double time,
                                 const std::function<bool(double)>& progress) {
  const std::shared_ptr<const KeyFrame> moment = latest_before(key_frames, time, {});
  Replay replay = moment ? Replay(*moment, setup.edits) : Replay(setup);
  const double begin = replay.simulation().time();
  bool cancelled = false;
  replay.go_through([](const RunEdit&) {},
                    [&](const Simulation& s) {
                      const double rounding = kSameMoment * s.method().step;
                      if (s.time() + s.next_step() > time + rounding) return false;
                      cancelled = s.steps() % 64 == 0 && !progress((s.time() - begin) / (time - begin));
                      return !cancelled;
                    },
                    [](const Simulation&) {});
  if (cancelled) return std::nullopt;
  Simulation there = replay.simulation();
  const double part = time - there.time();
  if (part > kSameMoment * there.method().step && !there.lost()) there.step(part);
  return there;
}

bool export_data(const DataExport& what, const std::string& file, const std::function<bool(double)>& progress) {
  OutputFile out(file);
  const auto put = [&](const std::string& line) {
    out.line(line);
    return !out.failed();
  };
  if (!write_lines(what, ',', put, progress) && !out.failed()) return false;
  out.commit();
  return true;
}

Copied copy_data(const DataExport& what, std::string& text, const std::function<bool(double)>& progress) {
  std::size_t lines = 0;  // with the header
  const auto put = [&](const std::string& line) {
    if (lines++ > kMostCopied) return false;
    text += line;
    text += '\n';
    return true;
  };
  if (write_lines(what, '\t', put, progress)) return Copied::kAll;
  return lines > kMostCopied + 1 ? Copied::kTooMany : Copied::kCancelled;
}

}  // namespace carom
