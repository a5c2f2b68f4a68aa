#include "widgets/study_plot.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <qwt_axis.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_renderer.h>
#include <qwt_plot_zoneitem.h>
#include <qwt_scale_engine.h>
#include <qwt_scale_widget.h>
#include <qwt_symbol.h>
#include <qwt_text.h>
#include <vector>

#include "physics/measure/study_text.h"
#include "physics/motion/integrators.h"
#include "widgets/picture_file.h"

namespace carom {
namespace {

// px of the picture
constexpr QSize kSize(1440, 800);
constexpr int kMargin = 32;
constexpr int kTop = 92;  // of the plots
constexpr int kPlotWidth = 505;
constexpr int kPlotHeight = 540;
constexpr int kGap = 24;
constexpr double kLineWidth = 1.7;
constexpr int kMarker = 8;

QFont font_of(int pixels, bool bold = false) {
  QFont font;
  font.setPixelSize(pixels);
  font.setBold(bold);
  return font;
}

// One colour for each integrator, by its place in the table of all; the theme has six, text is the seventh.
QColor color_of(IntegratorId id, const Theme& theme) {
  std::size_t place = 0;
  while (place < kIntegrators.size() && kIntegrators[place].id != id) ++place;
  return place < theme.series.size() ? theme.series[place] : theme.text;
}

bool is_located(ImpactsId id) { return id == ImpactsId::kLocated; }

QPen line_of(const QColor& color, ImpactsId impacts) {
  QPen pen(color, kLineWidth);
  if (!is_located(impacts)) pen.setDashPattern({4.0, 2.5});
  return pen;
}

QwtSymbol symbol_of(const QColor& color, ImpactsId impacts, const Theme& theme) {
  const bool located = is_located(impacts);
  return {located ? QwtSymbol::Ellipse : QwtSymbol::Rect, located ? QBrush(color) : QBrush(theme.panel),
          QPen(color, 1.4), QSize(kMarker, kMarker)};
}

QString superscript(int number) {
  static const QString kDigits = QString::fromUtf8("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString out;
  for (const QChar c : QString::number(std::abs(number))) out += kDigits[c.digitValue()];
  return (number < 0 ? QString::fromUtf8("⁻") : QString()) + out;
}

// 10⁻⁵ or, with a mantissa, 2·10⁻⁵; plain from 0.001 to 1000.
QString power_label(double value) {
  if (!(value > 0.0)) return {};  // a scale that is not set yet
  const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  if (power >= -3 && power <= 3) return QString::number(value, 'g', 3);
  const int mantissa = static_cast<int>(std::lround(value / std::pow(10.0, power)));
  const QString ten = "10" + superscript(power);
  return mantissa == 1 ? ten : QString::number(mantissa) + QString::fromUtf8("·") + ten;
}

QString time_label(double seconds) {
  if (seconds < 0.99e-6) return QString::number(seconds * 1e9, 'g', 3) + " ns";
  if (seconds < 0.99e-3) return QString::number(seconds * 1e6, 'g', 3) + QString::fromUtf8(" µs");
  if (seconds < 0.99) return QString::number(seconds * 1e3, 'g', 3) + " ms";
  return QString::number(seconds, 'g', 3) + " s";
}

class LabelDraw : public QwtScaleDraw {
 public:
  LabelDraw(QString (*text_of_value)(double), const Theme& theme) : label_(text_of_value), color_(theme.muted) {
    enableComponent(Backbone, false);
    enableComponent(Ticks, false);
    setSpacing(6);
  }
  [[nodiscard]] QwtText label(double value) const override {
    QwtText text(label_(value), QwtText::PlainText);
    text.setColor(color_);
    return text;
  }

 private:
  QString (*label_)(double);
  QColor color_;
};

// Powers of ten, all of them or every n-th; on a short axis the twos and fives between.
QwtScaleDiv log_ticks(double low, double high, int most) {
  const int from = static_cast<int>(std::floor(std::log10(low) + 1e-9));
  const int to = static_cast<int>(std::ceil(std::log10(high) - 1e-9));
  QList<double> major;
  const double slack = 1.0 + 1e-9;
  const auto add = [&](double value) {
    if (value >= low / slack && value <= high * slack) major.append(value);
  };
  const int every = (to - from) / most + 1;
  const bool between = to - from <= 3;
  for (int power = from; power <= to; ++power) {
    if ((power - from) % every != 0) continue;
    add(std::pow(10.0, power));
    if (!between) continue;
    add(2.0 * std::pow(10.0, power));
    add(5.0 * std::pow(10.0, power));
  }
  return QwtScaleDiv(low, high, {}, {}, major);
}

// One of the two plots, in which the values of an axis are read from a row by `at`.
class ErrorPlot : public QwtPlot {
 public:
  ErrorPlot(const Theme& theme, const QString& x_title, QString (*x_label)(double)) : theme_(theme) {
    setAutoReplot(false);
    setCanvasBackground(theme.panel);
    static_cast<QwtPlotCanvas*>(canvas())->setFrameStyle(QFrame::NoFrame);
    plotLayout()->setAlignCanvasToScales(true);
    setAxisScaleEngine(QwtAxis::XBottom, new QwtLogScaleEngine);
    setAxisScaleEngine(QwtAxis::YLeft, new QwtLogScaleEngine);
    setAxisScaleDraw(QwtAxis::XBottom, new LabelDraw(x_label, theme));
    setAxisScaleDraw(QwtAxis::YLeft, new LabelDraw(power_label, theme));
    for (const int axis : {static_cast<int>(QwtAxis::XBottom), static_cast<int>(QwtAxis::YLeft)}) {
      setAxisFont(axis, font_of(12));
      axisWidget(axis)->setMargin(0);
    }
    QwtText title(x_title);
    title.setFont(font_of(13));
    title.setColor(theme.text);
    setAxisTitle(QwtAxis::XBottom, title);
    auto* grid = new QwtPlotGrid;
    grid->setPen(theme.grid, 1.0);
    grid->attach(this);
  }

  void set_range(QwtAxisId axis, double low, double high, int most_ticks) {
    setAxisScaleDiv(axis, log_ticks(low, high, most_ticks));
    updateAxes();
  }

  // The label stands at the given side, where there are no curves.
  void add_zone(double from, double to, const QString& label, Qt::Alignment side) {
    auto* zone = new QwtPlotZoneItem;
    zone->setOrientation(Qt::Horizontal);
    zone->setInterval(from, to);
    const QColor ground = theme_.window;
    zone->setBrush(ground);
    zone->setPen(QPen(Qt::NoPen));
    zone->setZ(1.0);  // below the grid
    zone->attach(this);
    // A label aligned to the right of its point stands at the left edge.
    const QwtScaleDiv& x = axisScaleDiv(QwtAxis::XBottom);
    const bool left = side == Qt::AlignLeft;
    add_note(label, left ? x.lowerBound() : x.upperBound(), std::sqrt(from * to),
             (left ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }

  void add_note(const QString& label, double x, double y, Qt::Alignment alignment) {
    QwtText text(label, QwtText::PlainText);
    text.setFont(font_of(11));
    text.setColor(theme_.muted);
    auto* note = new QwtPlotMarker;
    note->setLabel(text);
    note->setLabelAlignment(alignment);
    note->setSpacing(6);
    note->setValue(x, y);
    note->setZ(14.0);  // below the curves
    note->attach(this);
  }

  void add_curve(const QVector<QPointF>& points, const QColor& color, ImpactsId impacts) {
    auto* curve = new QwtPlotCurve;
    curve->setSamples(points);
    curve->setRenderHint(QwtPlotItem::RenderAntialiased);
    curve->setPaintAttribute(QwtPlotCurve::ClipPolygons, true);
    curve->setPen(line_of(color, impacts));
    const QwtSymbol look = symbol_of(color, impacts, theme_);
    curve->setSymbol(new QwtSymbol(look.style(), look.brush(), look.pen(), look.size()));
    curve->setZ(is_located(impacts) ? 21.0 : 20.0);
    curve->attach(this);
  }

  void add_line(const QVector<QPointF>& points, const QPen& pen) {
    auto* line = new QwtPlotCurve;
    line->setSamples(points);
    line->setRenderHint(QwtPlotItem::RenderAntialiased);
    line->setPaintAttribute(QwtPlotCurve::ClipPolygons, true);
    line->setPen(pen);
    line->setZ(15.0);
    line->attach(this);
  }

 private:
  const Theme& theme_;
};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  void take(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // With room on both sides.
  [[nodiscard]] Range widened(double factor) const {
    if (high == 0.0) return {0.1, 1.0};
    return {low / factor, high * factor};
  }
};

// s: the step; NaN where a method has none.
double step_of(const StudyRow& row) {
  return error_knob(row.method) == ErrorKnob::kStep ? row.method.step : std::nan("");
}

Range errors_of(const StudyTable& table) {
  Range range;
  for (const StudyRow& row : table.rows) range.take(row.position_error);
  // A floor that hardly any error comes near would leave half of the plot empty.
  const double floor = table.facts.rounding_floor();
  if (range.high == 0.0) range = {floor, table.facts.length};
  range.low = std::max(range.low, 0.01 * floor);
  range.high = std::min(range.high, 10.0 * table.facts.length);
  if (range.low < 1000.0 * floor) range.low = std::min(range.low, 0.3 * floor);
  range = range.widened(2.0);
  range.low = std::pow(10.0, std::floor(std::log10(range.low)));
  range.high = std::pow(10.0, std::ceil(std::log10(range.high)));
  return range;
}

// Where an error stands on its axis: zero, too, just above the lower edge.
double shown(double error, const Range& errors) {
  return std::clamp(error, 1.4 * errors.low, 1e3 * errors.high);
}

// The points of a method.
template <class At>
QVector<QPointF> points_of(const StudyGroup& group, const Range& errors, const At& at) {
  QVector<QPointF> points;
  for (const StudyRow& row : group.rows) {
    const double x = at(row);
    if (std::isnan(x) || std::isnan(row.position_error)) continue;
    points.append({x, shown(row.position_error, errors)});
  }
  return points;
}

// The labels stand where there are few curves: slow runs are seldom wrong, small steps neither.
void add_zones(ErrorPlot& plot, const StudyFacts& facts, const Range& errors, Qt::Alignment side) {
  const double floor = std::min(facts.rounding_floor(), errors.high);
  if (floor > errors.low) plot.add_zone(errors.low, floor, "rounding, grown until then", side);
  if (facts.largest_error() < errors.high) {
    plot.add_zone(std::max(facts.largest_error(), errors.low), errors.high,
                  "wrong by a tenth of the scene or more", side);
  }
}

// Lines of slope 1, 2, 4 and 5 that run down from one point, as far as `least`.
void add_slopes(ErrorPlot& plot, const Range& steps, double least, double from_error, const Theme& theme) {
  QColor faint = theme.muted;
  faint.setAlphaF(0.55F);
  for (const int order : {1, 2, 4, 5}) {
    // To the left edge, or down to `least`.
    const double to_error = std::max(from_error * std::pow(steps.low / steps.high, order), least);
    const double to_step = steps.high * std::pow(to_error / from_error, 1.0 / order);
    plot.add_line({{to_step, to_error}, {steps.high, from_error}}, QPen(faint, 1.0, Qt::DotLine));
    const bool leaves_below = to_error <= least * 1.0001;
    const double share = leaves_below ? 0.035 : 0.03;  // of the line, so that the label stands inside
    plot.add_note(QString("order %1").arg(order), to_step * std::pow(steps.high / to_step, share),
                  to_error * std::pow(from_error / to_error, share),
                  leaves_below ? Qt::AlignRight | Qt::AlignTop : Qt::AlignRight | Qt::AlignBottom);
  }
}

void draw_text(QPainter& painter, const QRectF& where, int flags, const QString& text, const QFont& font,
               const QColor& color) {
  painter.setFont(font);
  painter.setPen(color);
  painter.drawText(where, flags, text);
}

// Qwt scales to the resolution of the device; the painter is in px already.
void render(QwtPlot& plot, QPainter& painter, const QRectF& where) {
  const double scale = static_cast<double>(painter.device()->logicalDpiX()) / plot.logicalDpiX();
  QwtPlotRenderer renderer;
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardCanvasFrame);
  painter.save();
  painter.scale(1.0 / scale, 1.0 / scale);
  renderer.render(&plot, &painter, QRectF(where.topLeft() * scale, where.size() * scale));
  painter.restore();
}

void draw_sample(QPainter& painter, QPointF center, const QColor& color, ImpactsId impacts,
                 const Theme& theme) {
  constexpr double kHalf = 17.0;  // px
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(line_of(color, impacts));
  painter.drawLine(center - QPointF(kHalf, 0.0), center + QPointF(kHalf, 0.0));
  symbol_of(color, impacts, theme).drawSymbol(&painter, center);
  painter.restore();
}

// The orders, a row for each integrator, a column for each choice of impacts.
void draw_orders(QPainter& painter, const QRectF& where, const std::vector<StudyGroup>& groups,
                 const Theme& theme) {
  constexpr double kRow = 50.0;
  constexpr double kColumn = 88.0;
  const double first = where.left() + (where.width() - kColumn * kImpacts.size());
  double y = where.top();
  draw_text(painter, {where.left(), y, where.width(), 20}, Qt::AlignLeft, "Fitted order of the error",
            font_of(13, true), theme.text);
  y += 34.0;
  draw_text(painter, {first, y, kColumn * kImpacts.size(), 18}, Qt::AlignHCenter, "impacts resolved",
            font_of(11), theme.muted);
  y += 22.0;
  for (std::size_t i = 0; i < kImpacts.size(); ++i) {
    const QRectF cell(first + kColumn * static_cast<double>(i), y, kColumn, 42.0);
    draw_text(painter, cell, Qt::AlignHCenter | Qt::AlignTop,
              is_located(kImpacts[i].id) ? "at own time" : "at step's end", font_of(11), theme.muted);
    draw_sample(painter, {cell.center().x(), cell.top() + 27.0}, theme.text, kImpacts[i].id, theme);
  }
  y += 40.0;
  for (const IntegratorChoice& integrator : kIntegrators) {
    bool any = false;
    for (const StudyGroup& g : groups) any = any || g.integrator == integrator.id;
    if (!any) continue;
    painter.setPen(QPen(theme.border, 1.0));
    painter.drawLine(QPointF(where.left(), y), QPointF(where.right(), y));
    const QColor color = color_of(integrator.id, theme);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawRoundedRect(QRectF(where.left(), y + kRow / 2 - 9, 5, 18), 2, 2);
    painter.setBrush(Qt::NoBrush);
    draw_text(painter, {where.left() + 13, y, first - where.left() - 15, kRow},
              Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
              QString::fromUtf8(integrator.label.data(), static_cast<qsizetype>(integrator.label.size())),
              font_of(12), theme.text);
    for (std::size_t i = 0; i < kImpacts.size(); ++i) {
      const auto g = std::find_if(groups.begin(), groups.end(), [&](const StudyGroup& one) {
        return one.integrator == integrator.id && one.impacts == kImpacts[i].id;
      });
      if (g == groups.end()) continue;
      const QRectF cell(first + kColumn * static_cast<double>(i), y, kColumn, kRow);
      const bool number = g->fit.kind == OrderFit::Kind::kOrder;
      const QString order =
          number ? QString::number(g->fit.order, 'f', 2) : QString::fromStdString(text_of(g->fit));
      if (!number) {
        draw_text(painter, cell, Qt::AlignCenter, order, font_of(12, g->fit.kind == OrderFit::Kind::kExact),
                  g->fit.kind == OrderFit::Kind::kExact ? color.darker(115) : theme.muted);
        continue;
      }
      draw_text(painter, cell.adjusted(0, 6, 0, -20), Qt::AlignCenter, order, font_of(15, true),
                color.darker(115));
      const QString below = error_knob(g->rows.front().method) == ErrorKnob::kTolerance
                                ? QString("of tolerance")
                                : QString::fromUtf8("± %1").arg(QString::number(g->fit.uncertainty, 'f', 2));
      draw_text(painter, cell.adjusted(0, 27, 0, -5), Qt::AlignCenter, below, font_of(11), theme.muted);
    }
    y += kRow;
  }
  painter.setPen(QPen(theme.border, 1.0));
  painter.drawLine(QPointF(where.left(), y), QPointF(where.right(), y));
}

void paint_study(QPainter& painter, const StudyTable& table, const std::vector<StudyGroup>& groups,
                 QwtPlot& against_time, QwtPlot& against_step, const Theme& theme) {
  painter.fillRect(QRectF(QPointF(), QSizeF(kSize)), theme.panel);
  const StudyFacts& f = table.facts;
  const double width = kSize.width() - 2.0 * kMargin;
  draw_text(painter, {kMargin, 20, width, 30}, Qt::AlignLeft | Qt::AlignVCenter,
            QString::fromStdString(f.title) + QString::fromUtf8(": speed against error"), font_of(21, true),
            theme.text);
  draw_text(painter, {kMargin, 52, width, 20}, Qt::AlignLeft | Qt::AlignVCenter,
            QString::fromUtf8("Error in position / m at t = %1 s: the largest over the moving bodies' centres")
                .arg(f.time, 0, 'g', 5),
            font_of(13), theme.muted);
  const QRectF left(kMargin, kTop, kPlotWidth, kPlotHeight);
  const QRectF right = left.translated(kPlotWidth + kGap, 0);
  render(against_time, painter, left);
  render(against_step, painter, right);
  draw_orders(
      painter,
      {right.right() + kGap + 4, kTop + 6.0, kSize.width() - kMargin - right.right() - kGap - 4, kPlotHeight},
      groups, theme);
  painter.setPen(QPen(theme.border, 1.0));
  const double below = kTop + kPlotHeight + 18.0;
  painter.drawLine(QPointF(kMargin, below), QPointF(kSize.width() - kMargin, below));
  const auto sentence = [](std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return QString::fromStdString(text) + ".";
  };
  double y = below + 12.0;
  const auto add = [&](const std::string& text, const QColor& color, bool bold) {
    const QFont font = font_of(12, bold);
    painter.setFont(font);
    const QRectF room(kMargin, y, width, kSize.height() - y);
    const int flags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
    const QString line = sentence(text);
    const QRectF taken = painter.boundingRect(room, flags, line);
    draw_text(painter, room, flags, line, font, color);
    y += taken.height() + 3.0;
  };
  add(compared_text(f), theme.text, false);
  add(horizon_text(f), theme.text, std::isfinite(f.horizon));
  add(reference_text(f), theme.muted, false);
  add(fmt::format("wall time: median of {} runs, nothing else running in the program", f.repeats), theme.muted,
      false);
}

}  // namespace

bool save_study_picture(const StudyTable& table, const Theme& theme, const QString& path, QString* error) {
  const std::vector<StudyGroup> groups = groups_of(table);
  const auto wall = [](const StudyRow& row) { return row.wall_time; };
  Range walls;
  Range steps;
  for (const StudyRow& row : table.rows) {
    walls.take(wall(row));
    steps.take(step_of(row));
  }
  const Range errors = errors_of(table);
  walls = walls.widened(1.6);
  steps = steps.widened(1.5);

  ErrorPlot against_time(theme, "wall time of the run", time_label);
  ErrorPlot against_step(theme, "step / s", power_label);
  constexpr int kMostTicks = 9;
  for (ErrorPlot* plot : {&against_time, &against_step}) {
    const Range& x = plot == &against_time ? walls : steps;
    plot->set_range(QwtAxis::XBottom, x.low, x.high, kMostTicks);
    plot->set_range(QwtAxis::YLeft, errors.low, errors.high, kMostTicks);
    add_zones(*plot, table.facts, errors, plot == &against_time ? Qt::AlignRight : Qt::AlignLeft);
  }
  // From where the largest errors that a fit can use are, at the coarsest step.
  double top = 0.0;
  for (const StudyGroup& group : groups) {
    if (group.fit.kind != OrderFit::Kind::kOrder) continue;
    for (const StudyRow& row : group.rows) {
      if (row.position_error < table.facts.largest_error()) top = std::max(top, row.position_error);
    }
  }
  const double least = std::max(errors.low, table.facts.rounding_floor());
  if (top > least) add_slopes(against_step, steps, least, top, theme);
  for (const StudyGroup& group : groups) {
    const QColor color = color_of(group.integrator, theme);
    against_time.add_curve(points_of(group, errors, wall), color, group.impacts);
    const QVector<QPointF> points = points_of(group, errors, step_of);
    if (!points.isEmpty()) {
      against_step.add_curve(points, color, group.impacts);
    } else if (error_knob(group.rows.front().method) == ErrorKnob::kNone &&
               !std::isnan(group.rows.front().position_error)) {
      // It has no step: its error stands at every one.
      const double y = shown(group.rows.front().position_error, errors);
      against_step.add_line({{steps.low, y}, {steps.high, y}}, line_of(color, group.impacts));
    }
  }
  const auto paint = [&](QPainter& painter) {
    paint_study(painter, table, groups, against_time, against_step, theme);
  };
  constexpr int kDots = 2;
  return save_picture(path, kSize, paint, error, kDots);
}

}  // namespace carom
