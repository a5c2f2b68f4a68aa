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
  // Marks the button of the tool that is kept for several uses; null: none is.
  void show_kept(const QAction* tool);

 protected:
  void actionEvent(QActionEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fold(bool folds);
  void mark_kept();

  QList<QAction*> foldable_;
  const QAction* kept_ = nullptr;
  QToolButton* button_ = nullptr;
  QAction* folded_ = nullptr;  // of the button
};

}  // namespace carom
