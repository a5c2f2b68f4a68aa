#pragma once

#include "physics/record/frame.h"
#include "physics/record/recorder.h"
#include "widgets/base/figure_table.h"
#include "widgets/run/impact_filter.h"

namespace carom {

// The impacts up to the newest moment that a filter keeps, the newest first or sorted by a column; while the
// run plays the newest kMostWhilePlaying of them. A click on one goes to its moment; those after the shown
// moment are pale.
class ImpactsTable : public FigureTable {
  Q_OBJECT

 public:
  static constexpr int kMostWhilePlaying = 500;
  explicit ImpactsTable(QWidget* parent = nullptr);
  void set_filter(const ImpactFilter& filter);  // of the next update
  // `shown`: s, up to which impacts have been met.
  void update_from(const Frame& newest, double shown, const Recorder& recorder);
  void show_impact(double time);  // s: marks its row, if there is one

 signals:
  void impactChosen(double time);  // s
};

}  // namespace carom
