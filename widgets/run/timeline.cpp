#include "widgets/run/timeline.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStyle>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/base/plain_text.h"
#include "widgets/edit/quantity.h"

namespace carom {
namespace {

constexpr double kMargin = 6.0;      // px, at both ends of the line
constexpr double kTickWidth = 9.0;   // px, to the mouse
constexpr double kFiner = 10.0;      // with Shift
constexpr double kDragFrom = 4.0;    // px
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
         "Wheel: a step; with Ctrl an impact. Double click: type a time; on a tick: open the impact.\n"
         "A flag for each stop: a click opens it, a drag moves one at a time.\n"
         "A and B: the marks, as in the plots; Ctrl+M and Ctrl+Shift+M set them at the shown moment."));
  field_->setAccessibleName(tr("Time in s"));
  field_->installEventFilter(this);
  field_->hide();
  connect(field_, &QLineEdit::returnPressed, this, &Timeline::take_field);
  connect(field_, &QLineEdit::textEdited, this, [this] { say_fault({}); });
}

void Timeline::set_theme(const Theme& theme) {
  theme_ = theme;
  update();
}

void Timeline::set_duration(double seconds) {
  duration_ = seconds;
  update();
}

void Timeline::set_start(double time) {
  start_ = time;
  update();
}

void Timeline::set_stops(const std::vector<Stop>& stops) {
  flags_.set_stops(stops);
  held_.reset();
  if (chosen_ && *chosen_ >= stops.size()) chosen_.reset();
  update();
}

void Timeline::set_marks(std::optional<double> a, std::optional<double> b) {
  if (std::exchange(marks_, {a, b}) != std::array{a, b}) update();
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
  if (!held_) flags_.update_from(recorder, 2.0 * least);
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
  if (shown_ < time_) line(x_of(start_), x_of(time_), rest);
  if (time_ > start_ && shown_ > start_) line(x_of(start_), x_of(std::min(shown_, time_)), theme_.accent);
  QColor tick = theme_.muted;
  tick.setAlphaF(ticks_.size() > 60 ? 0.35F : 0.9F);
  painter.setPen(QPen(tick, 1.2));
  for (const double t : ticks_) painter.drawLine(QPointF(x_of(t), y - 8.0), QPointF(x_of(t), y + 8.0));
  flags_.paint(
      painter, theme_, y, [this](double t) { return x_of(t); }, chosen_);
  paint_marks(painter, y);
  painter.setPen(QPen(theme_.panel, 1.5));
  painter.setBrush(theme_.accent);
  painter.drawEllipse(QPointF(x_of(shown_), y), 5.5, 5.5);
}

// Those beyond the line are left out.
void Timeline::paint_marks(QPainter& painter, double middle) const {
  constexpr double kLetter = 10.0;  // px, the square of one
  QFont font = painter.font();
  font.setPixelSize(static_cast<int>(kLetter));
  font.setBold(true);
  painter.setFont(font);
  painter.setPen(QPen(theme_.accent, 1.2));
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    if (!marks_[i] || *marks_[i] > end()) continue;
    const double x = x_of(*marks_[i]);
    painter.drawLine(QPointF(x, middle - 6.0), QPointF(x, height()));
    // Outside the interval, where there is room.
    const bool at_left = i == 0 ? x - kLetter > 1.0 : x + kLetter + 2.0 > width();
    const double left = at_left ? x - kLetter - 1.0 : x + 2.0;
    painter.drawText(QRectF(left, height() - kLetter, kLetter, kLetter), Qt::AlignCenter, i == 0 ? "A" : "B");
  }
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const double x = event->position().x();
  if (const auto flag = flag_at(event->position())) {
    held_ = HeldFlag{*flag, x};
    chosen_ = flag->stop;
    setFocus(Qt::MouseFocusReason);
    return update();
  }
  emit scrubBegan();
  const bool on_head = std::abs(x_of(shown_) - x) <= 0.5 * kTickWidth;
  scrub_ = {x, on_head ? shown_ : time_at(x)};
  if (on_head) return;
  if (const std::optional<double> tick = tick_at(x)) {
    scrub_->time = *tick;
    emit impactChosen(*tick);
  } else {
    emit scrubbed(std::clamp(scrub_->time, start_, time_));
  }
}

