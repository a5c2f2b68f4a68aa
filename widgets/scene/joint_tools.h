#pragma once

#include <QString>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "physics/record/frame.h"
#include "physics/scene/edit.h"
#include "widgets/scene/camera.h"
#include "widgets/scene/drag.h"
#include "widgets/scene/shape_tools.h"

namespace carom {

// An end of a joint, a spring or a force.
struct LinkEnd {
  std::string body;         // empty: the plane
  Vec2 own = Vec2::Zero();  // m, from the body's centre along its own axes; or the point of the plane
};
using LinkEnds = std::array<LinkEnd, 2>;

// What ends are found in, and where the mouse is.
struct JointSight {
  std::shared_ptr<const Frame> frame;
  Camera camera;
  DragPoint mouse;
  double grid = 0.0;                      // m, spacing; 0: none to snap to
  double metres_per_newton = 0.0;         // of arrows of forces; 0: none is shown
  double arrow_seconds = 0.1;             // m of arrow per m/s
  std::optional<Id<Joint>> instead_of{};  // the joint whose place a new one takes
};

// What a tool makes.
struct Joined {
  SceneEdits edits;          // none if there is a fault
  QString name;              // of the edit
  QString value;             // with its unit, for the bubble
  QString detail;            // what else it changes
  QString fault;             // why nothing can be made
  Vec2 from = Vec2::Zero();  // m
  Vec2 to = Vec2::Zero();    // m
};

// A tool that draws a joint, a spring, a force or a drive.
struct JointTool {
  SceneTool tool = SceneTool::kRod;
  const char* noun = "";    // of what it draws
  bool one_click = false;   // takes both ends from one place
  bool at_centres = false;  // its ends on bodies are their centres
  bool to_mouse = false;    // its second end is the mouse, on a body or not
  Joined (*join)(const JointTool& tool, const JointSight& sight, const LinkEnds& ends) = nullptr;
};

// The tool's row in the table; null for other tools.
[[nodiscard]] const JointTool* joint_tool(SceneTool tool);

// The end at the mouse: on the topmost body, at its centre, a corner or its rim if that is near; or in the
// plane, on the grid.
[[nodiscard]] LinkEnd end_at_mouse(const JointTool& tool, const JointSight& sight);
// Both ends there, on the two topmost bodies, or on one and in the plane.
[[nodiscard]] LinkEnds ends_at_mouse(const JointSight& sight);
// Those that a key means: of two bodies, or of one and the mouse. None if the tool needs other ones.
[[nodiscard]] std::optional<LinkEnds> ends_of(const JointTool& tool, const JointSight& sight,
                                              std::span<const std::string> bodies);

// Where the end is now, in m; and its body, none in the plane.
[[nodiscard]] Vec2 place_of(const Frame& frame, const LinkEnd& end);
[[nodiscard]] std::optional<Body> body_at_end(const Frame& frame, const LinkEnd& end);

}  // namespace carom
