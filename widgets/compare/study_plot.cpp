#include "widgets/compare/study_plot.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/study/study_table.h"
#include "widgets/base/method_look.h"
#include "widgets/base/method_names.h"
#include "widgets/compare/error_plot.h"
#include "widgets/plot/plot_render.h"
#include "widgets/print/picture_file.h"
#include "widgets/print/save_file.h"

namespace carom {
namespace {

// px of the picture
constexpr QSize kSize(1440, 800);
constexpr int kMargin = 32;
constexpr int kTop = 92;  // of the plots
constexpr int kPlotWidth = 505;
constexpr int kPlotHeight = 540;
constexpr int kGap = 24;
constexpr double kSampleWidth = 34.0;
constexpr int kMarker = 8;

// Of kStudyErrors.
constexpr std::size_t kPosition = 0;
constexpr std::size_t kAngle = 2;

// Positions, unless all are exact and angles are not.
std::size_t shown_error(const std::vector<StudyGroup>& groups) {
  const bool exact = std::all_of(groups.begin(), groups.end(),
                                 [](const StudyGroup& g) { return g.fit.kind == OrderFit::Kind::kExact; });
  const bool turns =
      std::any_of(groups.begin(), groups.end(), [](const StudyGroup& g) { return g.is_of_angle(); });
  return exact && turns ? kAngle : kPosition;
}

QFont font_of(int pixels, bool bold = false) {
  QFont font;
  font.setPixelSize(pixels);
  font.setBold(bold);
  return font;
}

void draw_text(QPainter& painter, const QRectF& where, int flags, const QString& text, const QFont& font,
               const QColor& color) {
  painter.setFont(font);
  painter.setPen(color);
  painter.drawText(where, flags, text);
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
              kImpacts[i].id == ImpactsId::kLocated ? "at own time" : "at step's end", font_of(11),
              theme.muted);
    draw_sample(painter, {cell.center().x(), cell.top() + 27.0}, theme.text, kImpacts[i].id, theme,
                kSampleWidth, kMarker);
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
              Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, text_of(integrator.label), font_of(12),
              theme.text);
    for (std::size_t i = 0; i < kImpacts.size(); ++i) {
      const auto g = std::find_if(groups.begin(), groups.end(), [&](const StudyGroup& one) {
        return one.integrator == integrator.id && one.impacts == kImpacts[i].id;
      });
      if (g == groups.end()) continue;
      const QRectF cell(first + kColumn * static_cast<double>(i), y, kColumn, kRow);
      const OrderFit& fit = g->verdict();
      const bool number = fit.kind == OrderFit::Kind::kOrder;
      const QString order = number ? QString::number(fit.order, 'f', 2) : QString::fromStdString(text_of(fit));
      if (!number) {
        draw_text(painter, cell, Qt::AlignCenter, order, font_of(12, fit.kind == OrderFit::Kind::kExact),
                  fit.kind == OrderFit::Kind::kExact ? color.darker(115) : theme.muted);
        continue;
      }
      draw_text(painter, cell.adjusted(0, 6, 0, -20), Qt::AlignCenter, order, font_of(15, true),
                color.darker(115));
      const QString below =
          error_parameter(g->rows.front().method) == ErrorParameter::kTolerance ? QString("of tolerance")
          : g->is_of_angle() ? QString::fromUtf8("± %1 in angle").arg(QString::number(fit.uncertainty, 'f', 2))
                             : QString::fromUtf8("± %1").arg(QString::number(fit.uncertainty, 'f', 2));
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
  const std::size_t error = shown_error(groups);
  const StudyFacts& f = table.facts;
  const double width = kSize.width() - 2.0 * kMargin;
  draw_text(painter, {kMargin, 20, width, 30}, Qt::AlignLeft | Qt::AlignVCenter,
            QString::fromStdString(f.title) + QString::fromUtf8(": speed against error"), font_of(21, true),
            theme.text);
  draw_text(painter, {kMargin, 52, width, 20}, Qt::AlignLeft | Qt::AlignVCenter,
            QString::fromUtf8("Error in %2 / m at t = %1 s: the largest over the moving bodies' %3")
                .arg(QString::number(f.time, 'g', 5),
                     error == kAngle ? QString::fromUtf8("angle × reach") : QString("position"),
                     error == kAngle ? QString("outlines") : QString("centres")),
            font_of(13), theme.muted);
  const QRectF left(kMargin, kTop, kPlotWidth, kPlotHeight);
  const QRectF right = left.translated(kPlotWidth + kGap, 0);
  render_plot(against_time, painter, left);
  render_plot(against_step, painter, right);
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
  add(fmt::format("wall time: median of {} runs, one run after another", f.repeats), theme.muted, false);
}

}  // namespace

void write_study_picture(OutputFile& file, const StudyTable& table, const Theme& theme) {
  const std::vector<StudyGroup> groups = groups_of(table);
  ErrorPlot against_time(theme, ErrorPlot::Place::kPicture);
  ErrorPlot against_step(theme, ErrorPlot::Place::kPicture);
  const std::size_t error = shown_error(groups);
  against_time.show_study(table.facts, groups, ErrorAgainst::kWallTime, error);
  against_step.show_study(table.facts, groups, ErrorAgainst::kStep, error);
  const auto paint = [&](QPainter& painter) {
    paint_study(painter, table, groups, against_time, against_step, theme);
  };
  constexpr int kDots = 2;
  write_picture(file, kSize, paint, kDots);
}

bool save_study_picture(const StudyTable& table, const Theme& theme, const QString& path, QString* error) {
  return save_file(
      path, [&](OutputFile& file) { write_study_picture(file, table, theme); }, error);
}

}  // namespace carom
