#include "widgets/compare/error_plot.h"

#include <algorithm>
#include <cmath>
#include <qwt_axis.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_zoneitem.h>
#include <qwt_scale_engine.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>
#include <qwt_symbol.h>
#include <qwt_text.h>

#include "widgets/base/method_look.h"

namespace carom {
namespace {

constexpr int kMostTicks = 9;         // of an axis in a picture
constexpr int kNear = 9;              // px: within this distance the mouse is on a point
constexpr int kNearLine = 4;          // px
constexpr QSize kLabelRoom(280, 15);  // px: smaller bands have no label
constexpr int kSlopeRoom = 170;       // px: in a lower plot slopes have none

// Drawing order: zones, grid, other items, curves.
constexpr double kZoneZ = 1.0;
constexpr double kNoteZ = 14.0;
constexpr double kLineZ = 15.0;
constexpr double kCurveZ = 20.0;
constexpr double kMarkZ = 30.0;

}  // namespace

ErrorPlot::ErrorPlot(const Theme& theme, Place place, QWidget* parent)
    : QwtPlot(parent), theme_(theme), place_(place) {
  setAutoReplot(false);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  static_cast<QwtPlotCanvas*>(canvas())->setFrameStyle(QFrame::NoFrame);
  plotLayout()->setAlignCanvasToScales(true);
  for (const int axis : {static_cast<int>(QwtAxis::XBottom), static_cast<int>(QwtAxis::YLeft)}) {
    setAxisScaleEngine(axis, new QwtLogScaleEngine);
    setAxisFont(axis, font_of(12));
    axisWidget(axis)->setMargin(0);
  }
}

void ErrorPlot::set_theme(const Theme& theme) {
  theme_ = theme;
  rebuild();
}

void ErrorPlot::show_study(const StudyFacts& facts, std::vector<StudyGroup> groups, ErrorAgainst against,
                           std::size_t error) {
  facts_ = facts;
  groups_ = std::move(groups);
  against_ = against;
  error_ = kStudyErrors[error];
  rebuild();
}

void ErrorPlot::resizeEvent(QResizeEvent* event) {
  QwtPlot::resizeEvent(event);
  rebuild();
}

QFont ErrorPlot::font_of(int pixels) const {
  QFont font;
  font.setPixelSize(place_ == Place::kPicture ? pixels : pixels - 1);
  return font;
}

double ErrorPlot::abscissa(const StudyRow& row) const {
  if (against_ == ErrorAgainst::kWallTime) return row.wall_time;
  return error_parameter(row.method) == ErrorParameter::kStep ? row.method.step : std::nan("");
}

// Position of an error on its axis; zero is just above the lower edge.
double ErrorPlot::shown_error(const StudyRow& row) const {
  const double error = row.*error_.value;
  return std::isnan(error) ? error : std::clamp(error, 1.4 * errors_.low, 1e3 * errors_.high);
}

void ErrorPlot::rebuild() {
  const bool steps = against_ == ErrorAgainst::kStep;
  const bool picture = place_ == Place::kPicture;
  detachItems();
  setCanvasBackground(theme_.panel);
  setAxisScaleDraw(QwtAxis::XBottom,
                   new LogScaleDraw(picture && steps ? power_label : duration_label, theme_.muted));
  setAxisScaleDraw(QwtAxis::YLeft, new LogScaleDraw(power_label, theme_.muted));
  if (picture) {
    QwtText title(steps ? "step / s" : "wall time of the run");
    title.setFont(font_of(13));
    title.setColor(theme_.text);
    setAxisTitle(QwtAxis::XBottom, title);
  }
  set_ranges();
  const QString missing = what_is_missing();
  setAxisVisible(QwtAxis::XBottom, missing.isEmpty());
  setAxisVisible(QwtAxis::YLeft, missing.isEmpty());
  if (missing.isEmpty()) {
    auto* grid = new QwtPlotGrid;
    grid->setPen(theme_.grid, 1.0);
    grid->attach(this);
    if (error_.value == &StudyRow::position_error) add_zones();
    if (steps) add_slopes();
    for (const StudyGroup& group : groups_) add_method(group);
  } else {
    add_note(missing, std::sqrt(x_.low * x_.high), std::sqrt(errors_.low * errors_.high), Qt::AlignCenter);
  }
  marked_ = -1;
  replot();
}

void ErrorPlot::set_ranges() {
  LogRange x;
  LogRange errors;
  for (const StudyGroup& group : groups_) {
    for (const StudyRow& row : group.rows) {
      x.take(abscissa(row));
      errors.take(row.*error_.value);
    }
  }
  if (errors.high == 0.0) errors = {};
  no_abscissa_ = x.empty();
  no_error_ = errors.empty();
  x_ = x.widened(against_ == ErrorAgainst::kStep ? 1.5 : 1.6);
  if (error_.value == &StudyRow::position_error && !groups_.empty()) {
    // If no error is near the floor, showing it would leave half of the plot empty.
    const double floor = facts_.rounding_floor();
    if (errors.empty()) errors = {floor, facts_.length};
    errors.low = std::max(errors.low, 0.01 * floor);
    errors.high = std::min(errors.high, 10.0 * facts_.length);
    if (errors.low < 1000.0 * floor) errors.low = std::min(errors.low, 0.3 * floor);
  }
  errors_ = errors.widened(2.0).whole_powers();

  const bool picture = place_ == Place::kPicture;
  const auto most = [picture](int pixels, int each) {
    return picture ? kMostTicks : std::clamp(pixels / each, 2, kMostTicks);
  };
  setAxisScaleDiv(QwtAxis::XBottom, log_ticks(x_, most(width(), 45)));
  setAxisScaleDiv(QwtAxis::YLeft, log_ticks(errors_, most(height(), 24)));
  updateAxes();
}

QString ErrorPlot::what_is_missing() const {
  const bool zero = std::any_of(groups_.begin(), groups_.end(), [this](const StudyGroup& group) {
    return std::any_of(group.rows.begin(), group.rows.end(),
                       [this](const StudyRow& row) { return row.*error_.value == 0.0; });
  });
  if (groups_.empty()) return " ";
  if (facts_.length == 0.0) return "nothing moves in this scene";
  if (no_error_ && error_.value != &StudyRow::position_error) {
    return zero ? "every such error is zero in this scene" : "there is no such error in this scene";
  }
  if (against_ == ErrorAgainst::kWallTime && no_abscissa_) {
    return "times are taken last, one run after another";
  }
  return {};
}

// Labels are placed where curves are rare: slow runs and small steps seldom have large errors.
void ErrorPlot::add_zones() {
  const Qt::Alignment side = against_ == ErrorAgainst::kWallTime ? Qt::AlignRight : Qt::AlignLeft;
  const double floor = std::min(facts_.rounding_floor(), errors_.high);
  if (floor > errors_.low) add_zone(errors_.low, floor, "rounding, accumulated until then", side);
  if (facts_.largest_error() < errors_.high) {
    add_zone(std::max(facts_.largest_error(), errors_.low), errors_.high,
             "wrong by a tenth of the scene or more", side);
  }
}

void ErrorPlot::add_zone(double from, double to, const QString& label, Qt::Alignment side) {
  auto* zone = new QwtPlotZoneItem;
  zone->setOrientation(Qt::Horizontal);
  zone->setInterval(from, to);
  zone->setBrush(theme_.window);
  zone->setPen(QPen(Qt::NoPen));
  zone->setZ(kZoneZ);
  zone->attach(this);
  if (place_ == Place::kWindow) {
    const QwtScaleMap map = canvasMap(QwtAxis::YLeft);
    const double high = std::abs(map.transform(from) - map.transform(to));
    if (high < kLabelRoom.height() || canvas()->width() < kLabelRoom.width()) return;
  }
  // A label aligned right of its point is at the left edge.
  const bool left = side == Qt::AlignLeft;
  add_note(label, left ? x_.low : x_.high, std::sqrt(from * to),
           (left ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
}

void ErrorPlot::add_note(const QString& label, double x, double y, Qt::Alignment alignment, int spacing) {
  QwtText text(label, QwtText::PlainText);
  text.setFont(font_of(11));
  text.setColor(theme_.muted);
  auto* note = new QwtPlotMarker;
  note->setLabel(text);
  note->setLabelAlignment(alignment);
  note->setSpacing(spacing);
  note->setValue(x, y);
  note->setZ(kNoteZ);
  note->attach(this);
}

void ErrorPlot::add_curve(const QVector<QPointF>& points, const QColor& color, ImpactsId impacts) {
  auto* curve = new QwtPlotCurve;
  curve->setSamples(points);
  curve->setRenderHint(QwtPlotItem::RenderAntialiased);
  curve->setPaintAttribute(QwtPlotCurve::ClipPolygons, true);
  curve->setPen(line_of(color, impacts));
  const QwtSymbol look = symbol_of(color, impacts, theme_, place_ == Place::kPicture ? 8 : 6);
  curve->setSymbol(new QwtSymbol(look.style(), look.brush(), look.pen(), look.size()));
  curve->setZ(impacts == ImpactsId::kLocated ? kCurveZ + 1.0 : kCurveZ);
  curve->attach(this);
}

void ErrorPlot::add_line(const QVector<QPointF>& points, const QPen& pen) {
  auto* line = new QwtPlotCurve;
  line->setSamples(points);
  line->setRenderHint(QwtPlotItem::RenderAntialiased);
  line->setPaintAttribute(QwtPlotCurve::ClipPolygons, true);
  line->setPen(pen);
  line->setZ(kLineZ);
  line->attach(this);
}

// Lines of the orders' slopes from one point: the largest errors that a fit can use, at the coarsest step.
void ErrorPlot::add_slopes() {
  double from_error = 0.0;
  for (const StudyGroup& group : groups_) {
    if (group.verdict().kind != OrderFit::Kind::kOrder) continue;
    for (const StudyRow& row : group.rows) {
      if (row.position_error < facts_.largest_error()) from_error = std::fmax(from_error, row.*error_.value);
    }
  }
  const bool position = error_.value == &StudyRow::position_error;
  const double least = position ? std::max(errors_.low, facts_.rounding_floor()) : errors_.low;
  if (from_error <= least) return;
  QColor faint = theme_.muted;
  faint.setAlphaF(0.55F);
  for (const int order : {1, 2, 4, 5}) {
    // To the left edge, or down to `least`.
    const double to_error = std::max(from_error * std::pow(x_.low / x_.high, order), least);
    const double to_step = x_.high * std::pow(to_error / from_error, 1.0 / order);
    add_line({{to_step, to_error}, {x_.high, from_error}}, QPen(faint, 1.0, Qt::DotLine));
    if (place_ == Place::kWindow && height() < kSlopeRoom) continue;
    const bool leaves_below = to_error <= least * 1.0001;
    const double share = leaves_below ? 0.035 : 0.03;  // of the line, so that the label is inside
    add_note(QString("order %1").arg(order), to_step * std::pow(x_.high / to_step, share),
             to_error * std::pow(from_error / to_error, share),
             leaves_below ? Qt::AlignRight | Qt::AlignTop : Qt::AlignRight | Qt::AlignBottom);
  }
}

void ErrorPlot::add_method(const StudyGroup& group) {
  const QColor color = color_of(group.integrator, theme_);
  QVector<QPointF> points;
  for (const StudyRow& row : group.rows) {
    const QPointF point(abscissa(row), shown_error(row));
    if (!std::isnan(point.x()) && !std::isnan(point.y())) points.append(point);
  }
  const bool everywhere =
      against_ == ErrorAgainst::kStep && error_parameter(group.rows.front().method) == ErrorParameter::kNone;
  const double level = shown_error(group.rows.front());
  if (everywhere && !std::isnan(level)) {
    add_line({{x_.low, level}, {x_.high, level}}, line_of(color, group.impacts));
  } else if (against_ == ErrorAgainst::kWallTime || !points.isEmpty()) {
    add_curve(points, color, group.impacts);
  }
}

std::optional<QPointF> ErrorPlot::pixel_of(const StudyRow& row) const {
  const QPointF point(abscissa(row), shown_error(row));
  if (std::isnan(point.x()) || std::isnan(point.y())) return {};
  return QPointF(canvasMap(QwtAxis::XBottom).transform(point.x()),
                 canvasMap(QwtAxis::YLeft).transform(point.y()));
}

const StudyRow* ErrorPlot::row_at(const QPointF& pixel) const {
  const StudyRow* nearest = nullptr;
  const StudyRow* on_line = nullptr;
  double least = kNear;
  for (const StudyGroup& group : groups_) {
    for (const StudyRow& row : group.rows) {
      if (const auto point = pixel_of(row)) {
        const double distance = std::hypot(point->x() - pixel.x(), point->y() - pixel.y());
        if (distance <= least) {
          least = distance;
          nearest = &row;
        }
      } else if (against_ == ErrorAgainst::kStep && error_parameter(row.method) == ErrorParameter::kNone) {
        const double level = canvasMap(QwtAxis::YLeft).transform(shown_error(row));
        if (std::abs(level - pixel.y()) <= kNearLine) on_line = &row;
      }
    }
  }
  return nearest != nullptr ? nearest : on_line;
}

void ErrorPlot::mark(const StudyRow* row) {
  const std::optional<QPointF> pixel = row == nullptr ? std::nullopt : pixel_of(*row);
  const int index = pixel ? row->index : -1;
  if (index == marked_) return;
  marked_ = index;
  detachItems(QwtPlotItem::Rtti_PlotUserItem);
  if (pixel) {
    class Ring : public QwtPlotMarker {
     public:
      [[nodiscard]] int rtti() const override { return QwtPlotItem::Rtti_PlotUserItem; }
    };
    auto* ring = new Ring;
    ring->setSymbol(
        new QwtSymbol(QwtSymbol::Ellipse, QBrush(Qt::NoBrush), QPen(theme_.text, 1.6), QSize(13, 13)));
    ring->setRenderHint(QwtPlotItem::RenderAntialiased);
    ring->setValue(abscissa(*row), shown_error(*row));
    ring->setZ(kMarkZ);
    ring->attach(this);
  }
  replot();
}

}  // namespace carom
