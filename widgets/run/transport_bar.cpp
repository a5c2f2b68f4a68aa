#include "widgets/run/transport_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "widgets/base/plain_text.h"

namespace carom {

const std::vector<double>& TransportBar::speeds() {
  static const std::vector<double> all = {1.0 / 1000, 1.0 / 256, 1.0 / 64, 1.0 / 16, 1.0 / 8, 1.0 / 4,
                                          1.0 / 2,    1.0,       2.0,      4.0,      8.0,     20.0};
  return all;
}

QString TransportBar::speed_text(double speed) {
  if (speed < 1.0) return QStringLiteral("×1/%1").arg(std::lround(1.0 / speed));
  return QStringLiteral("×%1").arg(speed);
}

TransportBar::TransportBar(const Theme& theme, QWidget* parent) : QFrame(parent), theme_(theme) {
  setObjectName("panel");
  const auto button = [&](const QString& name, const QString& tip) {
    auto* b = new QToolButton(this);
    b->setIconSize({18, 18});
    b->setAccessibleName(name);
    b->setToolTip(tip);
    b->setFocusPolicy(Qt::TabFocus);
    return b;
  };
  restart_ = button(tr("Restart"), tr("Restart at the newest start (R)"));
  starts_ = button(tr("Starts"), tr("All starts since the file was opened"));
  starts_->setObjectName("more");
  starts_->setText(QStringLiteral("▾"));
  starts_->setPopupMode(QToolButton::InstantPopup);
  play_ = button({}, tr("Play or pause (Space)"));
  play_->setFixedSize(36, 36);
  back_ = button(tr("Step back"), tr("Back by a step (,)"));
  step_ = button(tr("Step"), tr("One step (.)"));
  flag_ = button(tr("Stops"), tr("Stops: where the run is to halt (H)"));
  speed_ = button({}, tr("Speed: simulated seconds per second (Ctrl+, and Ctrl+.)"));
  speed_->setObjectName("choice");
  speed_->setPopupMode(QToolButton::InstantPopup);
  show_speed(1.0);
  auto* menu = new QMenu(speed_);
  for (const double speed : speeds()) {
    menu->addAction(speed_text(speed), this, [this, speed] { choose_speed(speed); });
  }
  speed_->setMenu(menu);
  timeline_ = new Timeline(theme, this);
  end_ = new PlainLabel(this);
  end_->setObjectName("muted");

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 5, 12, 5);
  row->setSpacing(6);
  row->addWidget(restart_);
  row->addWidget(starts_);
  row->addWidget(back_);
  row->addWidget(play_);
  row->addWidget(step_);
  row->addSpacing(6);
  row->addWidget(timeline_, 1);
  row->addWidget(end_);
  row->addWidget(flag_);
  row->addWidget(speed_);
  connect(restart_, &QToolButton::clicked, this, &TransportBar::restartClicked);
  connect(back_, &QToolButton::clicked, this, [this] { emit stepClicked(-1); });
  connect(step_, &QToolButton::clicked, this, [this] { emit stepClicked(1); });
  connect(flag_, &QToolButton::clicked, this, &TransportBar::stopsClicked);
  connect(timeline_, &Timeline::stepAsked, this, &TransportBar::stepClicked);
  connect(play_, &QToolButton::clicked, this, [this] { emit playClicked(!playing_); });
  set_icons();
}

void TransportBar::set_icons() {
  restart_->setIcon(themed_icon("restart", theme_.text));
  back_->setIcon(themed_icon("step-back", theme_.text));
  flag_->setIcon(themed_icon("flag", theme_.text));
  step_->setIcon(themed_icon("step", theme_.text));
  play_->setIcon(themed_icon(playing_ ? "pause" : "play", theme_.panel));
  play_->setAccessibleName(playing_ ? tr("Pause") : tr("Play"));
  play_->setStyleSheet(
      QString("QToolButton { background: %1; border-radius: 18px; } QToolButton:hover { background: %2; }")
          .arg(theme_.accent.name(), theme_.accent.lighter(112).name()));
}

const QWidget& TransportBar::flag() const { return *flag_; }

void TransportBar::show_speed(double speed) {
  speed_->setText(speed_text(speed));
  speed_->setAccessibleName(tr("Speed %1").arg(speed_text(speed)));
}

void TransportBar::choose_speed(double speed) {
  chosen_speed_ = speed;
  show_speed(speed);
  emit speedChosen(speed);
}

void TransportBar::change_speed(int steps) {
  const std::vector<double>& all = speeds();
  const auto at = std::find(all.begin(), all.end(), chosen_speed_) - all.begin();
  const auto last = static_cast<std::ptrdiff_t>(all.size()) - 1;
  const auto next = std::clamp<std::ptrdiff_t>(at + steps, 0, last);
  if (next != at) choose_speed(all[static_cast<std::size_t>(next)]);
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

void TransportBar::set_starts_menu(QMenu* menu) { starts_->setMenu(menu); }

void TransportBar::update_from(const Frame& frame, const Frame& newest, const Recorder& recorder,
                               double shown) {
  timeline_->update_from(newest, recorder, shown);
  end_->setText(QString("%1 s").arg(timeline_->end(), 0, 'g', 4));
  if (playing_ == frame.playing) return;
  playing_ = frame.playing;
  set_icons();
}

}  // namespace carom
