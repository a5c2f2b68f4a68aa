#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

#include "physics/record/replay.h"

namespace carom {

class BeforeAfterModel;
class FigureTable;
class LedgerTable;
class PlotPanel;
class RunPlot;
class SceneView;
class Session;
struct Film;
struct FilmFrames;
struct Frame;
struct LabReport;

// The exports of the lab. Each asks for a file and shows errors in a message. It writes the state at the time
// of the request, while the run continues. None replaces the open preset.
class LabExports : public QObject {
  Q_OBJECT

 public:
  struct Views {
    SceneView& scene;
    PlotPanel& plots;
    LedgerTable& ledger;
  };
  LabExports(QWidget* window, Session& session, const Views& views);

  void save_scene_picture();
  void copy_scene_picture();
  void save_plot(RunPlot* plot);
  void save_data(const RunPlot* plot);  // nullptr: no particular plot
  void copy_data(const RunPlot* plot, bool shown);
  void save_run();  // a preset that continues from the shown time
  void make_film();
  void make_report();  // of a paused run: waits for the current step

 private:
  using Then = std::function<void(const QString& file)>;
  void ask_for_export(const QString& title, const QString& suggestion, const QString& filter, const Then& then);
  void save_picture_as(const QString& stem, const std::function<bool(const QString&, QString*)>& save);
  void save_table(const FigureTable& table);
  void save_bins(const RunPlot& plot);  // of a histogram
  void copy_bins(const RunPlot& plot);
  void save_film_of(const Film& film, const QString& folder, bool replace);
  void write_report();
  [[nodiscard]] LabReport report_until(const std::vector<std::shared_ptr<const Frame>>& ends) const;
  void save_report(const LabReport& report, const QString& file);
  [[nodiscard]] bool has_run() const;
  [[nodiscard]] std::vector<RunSetup> runs() const;

  QWidget* window_;
  Session& session_;
  Views views_;
  BeforeAfterModel* bodies_;  // of a report
};

}  // namespace carom
