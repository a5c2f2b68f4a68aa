#pragma once

#include <QLabel>
#include <QObject>

class QPushButton;

namespace carom {

class SceneView;
class LabRuns;
struct StartOrigin;

// Chips over the scene: time and speed, the offer to follow bodies that left, and at the right the tool in
// hand; below, the run's notices and the cursor's position. Long text is elided; the tooltip shows all of it.
class SceneChips : public QObject {
  Q_OBJECT

 public:
  explicit SceneChips(SceneView& view);

  // The place of the mouse is unknown until it moves: another scene is shown under it.
  void forget_position() { position_->hide(); }
  // The tool in hand and what it does; empty: it is the usual one, and what the mouse can do is told.
  void show_tool(const QString& text);
  void show_time(const LabRuns& runs);
  // With the speed: whether playing will be slower near impacts.
  void say_slower(bool slower) { slows_ = slower; }
  // Names the start for as long as it is a moment of the run before.
  void show_start(const StartOrigin& start);
  [[nodiscard]] QPushButton* start_chip() { return start_; }
  // `more`: further text of the window; `lost_shown`: the reason of a lost run is shown elsewhere.
  void show_notices(const LabRuns& runs, const QString& more, bool lost_shown);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  void say_moment(const LabRuns& runs, const QString& impact_pair);
  void show_position(double x, double y);  // m

  SceneView& view_;
  QWidget* row_;
  QLabel* time_;
  QLabel* speed_;
  QPushButton* start_;
  QLabel* stop_;    // that is met at this moment
  QLabel* impact_;  // at a moment of the record
  QPushButton* follow_;
  QLabel* status_;
  QLabel* tool_;
  QLabel* position_;
  QString status_text_, tool_text_, hint_, said_;
  bool slows_ = false;
};

}  // namespace carom
