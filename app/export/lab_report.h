#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "physics/record/replay.h"
#include "widgets/print/print_pages.h"
#include "widgets/scene/scene_export.h"

namespace carom {

class FigureModel;
class RunPlot;

// A run on paper, for a student to write on and to hand in.
struct LabReport {
  static constexpr std::size_t kMostMoments = 12;

  QString title;
  QString observe;  // what there is to see
  QString name, form, date;
  std::vector<double> times;  // s, ascending: the scene is shown at them
  QStringList questions;      // the first stands before the run, the others at the end

  // Of the scene's own method, and of those that are compared with it; and where they have come to.
  std::vector<RunLog> runs;
  std::vector<Frame> ends;
  std::optional<double> first_impact;  // s
  SceneLook look;
  std::vector<RunPlot*> plots;  // as they stand in the window
  const FigureModel* bodies = nullptr;
  const FigureModel* ledger = nullptr;
};

// Start, just before and just after the first impact or thirds, end, in s: what a report shows of the scene if
// nobody says something else.
[[nodiscard]] std::vector<double> report_times(const Method& method, std::optional<double> first_impact,
                                               double end);
// What a moment is beside its time: "just before the first impact"; empty where it is nothing of the kind.
[[nodiscard]] QString moment_text(double time, const LabReport& report);

// The scene at the times of a report: of each run its frame. None where `progress` answers false, which is told
// the share that is done, 0 to 1: the run is gone through once more for them. From any thread.
using ReportMoments = std::vector<std::vector<Frame>>;
[[nodiscard]] std::optional<ReportMoments> report_moments(const LabReport& report,
                                                          const std::function<bool(double)>& progress);
// The pages, for as long as the plots live.
[[nodiscard]] PrintPages report_pages(const LabReport& report, const ReportMoments& moments);

}  // namespace carom
