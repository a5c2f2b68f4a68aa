#include <QAction>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <initializer_list>
#include <utility>

#include "app/lab/lab_window.h"
#include "app/lab/method_bar.h"
#include "widgets/base/plain_text.h"
#include "widgets/plot/plot_panel.h"

// The tool bar of the lab's window.
namespace carom {
namespace {

constexpr int kWide = 1200;     // px: a window that has room for the switches of the view
constexpr int kWideName = 236;  // px, of the button with the name of the open experiment
constexpr int kLeastName = 62;  // px, of its icon and arrow alone
constexpr int kLeastPart = 30;  // px: less of the name says nothing

QToolButton* choice_button(const QString& text, const QString& tip) {
  auto* button = new QToolButton;
  button->setObjectName("choice");
  button->setText(text);
  button->setToolTip(tip);
  return button;
}

QToolButton* menu_button(const QString& text, const QString& tip, QMenu* menu) {
  QToolButton* button = choice_button(text, tip);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setMenu(menu);
  return button;
}

}  // namespace

void LabWindow::make_tool_bar() {
  QToolBar* bar = bar_ = addToolBar(tr("Main"));
  bar->setMovable(false);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  bar->setIconSize({18, 18});
  const auto add = [&](std::initializer_list<const char*> icons) {
    for (const char* icon : icons) {
      for (const auto& [action, name] : icon_actions_) {
        if (name == icon) bar->addAction(action);
      }
    }
  };
  list_button_ = choice_button({}, {});
  list_button_->setCheckable(true);
  list_button_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(list_button_, &QToolButton::toggled, list_action_, &QAction::setChecked);
  connect(list_action_, &QAction::toggled, list_button_, &QToolButton::setChecked);
  name_in_bar_ = bar->addWidget(list_button_);
  bar->addSeparator();
  const auto add_group = [&](std::initializer_list<const char*> icons) {
    const qsizetype before = bar->actions().size();
    add(icons);
    const QList<QAction*> added = bar->actions().mid(before);
    return FoldedGroup{.actions = {added.begin(), added.end()}};
  };
  files_in_bar_ = add_group({"new", "open", "save"});
  files_in_bar_.before = bar->addSeparator();
  add({"undo", "redo"});
  bar->addSeparator();
  switches_ = add_group({"fit", "grid", "velocity", "contact", "names"});
  auto* menu = new QMenu(this);
  menu->addActions({switches_.actions.begin(), switches_.actions.end()});
  menu->addSeparator();
  menu->addActions({files_in_bar_.actions.begin(), files_in_bar_.actions.end()});
  more_ = switches_.before = bar->addWidget(menu_button(QStringLiteral("…"), tr("More buttons"), menu));
  more_->setVisible(false);
  bar->addSeparator();
  methods_->add_to(bar);
  connect(methods_, &MethodBar::roomFreed, this, &LabWindow::unfold_tool_bar);
  connect(methods_, &MethodBar::roomMissing, this, &LabWindow::fold_tool_bar);
  auto* stretch = new QWidget;
  stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(stretch);
  bar->addWidget(menu_button(tr("Plots") + QStringLiteral(" ▾"), tr("Which plots are shown"), plots_->menu()));
  auto* gap = new QWidget;
  gap->setFixedWidth(4);
  bar->addWidget(gap);
  add({"help"});
  bar->addAction(theme_action_);
  setContextMenuPolicy(Qt::NoContextMenu);
}

void LabWindow::fold(FoldedGroup& group, bool folds) {
  if (std::exchange(group.folded, folds) == folds) return;
  for (QAction* action : group.actions)
    folds ? bar_->removeAction(action) : bar_->insertAction(group.before, action);
  if (group.before->isSeparator()) group.before->setVisible(!folds);
  more_->setVisible(switches_.folded || files_in_bar_.folded);
}

// All that the width of the window is meant for; in a narrow one the switches of the view are behind a button.
void LabWindow::unfold_tool_bar() {
  fold(files_in_bar_, false);
  fold(switches_, width() < kWide);
  name_room_ = kWideName;
  name_experiment();
}

// First the name gives way, then the switches do, then the files.
void LabWindow::fold_tool_bar(int missing) {
  name_room_ = std::max(kWideName - missing, kLeastName);
  name_experiment();
  for (FoldedGroup* group : {&switches_, &files_in_bar_}) {
    if (bar_->sizeHint().width() > bar_->width()) fold(*group, true);
  }
  // The name takes what they left over.
  if (const int spare = bar_->width() - bar_->sizeHint().width(); spare > 0) {
    name_room_ = std::min(name_room_ + spare, kWideName);
    name_experiment();
  }
}

// The open one, on the button of their list.
void LabWindow::name_experiment() {
  const QString title = QString::fromStdString(preset().title);
  list_button_->setFixedWidth(name_room_);
  const QFontMetrics metrics = list_button_->fontMetrics();
  const int room = name_room_ - kLeastName;
  const QString shown =
      room > kLeastPart ? metrics.elidedText(title, Qt::ElideRight, room).replace("&", "&&") + " " : QString();
  list_button_->setText(shown + QStringLiteral("▾"));
  list_button_->setToolTip(plain_tip(tr("%1\nThe list of experiments (E)").arg(title)));
  list_button_->setAccessibleName(tr("Experiments: %1").arg(title));
}

}  // namespace carom
