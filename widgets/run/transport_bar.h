#pragma once

#include <QFrame>
#include <vector>

#include "physics/record/frame.h"
#include "physics/record/recorder.h"
#include "widgets/run/timeline.h"
#include "widgets/theme/theme.h"

class QLabel;
class QMenu;
class QToolButton;

namespace carom {

// Restart, a step back, play or pause, a step, the timeline, the stops and the speed.
class TransportBar : public QFrame {
  Q_OBJECT

 public:
  explicit TransportBar(const Theme& theme, QWidget* parent = nullptr);
  void set_theme(const Theme& theme);
  void set_duration(double seconds);
  void set_starts_menu(QMenu* menu);  // of the arrow beside the restart button
  // What is shown, at `shown` s, and the newest moment of the first run.
  void update_from(const Frame& frame, const Frame& newest, const Recorder& recorder, double shown);
  [[nodiscard]] Timeline& timeline() { return *timeline_; }
  [[nodiscard]] const QWidget& flag() const;
  // The speeds to choose from, simulated seconds per second.
  [[nodiscard]] static const std::vector<double>& speeds();
  // To a faster one of these, or a slower one.
  void change_speed(int steps);
  // A quarter as "×1/4".
  [[nodiscard]] static QString speed_text(double speed);

 signals:
  void restartClicked();
  void playClicked(bool play);
  void stepClicked(int steps);
  void speedChosen(double speed);
  void stopsClicked();

 private:
  void set_icons();
  void choose_speed(double speed);
  void show_speed(double speed);

  Theme theme_;
  QToolButton* restart_;
  QToolButton* starts_;
  QToolButton* play_;
  QToolButton* back_;
  QToolButton* step_;
  QToolButton* flag_;
  QToolButton* speed_;
  Timeline* timeline_;
  QLabel* end_;
  bool playing_ = false;
  double chosen_speed_ = 1.0;
};

}  // namespace carom
