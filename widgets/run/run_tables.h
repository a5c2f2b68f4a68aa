#pragma once

#include <vector>

#include "physics/record/frame.h"
#include "physics/record/recorder.h"
#include "widgets/base/figure_table.h"

namespace carom {

// The last kMostRows impacts up to the newest moment, the newest first. A click on one goes to its moment;
// those after the shown moment are pale.
class ImpactsTable : public FigureTable {
  Q_OBJECT

 public:
  static constexpr int kMostRows = 500;
  explicit ImpactsTable(QWidget* parent = nullptr);
  void update_from(const Frame& newest, const Frame& shown, const Recorder& recorder);

 signals:
  void impactChosen(double time);  // s
};

}  // namespace carom