// The closest one within the mouse's reach.
std::optional<double> Timeline::tick_at(double x) const {
  const auto away = [&](double tick) { return std::abs(x_of(tick) - x); };
  const auto closest =
      std::min_element(ticks_.begin(), ticks_.end(), [&](double a, double b) { return away(a) < away(b); });
  return closest != ticks_.end() && away(*closest) <= 0.5 * kTickWidth ? std::optional(*closest) : std::nullopt;
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  if (held_) return drag_flag(event->position().x(), event->modifiers().testFlag(Qt::ShiftModifier));
  if (!scrub_) return;
  const double x = event->position().x();
  const double share = event->modifiers().testFlag(Qt::ShiftModifier) ? 1.0 / kFiner : 1.0;
  const double by = share * (x - std::exchange(scrub_->x, x)) * end() / (width() - 2.0 * kMargin);
  if (std::abs(by) <= kSameTime * end()) return;
  scrub_->time += by;
  emit scrubbed(std::clamp(scrub_->time, start_, time_));
}

void Timeline::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && held_) return drop_flag();
  if (event->button() != Qt::LeftButton || !std::exchange(scrub_, std::nullopt)) return;
  emit scrubEnded();
}

void Timeline::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || flag_at(event->position())) return;
  if (const std::optional<double> tick = tick_at(event->position().x())) return emit impactOpened(*tick);
  open_field();
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

std::optional<TimelineFlag> Timeline::flag_at(const QPointF& at) const {
  return flags_.at(at.x(), at.y(), 0.5 * height(), [this](double time) { return x_of(time); });
}

void Timeline::drag_flag(double x, bool finer) {
  if (!held_->flag.moves || (!held_->moved && std::abs(x - held_->x) < kDragFrom)) return;
  held_->moved = true;
  const double pixel = (finer ? 1.0 / kFiner : 1.0) * end() / (width() - 2.0 * kMargin);
  const double time = std::max(0.0, round_to_pixel(held_->flag.time + pixel * (x - held_->x), pixel));
  flags_.drag_to(held_->flag.stop, time);
  held_->to = time;
  QToolTip::showText(mapToGlobal(QPoint(qRound(x), 0)), tr("at %1 s").arg(time), this);
  update();
}

void Timeline::drop_flag() {
  const HeldFlag held = *std::exchange(held_, std::nullopt);
  QToolTip::hideText();
  if (!held.moved) return emit flagClicked(held.flag.stop);
  if (held.to != held.flag.time) emit flagMoved(held.flag.stop, held.to);
}

void Timeline::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && held_) {
    flags_.drag_to(held_->flag.stop, held_->flag.time);
    held_.reset();
    QToolTip::hideText();
    return update();
  }
  if (event->key() == Qt::Key_Delete && chosen_) return emit flagRemoved(*std::exchange(chosen_, std::nullopt));
  QWidget::keyPressEvent(event);
}

bool Timeline::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const auto flag = flag_at(help->pos());
  QToolTip::showText(help->globalPos(), flag ? plain_tip(flags_.sentence(flag->stop)) : toolTip(), this);
  return true;
}

void Timeline::open_field() {
  constexpr int kWidth = 92;  // px
  const int left = std::clamp(qRound(x_of(shown_)) - kWidth / 2, 0, std::max(0, width() - kWidth));
  field_->setGeometry(left, 0, kWidth, height());
  field_->setText(QString("%1 s").arg(shown_, 0, 'g', 6));
  say_fault({});
  field_->selectAll();
  field_->show();
  field_->setFocus();
}

void Timeline::take_field() {
  const TypedQuantity typed = typed_quantity(field_->text(), "s");
  if (!typed.change) return say_fault(typed.fault);
  constexpr double kShownDigits = 1e-5;  // share of a time that its six digits leave out
  const double time = typed.change->of(shown_);
  const double rounding = kShownDigits * std::abs(time);
  if (time < start_ - rounding || time > time_ + rounding)
    return say_fault(tr("The record goes from %1 to %2 s.").arg(start_, 0, 'g', 6).arg(time_, 0, 'g', 6));
  field_->hide();
  emit timeTyped(std::clamp(time, start_, time_));
}

void Timeline::say_fault(const QString& sentence) {
  field_->setToolTip(plain_tip(sentence));
  field_->setProperty("fault", !sentence.isEmpty());
  field_->style()->unpolish(field_);
  field_->style()->polish(field_);
  if (sentence.isEmpty()) return QToolTip::hideText();
  QToolTip::showText(field_->mapToGlobal(QPoint(0, field_->height())), plain_tip(sentence), field_);
}

bool Timeline::eventFilter(QObject* watched, QEvent* event) {
  if (watched == field_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    field_->hide();
    return true;
  }
  // A click elsewhere leaves it; the shown time holds.
  if (watched == field_ && event->type() == QEvent::FocusOut &&
      static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason) {
    field_->hide();
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace carom
