#pragma once

#include <QDialog>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace carom {

class CurveRow;
class QuantityPicker;

// Edits a plot: quantities and closed forms, the x axis, a logarithmic axis, a title. OK is enabled while the
// plot is valid; otherwise a line shows the error.
class PlotDialog : public QDialog {
  Q_OBJECT

 public:
  static constexpr std::size_t kMostCurves = 6;  // as many as there are colours

  explicit PlotDialog(const std::vector<Body>& bodies, QWidget* parent = nullptr);
  void set_plot(const Plot& plot);
  [[nodiscard]] Plot plot() const;

 private:
  CurveRow* add_curve();
  void check();
  [[nodiscard]] QuantityName next_body(QuantityName quantity) const;

  std::vector<Body> bodies_;
  QVBoxLayout* rows_layout_;
  std::vector<CurveRow*> rows_;
  std::vector<PlotNote> notes_;  // of the edited plot, kept unchanged
  QPushButton* another_;
  QuantityPicker* x_;
  QCheckBox* logarithmic_;
  QLineEdit* title_;
  QLabel* message_;
  QPushButton* ok_;
};

}  // namespace carom
