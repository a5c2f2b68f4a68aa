#pragma once

#include "physics/preset/preset.h"
#include "physics/record/frame.h"
#include "widgets/base/figure_table.h"

namespace carom {

// The energy balance of a run and, beside it, the momentum balance, each ending with the numerical drift.
// Entries that the scene cannot change are pale; their tooltips say so.
class LedgerTable : public FigureTable {
  Q_OBJECT

 public:
  explicit LedgerTable(QWidget* parent = nullptr);
  // Sets the current scene, after each edit.
  void set_scene(const Preset& preset);
  void update_from(const Frame& frame);
};

}  // namespace carom
