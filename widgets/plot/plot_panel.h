#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <qwt_interval.h>
#include <string>
#include <string_view>
#include <vector>

#include "physics/observe/quantity.h"
#include "physics/preset/preset.h"
#include "physics/record/recorder.h"
#include "widgets/plot/reading_table.h"
#include "widgets/plot/run_plot.h"
#include "widgets/theme/theme.h"

class QMenu;

namespace carom {

class RunsLegend;

// The plots of a run, one above the other over one time axis. Wheel: zoom in time about the cursor; with Ctrl:
// zoom that plot's values; Ctrl and a drag: zoom to a box; drag: move; double click or Home: back to showing
// everything. While zoomed the axes stand still. Click and Shift+click: marks A and B; the arrow keys move A,
// with Shift B, by one record; Escape takes both away. A right click offers the menu of plots.
class PlotPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PlotPanel(const Theme& theme, QWidget* parent = nullptr);
  ~PlotPanel() override;

  void set_theme(const Theme& theme);
  // Those that a scene with these bodies asks for; none: default_plots(). Nothing stays zoomed.
  void set_plots(const std::vector<Plot>& plots, const std::vector<Body>& bodies);
  // The same with other bodies; and with other plots, of which those that are shown already stay as they are.
  void set_bodies(const std::vector<Body>& bodies);
  void change_plots(const std::vector<Plot>& plots);
  // What is shown, as a scene would ask for it, and the curves that it needs.
  [[nodiscard]] std::vector<Plot> chosen() const;
  [[nodiscard]] std::vector<Curve> curves() const;
  // One more plot at the end, or another in the place of one. Throws SceneError as content_of() does.
  void add(const Plot& plot);
  void replace(RunPlot* old, const Plot& plot);
  // Takes a plot away, but for the last one. It is deleted when control is back in the event loop.
  void remove(RunPlot* plot);
  // Shows what the runs' recorders hold, never while hidden; they are read again when the user zooms. The first
  // run sets the time. While news come in quick succession each has one plot drawn anew, in turn, so that the
  // window is as quick with six plots as with one; the others follow when it is quiet.
  void update_from(const std::vector<PlottedRun>& runs);
  // All plots as they are to be now, at once.
  void show_now() { refresh(); }
  void reset_zoom();
  [[nodiscard]] ReadingMarks marks() const;
  void clear_marks();
  [[nodiscard]] std::vector<PlotContent> contents() const;
  // As they are shown now, or hidden by the reader.
  [[nodiscard]] const std::vector<PlottedRun>& runs() const { return runs_; }
  // Shows or hides one of named_plots(), but for the last plot.
  void set_shown(std::string_view id, bool shown);
  [[nodiscard]] bool shows(std::string_view id) const;

  // An entry for each plot, checked while it is shown.
  [[nodiscard]] QMenu* menu() const { return menu_; }
  [[nodiscard]] bool zoomed() const { return !zoomed_.empty(); }
  [[nodiscard]] const std::vector<RunPlot*>& plots() const { return plots_; }

 signals:
  // The user chose other plots: other curves are needed.
  void layoutChanged();
  // The reader marked another time, or looks at another part.
  void marksChanged();
  void pictureAsked(carom::RunPlot* plot);  // to be saved
  void dataAsked(carom::RunPlot* plot);
  void dataCopyAsked(carom::RunPlot* plot, bool shown);  // shown: only of the time that the plots show

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void insert(std::size_t place, const PlotContent& content);
  void drop(RunPlot* plot);
  void put_away(RunPlot* plot);
  [[nodiscard]] bool has(const RunPlot* plot) const;
  void changed();
  void edit(RunPlot* plot);  // nullptr: a new one
  void mark_menu();
  void connect_plot(RunPlot* plot);
  void set_time_zoom(RunPlot* plot, const QwtInterval& range);
  void mark_zoomed(RunPlot* plot);
  void set_mark(double time, bool second);
  void move_mark(int by, bool second);
  void schedule();  // all plots
  void schedule_next();
  void refresh();
  void refresh_next();
  void take_news(RunPlot* plot, const QwtInterval& range);
  void align();
  [[nodiscard]] QwtInterval time_range() const;

  Theme theme_;
  QMenu* menu_;  // which plots are shown
  std::vector<Body> bodies_;
  RunsLegend* legend_;
  std::vector<PlottedRun> runs_{{std::make_shared<const Recorder>(), {}}};
  std::vector<RunPlot*> plots_;
  std::vector<RunPlot*> zoomed_;           // those on which the user zoomed or moved
  std::optional<QwtInterval> time_zoom_;   // while set, all axes stand still
  std::optional<double> mark_a_, mark_b_;  // s
  QTimer timer_;                           // until all plots are drawn anew
  QTimer turn_;                            // until the next one is
  std::size_t next_ = 0;                   // whose turn it is
  std::size_t waiting_ = 0;                // plots that have not shown the news yet
  QwtInterval shown_;                      // the time range of the last refresh
};

}  // namespace carom
