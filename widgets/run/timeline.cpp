#include "widgets/run/timeline.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/edit/quantity.h"

namespace carom {
namespace {

constexpr double kMargin = 6.0;      // px, at both ends of the line
constexpr double kTickWidth = 9.0;   // px, to the mouse
constexpr double kFiner = 10.0;      // with Shift
constexpr int kNotch = 120;          // eighths of a degree
constexpr double kSameTime = 1e-12;  // of the line's end

}  // namespace

Timeline::Timeline(const Theme& theme, QWidget* parent)
    : QWidget(parent), theme_(theme), field_(new QLineEdit(this)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setMinimumWidth(80);
  setAccessibleName(tr("Timeline"));
  setToolTip(
      tr("The run so far; a tick for each impact.\n"
         "Click or drag: to a moment; with Shift ten times finer.\n"
         "Wheel: a step; with Ctrl an impact. Double click: type a time."));
  field_->setAccessibleName(tr("Time in s"));
  field_->installEventFilter(this);
  field_->hide();
  connect(field_, &QLineEdit::returnPressed, this, &Timeline::take_field);
  connect(field_, &QLineEdit::editingFinished, field_, &QWidget::hide);
}

void Timeline::set_theme(const Theme& theme) {
  theme_ = theme;
  update();
}

void Timeline::set_duration(double seconds) {
  duration_ = seconds;
  update();
}

double Timeline::end() const { return duration_ * std::max(1.0, std::ceil(time_ / duration_ - 1e-9)); }

double Timeline::x_of(double time) const {
  return kMargin + (width() - 2.0 * kMargin) * std::clamp(time / end(), 0.0, 1.0);
}

double Timeline::time_at(double x) const { return end() * (x - kMargin) / (width() - 2.0 * kMargin); }

void Timeline::update_from(const Frame& newest, const Recorder& recorder, double shown) {
  time_ = newest.time;
  shown_ = shown;
  ticks_.clear();
  const double least = end() / std::max(1, width() / 2);
  std::vector<SeriesPoint<1>> impacts;
  recorder.impulses().read(0.0, time_, impacts);
  for (const SeriesPoint<1>& impact : impacts) {
    if (ticks_.empty() || impact.at - ticks_.back() >= least) ticks_.push_back(impact.at);
  }
  update();
}

void Timeline::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double y = 0.5 * height();
  const auto line = [&](double from, double to, const QColor& color) {
    painter.setPen(QPen(color, 5.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(from, y), QPointF(to, y));
  };
  line(kMargin, width() - kMargin, theme_.border);
  // What lies after the playhead is pale.
  QColor rest = theme_.accent;
  rest.setAlphaF(0.4F);
  if (shown_ < time_) line(kMargin, x_of(time_), rest);
  if (time_ > 0.0 && shown_ > 0.0) line(kMargin, x_of(std::min(shown_, time_)), theme_.accent);
  QColor tick = theme_.muted;
  tick.setAlphaF(ticks_.size() > 60 ? 0.35F : 0.9F);
  painter.setPen(QPen(tick, 1.2));
  for (const double t : ticks_) painter.drawLine(QPointF(x_of(t), y - 8.0), QPointF(x_of(t), y + 8.0));
  painter.setPen(QPen(theme_.panel, 1.5));
  painter.setBrush(theme_.accent);
  painter.drawEllipse(QPointF(x_of(shown_), y), 5.5, 5.5);
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const double x = event->position().x();
  emit scrubBegan();
  const auto near = std::find_if(ticks_.begin(), ticks_.end(),
                                 [&](double tick) { return std::abs(x_of(tick) - x) <= 0.5 * kTickWidth; });
  const bool on_head = std::abs(x_of(shown_) - x) <= 0.5 * kTickWidth;
  scrub_ = {x, on_head ? shown_ : time_at(x)};
  if (on_head) return;
  if (near == ticks_.end()) {
    emit scrubbed(std::clamp(scrub_->time, 0.0, time_));
  } else {
    const auto closest = std::min_element(ticks_.begin(), ticks_.end(), [&](double a, double b) {
      return std::abs(x_of(a) - x) < std::abs(x_of(b) - x);
    });
    scrub_->time = *closest;
    emit impactChosen(*closest);
  }
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  if (!scrub_) return;
  const double x = event->position().x();
  const double share = event->modifiers().testFlag(Qt::ShiftModifier) ? 1.0 / kFiner : 1.0;
  const double by = share * (x - std::exchange(scrub_->x, x)) * end() / (width() - 2.0 * kMargin);
  if (std::abs(by) <= kSameTime * end()) return;
  scrub_->time += by;
  emit scrubbed(std::clamp(scrub_->time, 0.0, time_));
}

void Timeline::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !std::exchange(scrub_, std::nullopt)) return;
  emit scrubEnded();
}

void Timeline::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) open_field();
}

void Timeline::wheelEvent(QWheelEvent* event) {
  wheel_ += event->angleDelta().y();
  const int notches = wheel_ / kNotch;
  wheel_ -= notches * kNotch;
  event->accept();
  if (notches == 0) return;
  if (event->modifiers().testFlag(Qt::ControlModifier)) {
    emit impactAsked(notches > 0);
  } else {
    emit stepAsked(notches);
  }
}

void Timeline::open_field() {
  constexpr int kWidth = 92;  // px
  const int left = std::clamp(qRound(x_of(shown_)) - kWidth / 2, 0, std::max(0, width() - kWidth));
  field_->setGeometry(left, 0, kWidth, height());
  field_->setText(QString("%1 s").arg(shown_, 0, 'g', 6));
  field_->selectAll();
  field_->show();
  field_->setFocus();
}

void Timeline::take_field() {
  const TypedQuantity typed = typed_quantity(field_->text(), "s");
  if (!typed.change) return;
  field_->hide();
  emit scrubbed(std::clamp(typed.change->of(shown_), 0.0, time_));
}

bool Timeline::eventFilter(QObject* watched, QEvent* event) {
  if (watched == field_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    field_->hide();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace carom
