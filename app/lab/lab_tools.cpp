#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <array>

#include "app/lab/lab_window.h"
#include "widgets/scene/scene_view.h"

// The tools of the mouse in the scene: their menu, and their column at its left.
namespace carom {
namespace {

struct ToolText {
  SceneTool tool;
  const char* icon;
  const char* text;
  const char* tip;
  Qt::Key key;
};
constexpr std::array<ToolText, 5> kTools = {{
    {SceneTool::kSelect, "select", "&Select",
     "Select (%1): select, move, turn and resize bodies, and pull their velocity", Qt::Key_V},
    {SceneTool::kDisc, "disc", "&Disc", "Disc (%1): click: random radius like the others; drag: radius",
     Qt::Key_D},
    {SceneTool::kBox, "box", "&Box",
     "Box (%1): click: a square of 20 cm; drag: corner to corner; Shift: square", Qt::Key_B},
    {SceneTool::kPolygon, "polygon", "&Polygon",
     "Polygon (%1): click each corner; Enter, a double click or the first corner closes it", Qt::Key_P},
    {SceneTool::kWall, "wall", "&Wall",
     "Wall (%1): click: level half-plane; drag: a thin wall; Shift: steps of 15°", Qt::Key_W},
}};

}  // namespace

void LabWindow::make_tools_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&Tools"));
  auto* group = new QActionGroup(this);
  for (const ToolText& each : kTools) {
    const SceneTool tool = each.tool;
    QAction* action = add_action(menu, each.icon, tr(each.text), each.key, [this, tool] {
      // Chosen again, it is kept.
      view_->set_tool(tool, view_->tool() == tool);
      view_->setFocus();
    });
    action->setToolTip(tr(each.tip).arg(QKeySequence(each.key).toString()));
    action->setAutoRepeat(false);
    action->setCheckable(true);
    action->setChecked(tool == view_->tool());
    group->addAction(action);
    connect(view_, &SceneView::toolChanged, action,
            [action, tool](SceneTool now) { action->setChecked(now == tool); });
    tool_column_->addAction(action);
    if (tool == SceneTool::kSelect) tool_column_->addSeparator();
  }
}

QWidget* LabWindow::make_tool_column() {
  constexpr int kWidth = 40;  // px
  tool_column_ = new QToolBar(tr("Tools"));
  tool_column_->setObjectName("column");
  tool_column_->setAccessibleName(tr("Tools"));
  tool_column_->setOrientation(Qt::Vertical);
  tool_column_->setIconSize({18, 18});
  tool_column_->setFixedWidth(kWidth);
  return tool_column_;
}

}  // namespace carom
