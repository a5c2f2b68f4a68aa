#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <array>
#include <utility>

#include "app/lab/lab_window.h"
#include "app/lab/scene_chips.h"
#include "app/lab/tool_column.h"
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
constexpr std::array<ToolText, 12> kTools = {{
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
    {SceneTool::kRod, "rod", "&Rod", "Rod (%1): from body to body or to a place: drag, or click both ends",
     Qt::Key_O},
    {SceneTool::kString, "string", "S&tring",
     "String (%1), a rod that only pulls: drag from end to end, or click both", Qt::Key_T},
    {SceneTool::kSpring, "spring", "Spri&ng",
     "Spring (%1): from body to body or to a place: drag, or click both ends", Qt::Key_S},
    {SceneTool::kPin, "pin", "P&in",
     "Pin (%1): click where two bodies overlap, or on one to pin it to the plane", Qt::Key_N},
    {SceneTool::kWeld, "weld", "Wel&d", "Weld (%1): click a body, then the other", Qt::Key_J},
    {SceneTool::kForce, "force", "&Force", "Force (%1): pull an arrow out of a body", Qt::Key_A},
    {SceneTool::kDrive, "drive", "Dri&ve", "Drive (%1): pull a velocity out of a body; Shift: to and fro",
     Qt::Key_M},
}};

bool is_joint(SceneTool tool) { return joint_tool(tool) != nullptr && !joint_tool(tool)->to_mouse; }

}  // namespace

void LabWindow::make_tools_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&Tools"));
  auto* group = new QActionGroup(this);
  QList<QAction*> joints;
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
    connect(view_, &SceneView::toolChanged, action, [this, action, tool](SceneTool now, bool kept) {
      action->setChecked(now == tool);
      const QString once = action->toolTip().section('\n', 0, 0);
      action->setToolTip(now == tool && kept ? once + "\n" + tr("Kept: Escape ends it") : once);
      if (now == tool) show_tool(*action, kept);
    });
    if (is_joint(tool)) {
      joints << action;
      continue;
    }
    if (!joints.isEmpty()) {
      tool_column_->add_foldable(std::exchange(joints, {}));
      tool_column_->addSeparator();
    }
    tool_column_->addAction(action);
    if (tool == SceneTool::kSelect || tool == SceneTool::kWall) tool_column_->addSeparator();
  }
}

// The one in hand, and whether it is kept.
void LabWindow::show_tool(const QAction& action, bool kept) {
  tool_column_->show_kept(kept ? &action : nullptr);
  const QString name = QString(action.text()).remove('&');
  const QString does = action.toolTip().section('\n', 0, 0).section(": ", 1);
  const bool selects = view_->tool() == SceneTool::kSelect;
  chips_->show_tool(selects ? QString()
                    : kept  ? tr("%1, kept: Esc ends it · %2").arg(name, does)
                            : tr("%1, once · %2").arg(name, does));
}

QWidget* LabWindow::make_tool_column() {
  tool_column_ = new ToolColumn(tr("Tools"));
  return tool_column_;
}

}  // namespace carom
