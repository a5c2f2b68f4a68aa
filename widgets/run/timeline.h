#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "physics/record/frame.h"
#include "physics/record/recorder.h"
#include "widgets/run/timeline_flags.h"
#include "widgets/theme/theme.h"

class QLineEdit;

namespace carom {

// The record of a run: the experiment's duration as a line, the time so far filled, a tick for each impact, and
// the playhead at the shown moment. Where a run continues past the duration the line grows by whole durations.
// Click and drag: to a moment, with Shift ten times finer; a click on a tick: to the impact. Wheel: a step,
// with Ctrl an impact. Double click: on a tick the impact, elsewhere a field for a time. Stops have flags: a
// click chooses one, a drag moves one at a time, Escape takes the drag back, Delete removes the chosen one. The
// marks A and B are letters under the line.
class Timeline : public QWidget {
  Q_OBJECT

 public:
  explicit Timeline(const Theme& theme, QWidget* parent = nullptr);
  void set_theme(const Theme& theme);
  void set_duration(double seconds);
  void set_start(double time);  // s, of the record
  void set_stops(const std::vector<Stop>& stops);
  // The user's marks A and B, s.
  void set_marks(std::optional<double> a, std::optional<double> b);
  // `shown`: s, of the playhead.
  void update_from(const Frame& newest, const Recorder& recorder, double shown);
  [[nodiscard]] double end() const;
  [[nodiscard]] double shown() const { return shown_; }  // s
  [[nodiscard]] double x_of(double time) const;          // px
  [[nodiscard]] QSize sizeHint() const override { return {200, 28}; }

 signals:
  void scrubBegan();
  void scrubbed(double time);  // s
  void scrubEnded();
  void timeTyped(double time);     // s
  void impactChosen(double time);  // s, of a recorded impact
  void impactOpened(double time);  // likewise
  void stepAsked(int steps);
  void impactAsked(bool forward);
  // Of the document's stops, by their index.
  void flagClicked(std::size_t stop);
  void flagMoved(std::size_t stop, double time);  // s
  void flagRemoved(std::size_t stop);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  // A drag with the left button.
  struct Scrub {
    double x = 0.0;     // px, of the last event
    double time = 0.0;  // s, there; between steps too
  };

  // The left button holds a flag.
  struct HeldFlag {
    TimelineFlag flag;
    double x = 0.0;   // px, of the press
    double to = 0.0;  // s, once it has moved
    bool moved = false;
  };

  [[nodiscard]] double time_at(double x) const;
  [[nodiscard]] std::optional<double> tick_at(double x) const;  // s
  [[nodiscard]] std::optional<TimelineFlag> flag_at(const QPointF& at) const;
  void paint_marks(QPainter& painter, double middle) const;
  void drag_flag(double x, bool finer);
  void drop_flag();
  void open_field();
  void take_field();
  void say_fault(const QString& sentence);  // of what is typed; empty: of none

  Theme theme_;
  QLineEdit* field_;
  double duration_ = 1.0;
  double start_ = 0.0;  // s
  double time_ = 0.0;
  double shown_ = 0.0;
  std::vector<double> ticks_;                   // s, thinned to what pixels can show
  std::array<std::optional<double>, 2> marks_;  // s
  TimelineFlags flags_;
  std::optional<HeldFlag> held_;
  std::optional<std::size_t> chosen_;  // stop
  std::optional<Scrub> scrub_;
  int wheel_ = 0;  // eighths of a degree, not yet a step
};

}  // namespace carom
