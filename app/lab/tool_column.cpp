#include "app/lab/tool_column.h"

#include <QAction>
#include <QActionEvent>
#include <QLayout>
#include <QMenu>
#include <QStyle>
#include <QToolButton>
#include <algorithm>

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
  mark_kept();
}

void ToolColumn::show_kept(const QAction* tool) {
  kept_ = tool;
  mark_kept();
}

void ToolColumn::mark_kept() {
  for (QAction* action : actions()) {
    QWidget* button = widgetForAction(action);
    const bool in_menu =
        action == folded_ && std::find(foldable_.begin(), foldable_.end(), kept_) != foldable_.end();
    const bool kept = kept_ != nullptr && (action == kept_ || in_menu);
    if (button->property("kept").toBool() == kept) continue;
    button->setProperty("kept", kept);
    button->setAccessibleDescription(kept ? tr("kept until Escape") : QString());
    button->style()->unpolish(button);
    button->style()->polish(button);
  }
}

// Its buttons can be reached by Tab.
void ToolColumn::actionEvent(QActionEvent* event) {
  QToolBar::actionEvent(event);
  if (event->type() != QEvent::ActionAdded) return;
  if (auto* button = qobject_cast<QToolButton*>(widgetForAction(event->action())))
    button->setFocusPolicy(Qt::TabFocus);
}

void ToolColumn::resizeEvent(QResizeEvent* event) {
  QToolBar::resizeEvent(event);
  if (folded_ == nullptr) return;
  const int each = widgetForAction(actions().front())->sizeHint().height() + layout()->spacing();
  const int more = folded_->isVisible() ? each * (static_cast<int>(foldable_.size()) - 1) : 0;
  fold(sizeHint().height() + more > height());
}

}  // namespace carom
