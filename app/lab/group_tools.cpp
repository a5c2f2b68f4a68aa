#include "app/lab/group_tools.h"

#include <QAction>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>

namespace carom {
namespace {

QPushButton* add_button(QWidget* to, const QString& text, const QString& tip) {
  auto* button = new QPushButton(to);
  button->setObjectName("small");
  button->setText(text);
  button->setToolTip(tip);
  button->setAccessibleName(text);
  // What is typed elsewhere is not taken by a click here.
  button->setFocusPolicy(Qt::TabFocus);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  to->layout()->addWidget(button);
  return button;
}

QPushButton* add_menu_button(QWidget* to, const QString& text, const QString& tip) {
  QPushButton* button = add_button(to, text, tip);
  button->setText(text + QStringLiteral(" ▾"));
  button->setMenu(new QMenu(button));
  return button;
}

}  // namespace

GroupTools::GroupTools(const QList<QAction*>& align, QAction* touch, QWidget* parent)
    : QWidget(parent), touch_action_(touch) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(6);
  align_ = add_menu_button(this, tr("Align"), tr("Puts sides or centres in line"));
  distribute_ =
      add_menu_button(this, tr("Distribute"), tr("Equal gaps between three or more; the outer ones stay"));
  touch_ = add_button(this, tr("Put in touch"), tr("Of two: moves the first one to the other (K)"));
  QMenu* menu = align_->menu();
  for (QAction* action : align) {
    if (action->isSeparator()) {
      menu = distribute_->menu();
    } else {
      menu->addAction(action);
    }
  }
  connect(touch_, &QPushButton::clicked, touch, &QAction::trigger);
}

void GroupTools::enable(bool align, bool distribute, bool touch) {
  align_->setEnabled(align);
  distribute_->setEnabled(distribute);
  touch_->setEnabled(touch);
  touch_action_->setEnabled(touch);
}

}  // namespace carom
