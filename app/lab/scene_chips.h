#pragma once

#include <QObject>

class QLabel;

namespace carom {

class SceneView;
class Session;
struct Preset;

// Chips over the scene: time, speed and what is modelled; below, what the run has to say, and where the cursor
// is. What has no room is elided, and stands whole in the tooltip.
class SceneChips : public QObject {
  Q_OBJECT

 public:
  explicit SceneChips(SceneView& view);

  void show_needs(const Preset& document);
  void show_time(const Session& session);
  // `more`: what the window has to say beside; `lost_told`: why a run is lost is told elsewhere.
  void show_notices(const Session& session, const QString& more, bool lost_told);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
  void show_position(double x, double y);  // m

  SceneView& view_;
  QWidget* row_;
  QLabel* time_;
  QLabel* speed_;
  QLabel* needs_;
  QLabel* status_;
  QLabel* position_;
  QString needs_text_, status_text_;
};

}  // namespace carom
