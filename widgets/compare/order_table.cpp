#include "widgets/compare/order_table.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "physics/dynamics/integrators/integrators.h"
#include "widgets/base/method_look.h"
#include "widgets/base/method_names.h"
#include "widgets/base/number_text.h"
#include "widgets/base/plain_text.h"

namespace carom {
namespace {

// px
constexpr double kLowestRow = 13.0;
constexpr double kHighestRow = 26.0;
constexpr double kWideColumn = 84.0;  // wide enough for the uncertainty
constexpr double kNarrowColumn = 38.0;
constexpr double kLeastName = 96.0;
constexpr double kSampleWidth = 26.0;
constexpr int kMarker = 6;

bool is_order(const StudyGroup& group) { return group.verdict().kind == OrderFit::Kind::kOrder; }
bool by_tolerance(const StudyGroup& group) {
  return error_parameter(group.rows.front().method) == ErrorParameter::kTolerance;
}

QString order_tip(const StudyGroup& group) {
  const QString method = QString("%1, %2").arg(text_of(choice_of(kIntegrators, group.integrator).label),
                                               text_of(choice_of(kImpacts, group.impacts).label));
  const OrderFit& fit = group.verdict();
  switch (fit.kind) {
    case OrderFit::Kind::kExact:
      return method + OrderTable::tr(
                          "\nexact here: every error in position and angle is rounding, so there is no order");
    case OrderFit::Kind::kNone:
      return method +
             OrderTable::tr(
                 "\nno order: fewer than three errors lie above rounding and below a tenth of the scene");
    case OrderFit::Kind::kOrder:
      break;
  }
  return method +
         (group.is_of_angle()
              ? OrderTable::tr("\npositions are exact; order %1 in angle, fitted on %2 %3 from %4 to %5 %6")
              : OrderTable::tr("\norder %1 in position, fitted on %2 %3 from %4 to %5 %6"))
             .arg(QString::fromStdString(text_of(fit)))
             .arg(fit.points)
             .arg(by_tolerance(group) ? OrderTable::tr("tolerances") : OrderTable::tr("steps"),
                  short_figure(fit.from), short_figure(fit.to), by_tolerance(group) ? "m" : "s");
}

}  // namespace

OrderTable::OrderTable(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  setAccessibleName(tr("Fitted orders of the error in position"));
}

void OrderTable::set_theme(const Theme& theme) {
  theme_ = theme;
  update();
}

void OrderTable::set_groups(std::vector<StudyGroup> groups) {
  groups_ = std::move(groups);
  rows_.clear();
  for (const IntegratorChoice& integrator : kIntegrators) {
    Row row{integrator.id, {}};
    for (const StudyGroup& group : groups_) {
      if (group.integrator != integrator.id) continue;
      for (std::size_t i = 0; i < kImpacts.size(); ++i) {
        if (group.impacts == kImpacts[i].id) row.groups[i] = &group;
      }
    }
    if (row.groups[0] != nullptr || row.groups[1] != nullptr) rows_.push_back(row);
  }
  update();
}

double OrderTable::row_height() const {
  const double lines = static_cast<double>(std::max<std::size_t>(rows_.size(), 6)) + 1.0;
  return std::clamp(std::floor(height() / lines), kLowestRow, kHighestRow);
}

double OrderTable::column_width() const {
  return width() >= kLeastName + 2.0 * kWideColumn ? kWideColumn : kNarrowColumn;
}

double OrderTable::first_column() const { return width() - column_width() * kImpacts.size(); }

void OrderTable::paintEvent(QPaintEvent*) {
  if (rows_.empty()) return;
  QPainter painter(this);
  QFont font = painter.font();
  font.setPixelSize(11);
  painter.setFont(font);
  painter.setPen(theme_.muted);
  const double high = row_height();
  painter.drawText(QRectF(0.0, 0.0, first_column(), high), Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(tr("Order in position"), Qt::ElideRight,
                                                    static_cast<int>(first_column()) - 4));
  for (std::size_t i = 0; i < kImpacts.size(); ++i) {
    const double middle = first_column() + (static_cast<double>(i) + 0.5) * column_width();
    draw_sample(painter, {middle, 0.5 * high}, theme_.text, kImpacts[i].id, theme_, kSampleWidth, kMarker);
  }
  double y = high;
  for (const Row& row : rows_) {
    draw_row(painter, QRectF(0.0, y, width(), high), row);
    y += high;
  }
}

void OrderTable::draw_row(QPainter& painter, const QRectF& where, const Row& row) const {
  const QColor color = color_of(row.integrator, theme_);
  painter.setPen(QPen(theme_.border, 1.0));
  painter.drawLine(QPointF(where.left(), where.top() + 0.5), QPointF(where.right(), where.top() + 0.5));
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawRect(QRectF(where.left(), where.top() + 3.0, 4.0, where.height() - 5.0));
  painter.setPen(theme_.text);
  const QRectF name(where.left() + 9.0, where.top(), first_column() - 13.0, where.height());
  QString label = text_of(choice_of(kIntegrators, row.integrator).label);
  if (column_width() < kWideColumn) label.replace("Dormand-Prince", "DP");
  painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(label, Qt::ElideRight, static_cast<int>(name.width())));
  for (std::size_t i = 0; i < row.groups.size(); ++i) {
    const StudyGroup* group = row.groups[i];
    if (group == nullptr) continue;
    const QRectF cell(first_column() + static_cast<double>(i) * column_width(), where.top(), column_width(),
                      where.height());
    const OrderFit& fit = group->verdict();
    QString text = fit.kind == OrderFit::Kind::kExact ? tr("exact") : QString("–");
    if (is_order(*group)) {
      text = column_width() < kWideColumn || by_tolerance(*group) ? QString::number(fit.order, 'f', 2)
                                                                  : QString::fromStdString(text_of(fit));
    }
    text.replace('-', kMinus);
    if (group->is_of_angle()) text += QString::fromUtf8(" ∠");
    painter.setPen(fit.kind == OrderFit::Kind::kNone ? theme_.muted : theme_.text);
    painter.drawText(cell, Qt::AlignCenter, text);
  }
}

bool OrderTable::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const auto line = static_cast<std::ptrdiff_t>(std::floor(help->pos().y() / row_height())) - 1;
  QStringList tips;
  if (line >= 0 && line < std::ssize(rows_)) {
    for (const StudyGroup* group : rows_[static_cast<std::size_t>(line)].groups) {
      if (group != nullptr) tips << order_tip(*group);
    }
  } else if (line == -1) {
    tips << tr(
        "The order of the error in position: halving the step leaves 1/2ᵖ of it. With ∠: positions are exact, "
        "and\n"
        "it is the order of the error in angle.\n"
        "Left, dashed with squares: impacts at the step's end.\n"
        "Right, solid with discs: impacts at their own time.");
  }
  QToolTip::showText(help->globalPos(), plain_tip(tips.join("\n")), this);
  return true;
}

}  // namespace carom
