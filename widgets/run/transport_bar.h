#pragma once

#include <QFrame>
#include <vector>

#include "physics/record/frame.h"
#include "physics/record/recorder.h"
#include "widgets/theme/theme.h"

class QLabel;
class QToolButton;

namespace carom {

// Progress of the run: the experiment's duration as a line, the time so far filled, a tick for each impact.
// Where a run continues past the duration the line grows by whole durations.
class Timeline : public QWidget {
  Q_OBJECT

 public:
  explicit Timeline(const Theme& theme, QWidget* parent = nullptr);
  void set_theme(const Theme& theme);
  void set_duration(double seconds);
  void update_from(const Frame& frame, const Recorder& recorder);
  [[nodiscard]] double end() const;
  [[nodiscard]] QSize sizeHint() const override { return {200, 28}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Theme theme_;
  double duration_ = 1.0;
  double time_ = 0.0;
  std::vector<double> ticks_;  // s, thinned to what pixels can show
};

// Restart, play or pause, one step, the timeline and the speed.
class TransportBar : public QFrame {
  Q_OBJECT

 public:
  explicit TransportBar(const Theme& theme, QWidget* parent = nullptr);
  void set_theme(const Theme& theme);
  void set_duration(double seconds);
  void update_from(const Frame& frame, const Recorder& recorder);
  // The speeds to choose from, simulated seconds per second.
  [[nodiscard]] static const std::vector<double>& speeds();
  // 1/4 as "×¼".
  [[nodiscard]] static QString speed_text(double speed);

 signals:
  void restartClicked();
  void playClicked(bool play);
  void stepClicked();
  void speedChosen(double speed);

 private:
  void set_icons();

  Theme theme_;
  QToolButton* restart_;
  QToolButton* play_;
  QToolButton* step_;
  QToolButton* speed_;
  Timeline* timeline_;
  QLabel* end_;
  bool playing_ = false;
};

}  // namespace carom
