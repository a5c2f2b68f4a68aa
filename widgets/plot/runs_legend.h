#pragma once

#include <QWidget>
#include <vector>

#include "widgets/base/plotted_run.h"
#include "widgets/theme/theme.h"

class QGridLayout;

namespace carom {

class LegendButton;

// The names of the runs in all plots, each with its line; a click shows or hides a run. A single run has no
// legend.
class RunsLegend : public QWidget {
  Q_OBJECT

 public:
  explicit RunsLegend(QWidget* parent = nullptr);
  void show_runs(const std::vector<PlottedRun>& runs, const Theme& theme);

 signals:
  void toggled(std::size_t run, bool shown);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void place();  // in as many columns as the names allow

  QGridLayout* grid_;
  std::vector<LegendButton*> buttons_;
};

}  // namespace carom
