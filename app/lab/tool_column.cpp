#include "app/lab/tool_column.h"

#include <QAction>
#include <QLayout>
#include <QMenu>
#include <QToolButton>

namespace carom {

ToolColumn::ToolColumn(const QString& title) : QToolBar(title) {
  constexpr int kWidth = 40;  // px
  setObjectName("column");
  setAccessibleName(title);
  setOrientation(Qt::Vertical);
  setIconSize({18, 18});
  setFixedWidth(kWidth);
}

void ToolColumn::add_foldable(const QList<QAction*>& tools) {
  foldable_ = tools;
  addActions(tools);
  button_ = new QToolButton;
  button_->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button_);
  menu->addActions(tools);
  button_->setMenu(menu);
  button_->setDefaultAction(tools.front());
  for (QAction* tool : tools)
    connect(tool, &QAction::toggled, button_, [this, tool](bool on) {
      if (on) button_->setDefaultAction(tool);
    });
  folded_ = addWidget(button_);
  folded_->setVisible(false);
}

void ToolColumn::fold(bool folds) {
  if (folds == folded_->isVisible()) return;
  for (QAction* tool : foldable_) {
    if (folds) {
      removeAction(tool);
    } else {
      insertAction(folded_, tool);
    }
  }
  folded_->setVisible(folds);
}

void ToolColumn::resizeEvent(QResizeEvent* event) {
  QToolBar::resizeEvent(event);
  if (folded_ == nullptr) return;
  const int each = widgetForAction(actions().front())->sizeHint().height() + layout()->spacing();
  const int more = folded_->isVisible() ? each * (static_cast<int>(foldable_.size()) - 1) : 0;
  fold(sizeHint().height() + more > height());
}

}  // namespace carom
