#pragma once

#include <QWidget>
#include <optional>

#include "physics/record/frame.h"
#include "widgets/scene/scene_export.h"

class QLabel;

namespace carom {

class ExperimentList;

// The start of the experiment that is marked in the list, over the scene, until it is chosen or the focus or
// the mouse goes elsewhere. What is below is left alone.
class ExperimentPreview : public QWidget {
  Q_OBJECT

 public:
  ExperimentPreview(ExperimentList& list, QWidget* parent);

  void show_start(const Frame& start, const std::optional<View>& view, const SceneLook& look,
                  const QString& title);

 signals:
  void chosen();  // by a click
  void left();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void leave_for(const QWidget* widget);

  ExperimentList& list_;
  QLabel* title_;
  Frame start_;
  std::optional<View> view_;
  DrawingOptions options_;
  Theme theme_;
};

}  // namespace carom
