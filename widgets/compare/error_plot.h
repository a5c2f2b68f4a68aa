#pragma once

#include <QPen>
#include <array>
#include <optional>
#include <qwt_plot.h>
#include <vector>

#include "physics/study/study_table.h"
#include "widgets/compare/log_scale.h"
#include "widgets/theme/theme.h"

namespace carom {

// The errors that a study measures.
struct StudyError {
  const char* label;
  const char* unit;
  double StudyRow::*value;
};
inline constexpr std::array<StudyError, 6> kStudyErrors = {{
    {"position", "m", &StudyRow::position_error},
    {"velocity", "m/s", &StudyRow::velocity_error},
    {"angle", "m", &StudyRow::angle_error},
    {"spin", "m/s", &StudyRow::spin_error},
    {"energy", "J", &StudyRow::energy_error},
    {"impact-time", "s", &StudyRow::impact_time_error},
}};

// The quantity of the other axis.
enum class ErrorAgainst { kWallTime, kStep };

// The errors of a study, both axes logarithmic, drawn by Qwt: a curve for each method, points from its
// coarsest run on. For the error in position it marks the zones of rounding and of useless runs; against the
// step, the slopes of the orders 1, 2, 4 and 5. A method without a step is a horizontal line.
class ErrorPlot : public QwtPlot {
 public:
  // For a printed picture, or for a window with little room: no axis titles and only the labels that fit.
  enum class Place { kPicture, kWindow };
  ErrorPlot(const Theme& theme, Place place, QWidget* parent = nullptr);

  void set_theme(const Theme& theme);
  void show_study(const StudyFacts& facts, std::vector<StudyGroup> groups, ErrorAgainst against,
                  std::size_t error);  // of kStudyErrors

  // The run whose point or line is at this pixel of the canvas; valid until the next change.
  [[nodiscard]] const StudyRow* row_at(const QPointF& pixel) const;
  // Position of a run's point in pixels of the canvas; empty if it has none.
  [[nodiscard]] std::optional<QPointF> pixel_of(const StudyRow& row) const;
  // Draws a ring around its point; null removes the ring.
  void mark(const StudyRow* row);

  [[nodiscard]] QSize sizeHint() const override { return {300, 100}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {120, 60}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void rebuild();
  void set_ranges();
  [[nodiscard]] QString what_is_missing() const;  // text where there is nothing to draw
  void add_zones();
  void add_zone(double from, double to, const QString& label, Qt::Alignment side);
  void add_slopes();
  void add_method(const StudyGroup& group);
  void add_curve(const QVector<QPointF>& points, const QColor& color, ImpactsId impacts);
  void add_line(const QVector<QPointF>& points, const QPen& pen);
  void add_note(const QString& label, double x, double y, Qt::Alignment alignment, int spacing = 6);
  [[nodiscard]] double abscissa(const StudyRow& row) const;  // s; NaN where there is none
  [[nodiscard]] double shown_error(const StudyRow& row) const;
  [[nodiscard]] QFont font_of(int pixels) const;

  Theme theme_;
  Place place_;
  StudyFacts facts_;
  std::vector<StudyGroup> groups_;
  ErrorAgainst against_ = ErrorAgainst::kWallTime;
  StudyError error_ = kStudyErrors.front();
  LogRange x_{0.1, 1.0};
  LogRange errors_{0.1, 1.0};
  bool no_abscissa_ = true;
  bool no_error_ = true;
  int marked_ = -1;  // its index in the plan
};

}  // namespace carom
