#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "physics/record/replay.h"
#include "widgets/print/print_pages.h"
#include "widgets/scene/scene_export.h"

namespace carom {

class FigureModel;
class RunPlot;

// A run on paper, for a student to complete and hand in.
struct LabReport {
  static constexpr std::size_t kMostMoments = 12;

  QString title;
  QString observe;  // what to observe
  QString name, form, date;
  std::vector<double> times;  // s, ascending: times at which the scene is shown
  QStringList questions;      // the first is printed before the run, the others at the end

  // The scene's own method and the compared methods, and how far each run is.
  std::vector<RunSetup> runs;
  std::vector<Frame> ends;
  std::map<std::uint64_t, QString> edit_names;  // of edits of their scene, by the edits' ids
  double recorded = 0.0;                        // s: how far the first one is recorded
  bool until_shown = false;                     // the ends are at a moment of the record, not its end
  std::optional<double> first_impact;           // s
  SceneLook look;
  std::vector<RunPlot*> plots;          // as shown in the window
  const FigureModel* bodies = nullptr;  // since the start: printed for a run without impacts
  const FigureModel* ledger = nullptr;
};

// The default times of a report, in s: start, just before and just after the first impact (or thirds), end.
[[nodiscard]] std::vector<double> report_times(const Method& method, std::optional<double> first_impact,
                                               double end);
// Description of a time: "just before the first impact"; empty for any other time.
[[nodiscard]] QString moment_text(double time, const LabReport& report);

// The edits during the run of the scene's own method, a line each, as far as a page has room: "from t = 0.5 s:
// Mass of A 1 → 2 kg". An edit that was made by one drag is one line.
[[nodiscard]] QStringList edit_lines(const LabReport& report);

// The scene at the times of a report: a frame of each run; and the first moment with impacts, if there is one.
struct ReportMoments {
  std::vector<std::vector<Frame>> scenes;
  std::shared_ptr<const JumpMoment> first_impact;
};
// By replaying the runs. `progress` receives the completed share, 0 to 1; if it returns false there is no
// result. From any thread.
[[nodiscard]] std::optional<ReportMoments> report_moments(const LabReport& report,
                                                          const std::function<bool(double)>& progress);
// The pages, valid while the plots exist.
[[nodiscard]] PrintPages report_pages(const LabReport& report, const ReportMoments& moments);

}  // namespace carom
