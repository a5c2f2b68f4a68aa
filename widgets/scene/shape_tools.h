#pragma once

#include <QString>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"
#include "widgets/scene/drag.h"

namespace carom {

// A press of the mouse, and where the mouse is now.
struct Stroke {
  Vec2 from = Vec2::Zero();  // m
  DragPoint to;
  double grid = 0.0;           // m, spacing; 0: none to snap to
  double side = 4.0;           // m, the shorter side of the view
  std::vector<Body> bodies{};  // as they stand; corners snap to their surfaces
};

// What a tool draws.
struct Drawn {
  Shape shape;
  Vec2 position = Vec2::Zero();  // m, of the centre of mass
  double angle = 0.0;            // rad
  QString value;                 // with its unit, for the bubble
};

// A tool that draws bodies.
struct ShapeTool {
  SceneTool tool = SceneTool::kDisc;
  const char* noun = "";                    // of what it draws, for the name of the edit
  bool over_bodies = true;                  // also where the press hits a body
  bool by_corners = false;                  // the mouse sets corner by corner; `click` is what a key draws
  Drawn (*click)(const Stroke&) = nullptr;  // null: a body of random size is asked for
  Drawn (*drag)(const Stroke&) = nullptr;   // null: as a click
};

// The tool's row in the table; null for kSelect.
[[nodiscard]] const ShapeTool* shape_tool(SceneTool tool);

// "30 cm at 45°", of a line that the mouse draws.
[[nodiscard]] QString line_text(const Vec2& line, const DragPoint& point);

}  // namespace carom
