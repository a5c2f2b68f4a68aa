#pragma once

#include <QObject>

class QLabel;

namespace carom {

class SceneView;
class LabRuns;

// Chips over the scene: time and speed; below, the run's notices and the cursor's position.
// Long text is elided; the tooltip shows all of it.
class SceneChips : public QObject {
  Q_OBJECT

 public:
  explicit SceneChips(SceneView& view);

  void show_time(const LabRuns& runs);
  // `more`: further text of the window; `lost_shown`: the reason of a lost run is shown elsewhere.
  void show_notices(const LabRuns& runs, const QString& more, bool lost_shown);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  void show_position(double x, double y);  // m

  SceneView& view_;
  QWidget* row_;
  QLabel* time_;
  QLabel* speed_;
  QLabel* status_;
  QLabel* position_;
  QString status_text_;
};

}  // namespace carom
