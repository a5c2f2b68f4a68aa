#include "widgets/plot/plot_labels.h"

#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>
#include <qwt_plot.h>

#include "widgets/base/plain_text.h"

namespace carom {
namespace {

constexpr int kInsets = 12;  // px, above and below lines, of their label and the canvas
constexpr int kAside = 40;   // px, likewise left and right

}  // namespace

PlotLabels::PlotLabels(QwtPlot* plot)
    : QObject(plot),
      plot_(plot),
      row_(new QHBoxLayout(plot->canvas())),
      values_(new PlainLabel(plot->canvas())),
      zoomed_(new PlainLabel(tr("zoomed · double-click to reset"), plot->canvas())) {
  row_->setContentsMargins(4, 2, 4, 2);
  for (QLabel* label : {values_, zoomed_}) {
    label->setObjectName("chip");
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    label->hide();
  }
  row_->addWidget(values_, 0, Qt::AlignTop);
  row_->addStretch(1);
  row_->addWidget(zoomed_, 0, Qt::AlignTop);
}

void PlotLabels::set_color(const QColor& color) {
  for (QLabel* label : {values_, zoomed_}) label->setStyleSheet("color: " + color.name());
}

void PlotLabels::set_zoomed(bool zoomed) { zoomed_->setVisible(zoomed); }

void PlotLabels::hide_values() { values_->hide(); }

void PlotLabels::show_values(const QString& text) {
  row_->setDirection(QBoxLayout::LeftToRight);
  values_->setText(text);
  values_->show();
}

void PlotLabels::show_values(const QString& head, const QStringList& values, const QString& unit, double x) {
  const QString in_one = values.isEmpty() ? head : head + ":  " + values.join(",  ") + unit;
  const QFontMetrics metrics = values_->fontMetrics();
  const QWidget* canvas = plot_->canvas();
  const int room = canvas->width() - (zoomed_->isVisible() ? zoomed_->width() : 0) - kAside;
  if (metrics.horizontalAdvance(in_one) <= room) return show_values(in_one);
  QStringList lines{head};
  for (const QString& value : values) lines << value + unit;
  if (lines.size() * metrics.lineSpacing() > canvas->height() - kInsets)
    return show_values(metrics.elidedText(in_one, Qt::ElideRight, room));
  for (QString& line : lines) line = metrics.elidedText(line, Qt::ElideRight, room);
  show_values(lines.join('\n'));
  if (x < 0.5 * canvas->width()) row_->setDirection(QBoxLayout::RightToLeft);
}

}  // namespace carom
