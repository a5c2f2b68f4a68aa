#include "widgets/run/transport_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "widgets/base/plain_text.h"

namespace carom {

Timeline::Timeline(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setMinimumWidth(80);
  setToolTip("The run so far; a tick for each impact");
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

void Timeline::update_from(const Frame& frame, const Recorder& recorder) {
  time_ = frame.time;
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
  const double margin = 4.0;
  const double length = width() - 2.0 * margin;
  const auto x_of = [&](double time) { return margin + length * std::clamp(time / end(), 0.0, 1.0); };
  const auto line = [&](double from, double to, const QColor& color) {
    painter.setPen(QPen(color, 5.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(from, y), QPointF(to, y));
  };
  line(margin, margin + length, theme_.border);
  if (time_ > 0.0) line(margin, x_of(time_), theme_.accent);
  QColor tick = theme_.muted;
  tick.setAlphaF(ticks_.size() > 60 ? 0.35F : 0.9F);
  painter.setPen(QPen(tick, 1.2));
  for (const double t : ticks_) painter.drawLine(QPointF(x_of(t), y - 8.0), QPointF(x_of(t), y + 8.0));
}

const std::vector<double>& TransportBar::speeds() {
  static const std::vector<double> all = {1.0 / 64, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0, 2.0, 4.0, 16.0};
  return all;
}

QString TransportBar::speed_text(double speed) {
  if (speed == 0.25) return QStringLiteral("×¼");
  if (speed == 0.5) return QStringLiteral("×½");
  if (speed < 1.0) return QStringLiteral("×1/%1").arg(std::lround(1.0 / speed));
  return QStringLiteral("×%1").arg(speed);
}

TransportBar::TransportBar(const Theme& theme, QWidget* parent) : QFrame(parent), theme_(theme) {
  setObjectName("panel");
  const auto button = [&](const QString& tip) {
    auto* b = new QToolButton(this);
    b->setIconSize({18, 18});
    b->setToolTip(tip);
    b->setFocusPolicy(Qt::TabFocus);
    return b;
  };
  restart_ = button(tr("Restart at t = 0 (R)"));
  play_ = button(tr("Play or pause (Space)"));
  play_->setFixedSize(36, 36);
  step_ = button(tr("One step (.)"));
  speed_ = button(tr("Speed: simulated seconds per second"));
  speed_->setObjectName("choice");
  speed_->setPopupMode(QToolButton::InstantPopup);
  speed_->setText(speed_text(1.0));
  auto* menu = new QMenu(speed_);
  for (const double speed : speeds()) {
    menu->addAction(speed_text(speed), this, [this, speed] {
      speed_->setText(speed_text(speed));
      emit speedChosen(speed);
    });
  }
  speed_->setMenu(menu);
  timeline_ = new Timeline(theme, this);
  end_ = new PlainLabel(this);
  end_->setObjectName("muted");

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 5, 12, 5);
  row->setSpacing(6);
  row->addWidget(restart_);
  row->addWidget(play_);
  row->addWidget(step_);
  row->addSpacing(6);
  row->addWidget(timeline_, 1);
  row->addWidget(end_);
  row->addSpacing(4);
  row->addWidget(speed_);
  connect(restart_, &QToolButton::clicked, this, &TransportBar::restartClicked);
  connect(step_, &QToolButton::clicked, this, &TransportBar::stepClicked);
  connect(play_, &QToolButton::clicked, this, [this] { emit playClicked(!playing_); });
  set_icons();
}

void TransportBar::set_icons() {
  restart_->setIcon(themed_icon("restart", theme_.text));
  step_->setIcon(themed_icon("step", theme_.text));
  play_->setIcon(themed_icon(playing_ ? "pause" : "play", theme_.panel));
  play_->setStyleSheet(
      QString("QToolButton { background: %1; border-radius: 18px; } QToolButton:hover { background: %2; }")
          .arg(theme_.accent.name(), theme_.accent.lighter(112).name()));
}

void TransportBar::set_theme(const Theme& theme) {
  theme_ = theme;
  timeline_->set_theme(theme);
  set_icons();
}

void TransportBar::set_duration(double seconds) {
  timeline_->set_duration(seconds);
  end_->setText(QString("%1 s").arg(timeline_->end(), 0, 'g', 4));
}

void TransportBar::update_from(const Frame& frame, const Recorder& recorder) {
  timeline_->update_from(frame, recorder);
  end_->setText(QString("%1 s").arg(timeline_->end(), 0, 'g', 4));
  if (playing_ == frame.playing) return;
  playing_ = frame.playing;
  set_icons();
}

}  // namespace carom
