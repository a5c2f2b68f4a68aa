#include <QAction>
#include <QMenu>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <initializer_list>

#include "app/lab/lab_window.h"
#include "app/lab/method_bar.h"
#include "widgets/base/plain_text.h"
#include "widgets/plot/plot_panel.h"

// The tool bar of the lab's window.
namespace carom {
namespace {

constexpr int kWide = 1200;     // px: a window that has room for the switches of the view
constexpr int kWideName = 236;  // px, of the open experiment
constexpr int kNarrowName = 126;
constexpr int kNameFrom = 1000;  // px: a window that has room for a part of the name

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
  add({"new", "open", "save"});
  bar->addSeparator();
  add({"undo", "redo"});
  bar->addSeparator();
  const qsizetype before = bar->actions().size();
  add({"fit", "grid", "velocity", "contact", "names"});
  for (QAction* action : bar->actions().mid(before)) folded_.push_back(action);
  auto* switches = new QMenu(this);
  switches->addActions({folded_.begin(), folded_.end()});
  more_ = bar->addWidget(menu_button(QStringLiteral("…"), tr("Switches of the scene"), switches));
  more_->setVisible(false);
  bar->addSeparator();
  methods_->add_to(bar);
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

// In a narrow window the switches of the view are behind one button.
void LabWindow::fold_tool_bar() {
  const bool wide = width() >= kWide;
  if (more_->isVisible() == wide) {
    more_->setVisible(!wide);
    for (QAction* action : folded_) wide ? bar_->insertAction(more_, action) : bar_->removeAction(action);
  }
  name_experiment();
  // The names of the methods get the room that there is now.
  QTimer::singleShot(0, this, [this] { methods_->show_document(preset()); });
}

// The open one, on the button of their list.
void LabWindow::name_experiment() {
  constexpr int kRest = 62;  // px: icon, arrow and padding
  const QString title = QString::fromStdString(preset().title);
  const int room = width() >= kWide ? kWideName : width() >= kNameFrom ? kNarrowName : kRest;
  list_button_->setFixedWidth(room);
  const QFontMetrics metrics = list_button_->fontMetrics();
  const QString shown =
      room > kRest ? metrics.elidedText(title, Qt::ElideRight, room - kRest) + " " : QString();
  list_button_->setText(QString(shown).replace("&", "&&") + QStringLiteral("▾"));
  list_button_->setToolTip(plain_tip(tr("%1\nThe list of experiments (E)").arg(title)));
  list_button_->setAccessibleName(tr("Experiments: %1").arg(title));
}

}  // namespace carom
