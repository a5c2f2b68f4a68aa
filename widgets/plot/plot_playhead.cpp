#include "widgets/plot/plot_playhead.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPen>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <qwt_axis.h>
#include <qwt_plot.h>
#include <qwt_plot_item.h>
#include <qwt_scale_map.h>
#include <utility>

namespace carom {
namespace {

constexpr double kHeadHalf = 5.0;   // px, half the head's width
constexpr double kHeadHigh = 9.0;   // px
constexpr double kReach = 7.0;      // px, to both sides of the head's middle
constexpr double kFiner = 10.0;     // with Shift
constexpr double kOverCurves = 50;  // z

}  // namespace

class PlotPlayhead::Line : public QwtPlotItem {
 public:
  Line() { setZ(kOverCurves); }

  void set(double time) { time_ = time; }
  void set_color(const QColor& color) { color_ = color; }

  void draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap& /*y_map*/,
            const QRectF& canvas) const override {
    const double x = x_map.transform(time_);
    if (x < canvas.left() - kHeadHalf || x > canvas.right() + kHeadHalf) return;
    const double top = canvas.top();
    QPen pen(color_, 1.2, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({3.0, 2.5});
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(pen);
    painter->drawLine(QPointF(x, top), QPointF(x, canvas.bottom()));
    painter->setPen(Qt::NoPen);
    painter->setBrush(color_);
    const QPointF head[] = {{x - kHeadHalf, top},
                            {x + kHeadHalf, top},
                            {x + kHeadHalf, top + 0.5 * kHeadHigh},
                            {x, top + kHeadHigh},
                            {x - kHeadHalf, top + 0.5 * kHeadHigh}};
    painter->drawConvexPolygon(head, 5);
  }

 private:
  double time_ = 0.0;  // s
  QColor color_;
};

PlotPlayhead::PlotPlayhead(QwtPlot* plot) : QObject(plot), plot_(plot), line_(new Line) {
  line_->setVisible(false);
  line_->attach(plot);
  plot->canvas()->installEventFilter(this);
}

PlotPlayhead::~PlotPlayhead() = default;

void PlotPlayhead::set_color(const QColor& color) { line_->set_color(color); }

void PlotPlayhead::set_time(std::optional<double> time) {
  time_ = time;
  line_->setVisible(time.has_value());
  if (time) line_->set(*time);
}

std::optional<QPointF> PlotPlayhead::head() const {
  if (!time_) return std::nullopt;
  return QPointF(plot_->transform(QwtAxis::XBottom, *time_), 0.5 * kHeadHigh);
}

bool PlotPlayhead::on_head(const QMouseEvent& mouse) const {
  const std::optional<QPointF> at = head();
  return at && std::abs(mouse.position().x() - at->x()) <= kReach && mouse.position().y() <= kHeadHigh + kReach;
}

bool PlotPlayhead::press(const QMouseEvent& mouse) {
  if (mouse.button() != Qt::LeftButton || !on_head(mouse)) return false;
  scrub_ = Scrub{mouse.position().x(), *time_};
  emit scrubBegan();
  return true;
}

bool PlotPlayhead::move(const QMouseEvent& mouse) {
  if (!scrub_) {
    if (mouse.buttons() != Qt::NoButton || !on_head(mouse)) return false;
    plot_->canvas()->setCursor(Qt::SizeHorCursor);
    return true;
  }
  const double x = mouse.position().x();
  const double from = std::exchange(scrub_->x, x);
  const double by = plot_->invTransform(QwtAxis::XBottom, x) - plot_->invTransform(QwtAxis::XBottom, from);
  scrub_->time += mouse.modifiers().testFlag(Qt::ShiftModifier) ? by / kFiner : by;
  if (by != 0.0) emit scrubbed(std::max(0.0, scrub_->time));
  return true;
}

bool PlotPlayhead::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return move(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonDblClick:
      return on_head(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      if (static_cast<QMouseEvent*>(event)->button() != Qt::LeftButton || !scrub_) return false;
      scrub_.reset();
      emit scrubEnded();
      return true;
    default:
      return QObject::eventFilter(watched, event);
  }
}

}  // namespace carom
