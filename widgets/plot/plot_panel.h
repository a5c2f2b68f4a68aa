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
#include "widgets/plot/plot_before.h"
#include "widgets/plot/reading_table.h"
#include "widgets/plot/run_plot.h"
#include "widgets/theme/theme.h"

class QMenu;

namespace carom {

class RunsLegend;

// The plots of a run, one above the other over one time axis. Wheel: zoom in time about the cursor; with Ctrl:
// zoom that plot's values; Ctrl and a drag: zoom to a box; drag: move; double click or Ctrl+Home: back to
// showing everything. While zoomed the axes do not move. Click and Shift+click: marks A and B; the arrow keys
// move A, with Shift B, by one record; Escape removes both. A click on an impact chooses it. A right click
// opens the menu of plots.
class PlotPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PlotPanel(const Theme& theme, QWidget* parent = nullptr);
  ~PlotPanel() override;

  void set_theme(const Theme& theme);
  // Sets the plots of a scene with these bodies; none: default_plots(). Resets the zoom.
  void set_plots(const std::vector<Plot>& plots, const std::vector<Body>& bodies);
  // Theories of the first scene: plots that are set from now on have them marked, also those that an edit took.
  void set_first_theories(const FirstTheories& theories) { first_theories_ = theories; }
  // Updates the bodies, with plots of them; updates the plots, keeping those that are shown already.
  void set_bodies(const std::vector<Body>& bodies, const std::vector<Plot>& plots);
  void change_plots(const std::vector<Plot>& plots);
  // The visible plots, as in a preset, and the curves that they need.
  [[nodiscard]] std::vector<Plot> chosen() const;
  [[nodiscard]] std::vector<Curve> curves() const;
  // Adds a plot at the end, or replaces one. Throws SceneError as content_of() does.
  void add(const Plot& plot);
  void replace(RunPlot* old, const Plot& plot);
  // Removes a plot, except the last one. It is deleted when control is back in the event loop.
  void remove(RunPlot* plot);
  // Shows the records of the runs, never while hidden; they are read again when the user zooms. The first run
  // sets the time. All plots show the same moment. While new frames arrive fast, only every n-th redraws the n
  // plots, so that the window is as fast with six plots as with one; the last one is shown after a pause.
  void update_from(const std::vector<PlottedRun>& runs);
  // How long a run is (s), which the time axis shows from the start; 0: unknown.
  void set_duration(double seconds);
  // Shows the run before pale below the others; none: none is shown.
  void set_run_before(const std::optional<PaleRun>& run);
  // A line at the moment that is shown, if it is not the newest one (s).
  void set_playhead(std::optional<double> time);
  // Redraws all plots at once.
  void show_now() { refresh(); }
  void reset_zoom();
  [[nodiscard]] ReadingMarks marks() const;
  void set_mark(double time, bool second);  // A or B, s
  void clear_marks();
  [[nodiscard]] std::vector<PlotContent> contents() const;
  // The runs and whether the user has hidden them.
  [[nodiscard]] const std::vector<PlottedRun>& runs() const { return runs_; }
  // Shows or hides one of named_plots(), except the last plot.
  void set_shown(std::string_view id, bool shown);
  [[nodiscard]] bool shows(std::string_view id) const;

  // Whether this place (px) is in the line of a plot's title.
  [[nodiscard]] bool in_head(const QPoint& at) const;

  // A menu with an entry for each plot, checked while it is shown.
  [[nodiscard]] QMenu* menu() const { return menu_; }
  [[nodiscard]] bool zoomed() const { return !zoomed_.empty(); }
  [[nodiscard]] const std::vector<RunPlot*>& plots() const { return plots_; }

 signals:
  // The user chose other plots, which may need other curves.
  void layoutChanged();
  void plotAdded(carom::RunPlot* plot);  // one more, which should be seen
  // The user moved a mark or changed the visible time.
  void marksChanged();
  void impactChosen(double time);  // s, of a recorded impact, by its mark
  // A drag of the head of the line at the shown moment.
  void scrubBegan();
  void scrubbed(double time);  // s
  void scrubEnded();
  void pictureAsked(carom::RunPlot* plot);  // to be saved
  void dataAsked(carom::RunPlot* plot);
  void dataCopyAsked(carom::RunPlot* plot, bool shown);  // shown: only the visible time

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
  void take_back_mark();
  void move_mark(int by, bool second);
  void schedule();  // all plots
  void schedule_news();
  void refresh();
  void take_news(RunPlot* plot, const QwtInterval& range);
  void align();
  [[nodiscard]] QwtInterval time_range() const;

  Theme theme_;
  QMenu* menu_;  // which plots are shown
  std::vector<Body> bodies_;
  FirstTheories first_theories_;
  RunsLegend* legend_;
  std::vector<PlottedRun> runs_{{std::make_shared<const Recorder>(), {}}};
  std::vector<RunPlot*> plots_;
  std::vector<RunPlot*> zoomed_;           // those that the user zoomed or panned
  std::optional<QwtInterval> time_zoom_;   // while set, no axis moves
  std::optional<double> mark_a_, mark_b_;  // s
  std::optional<double> playhead_;         // s
  std::optional<PaleRun> before_;
  std::optional<std::pair<std::optional<double>, std::optional<double>>> before_mark_;  // by the last click
  double duration_ = 0.0;                                                               // s
  QTimer timer_;             // until the plots are redrawn
  QTimer quiet_;             // until frames that are not shown yet are
  std::size_t waiting_ = 0;  // such frames
  QwtInterval shown_;        // the time range of the last refresh
};

}  // namespace carom
