#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>
#include <qwt_interval.h>
#include <string>
#include <string_view>
#include <vector>

#include "physics/measure/recorder.h"
#include "widgets/theme.h"

class QMenu;

namespace carom {

struct PlotKind;
class TimePlot;

// The plots of a run, one above the other over one time axis. Wheel: zoom in time about the cursor; with Ctrl:
// zoom that plot's values; drag: move; double click or Home: back to showing everything. While zoomed the axes
// stand still. A right click offers the menu of plots.
class PlotPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PlotPanel(const Theme& theme, QWidget* parent = nullptr);

  void set_theme(const Theme& theme);
  // Ids of plot_table(); unknown ones are left out. None: default_plots(). Nothing stays zoomed.
  void set_plots(const std::vector<std::string>& ids);
  // Shows what the recorder holds, at most once a turn of the event loop and never while hidden. The recorder
  // is read again when the user zooms: it must live as long as the panel is used.
  void update_from(const Recorder& recorder);
  void reset_zoom();
  // Shows or hides one plot of plot_table(), but for the last one.
  void set_shown(std::string_view id, bool shown);
  [[nodiscard]] bool shows(std::string_view id) const;

  // An entry for each plot, checked while it is shown.
  [[nodiscard]] QMenu* menu() const { return menu_; }
  [[nodiscard]] bool zoomed() const { return !zoomed_.empty(); }
  [[nodiscard]] const std::vector<TimePlot*>& plots() const { return plots_; }

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void add_plot(const PlotKind& kind);
  void mark_menu();
  void connect_plot(TimePlot* plot);
  void set_time_zoom(TimePlot* plot, const QwtInterval& range);
  void mark_zoomed(TimePlot* plot);
  void schedule();
  void refresh();
  [[nodiscard]] QwtInterval time_range() const;

  Theme theme_;
  QMenu* menu_;  // which plots are shown
  Recorder nothing_;
  const Recorder* recorder_ = &nothing_;
  std::vector<TimePlot*> plots_;
  std::vector<TimePlot*> zoomed_;         // those on which the user zoomed or moved
  std::optional<QwtInterval> time_zoom_;  // while set, all axes stand still
  QTimer timer_;
};

}  // namespace carom
