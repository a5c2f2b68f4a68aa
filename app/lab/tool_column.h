#pragma once

#include <QList>
#include <QToolBar>

class QToolButton;

namespace carom {

// The tools at the left of the scene. Where they are too many for the height, some fold into one button with a
// menu, which shows the one used last.
class ToolColumn : public QToolBar {
 public:
  explicit ToolColumn(const QString& title);

  // Adds tools that fold together.
  void add_foldable(const QList<QAction*>& tools);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fold(bool folds);

  QList<QAction*> foldable_;
  QToolButton* button_ = nullptr;
  QAction* folded_ = nullptr;  // of the button
};

}  // namespace carom
