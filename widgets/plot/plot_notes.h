#pragma once

#include <QRectF>
#include <optional>
#include <qwt_plot_item.h>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"
#include "widgets/theme/theme.h"

namespace carom {

// The user's notes at points of a plot: a small ring with the text beside it, where there is room.
class PlotNotes : public QwtPlotItem {
 public:
  explicit PlotNotes(QwtPlot* plot);

  void set_notes(const std::vector<PlotNote>& notes);
  void set_theme(const Theme& theme);
  // The note whose ring or text is at this point of the canvas, in px.
  [[nodiscard]] std::optional<std::size_t> at(const QPointF& pixel) const;

  [[nodiscard]] int rtti() const override { return Rtti_PlotUserItem; }
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF& canvas) const override;

 private:
  // In px; empty for a note whose point is not shown.
  struct Place {
    QPointF point;
    QRectF words;
  };
  [[nodiscard]] std::optional<Place> place(const PlotNote& note, const QwtScaleMap& x, const QwtScaleMap& y,
                                           const QRectF& canvas) const;

  std::vector<PlotNote> notes_;
  Theme theme_;
};

}  // namespace carom
