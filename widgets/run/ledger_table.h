#pragma once

#include "physics/preset/preset.h"
#include "physics/record/frame.h"
#include "widgets/theme/figure_table.h"

namespace carom {

// Where the energy of a run went, and its momentum beside it, each down to the numerical drift. Entries that
// the scene cannot touch are pale, and say so in their tooltips.
class LedgerTable : public FigureTable {
  Q_OBJECT

 public:
  explicit LedgerTable(QWidget* parent = nullptr);
  // The scene as it is now, after each edit.
  void set_scene(const Preset& preset);
  void update_from(const Frame& frame);
};

}  // namespace carom
