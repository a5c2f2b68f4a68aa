#include "widgets/scene/part_ends.h"

#include <QLineF>
#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include "physics/scene/edit_rules.h"
#include "widgets/scene/drawing_forces.h"
#include "widgets/scene/edit_names.h"
#include "widgets/scene/handles.h"
#include "widgets/scene/hit.h"

namespace carom {
namespace {

LinkEnds ends_of(const Joint& joint) {
  return {LinkEnd{joint.body, joint.point}, LinkEnd{joint.to, joint.anchor}};
}

LinkEnds ends_of(const Spring& spring) {
  return {LinkEnd{spring.body, spring.point}, LinkEnd{spring.to, spring.anchor}};
}

// What the tool that draws such parts makes of the ends.
Joined joined_at_mouse(SceneTool kind, const JointSight& sight, LinkEnds ends, std::size_t end) {
  const JointTool& tool = *joint_tool(kind);
  ends[end] = end_at_mouse(tool, sight);
  return tool.join(tool, sight, ends);
}

QString name_of_move(const QString& part) { return "Move the end of " + part; }

// The paused scene says the lengths that hold, the setup those that are stated.
bool has_stated_length(const Frame& frame, const Joint& joint) {
  const Joint* stated = frame.setup ? part_of(frame.setup->scene.joints, joint.id) : nullptr;
  return stated == nullptr ? joint.length.has_value() : stated->length.has_value();
}

Joined with_end(const JointSight& sight, const Joint& joint, std::size_t end) {
  const bool rod = joint.kind == JointKind::kRod;
  JointSight free = sight;
  free.instead_of = joint.id;
  Joined out = joined_at_mouse(rod ? SceneTool::kRod : SceneTool::kString, free, ends_of(joint), end);
  out.name = name_of_move(name_of_part(joint));
  if (out.edits.empty()) return out;
  const Joint made = std::get<Add<Joint>>(out.edits.back()).part;
  Joint moved = joint;
  moved.body = made.body;
  moved.point = made.point;
  moved.to = made.to;
  moved.anchor = made.anchor;
  const double distance = (out.to - out.from).norm();
  moved.length.reset();
  if (has_stated_length(*sight.frame, joint)) moved.length = rod ? distance : std::max(*joint.length, distance);
  out.edits.back() = Replace<Joint>{moved};  // after the bodies that lose some of their velocity
  return out;
}

Joined with_end(const JointSight& sight, const Spring& spring, std::size_t end) {
  Joined out = joined_at_mouse(SceneTool::kSpring, sight, ends_of(spring), end);
  out.name = name_of_move(name_of_part(spring));
  if (out.edits.empty()) return out;
  const Spring made = std::get<Add<Spring>>(out.edits[0]).part;
  Spring moved = spring;
  moved.body = made.body;
  moved.point = made.point;
  moved.to = made.to;
  moved.anchor = made.anchor;
  out.edits = {Replace<Spring>{moved}};
  return out;
}

// "at the centre of A", "at (0.10, 0.00) m of A"
QString foot_text(const LinkEnd& foot, double scale) {
  const QString body = QString::fromStdString(foot.body);
  return foot.own.isZero(0.0) ? "at the centre of " + body
                              : "at " + place_text(foot.own, scale) + " of " + body;
}

Joined with_foot(const JointSight& sight, const AppliedForce& force) {
  JointTool anywhere = *joint_tool(SceneTool::kForce);
  anywhere.at_centres = false;
  const LinkEnd foot = end_at_mouse(anywhere, sight);
  const std::optional<Body> body = body_at_end(*sight.frame, foot);
  Joined out;
  out.name = "Move the foot of " + name_of_part(force);
  out.from = place_of(*sight.frame, foot);
  out.to = out.from + sight.metres_per_newton * share_at(force, sight.frame->time) * force.force;
  if (!body || has_infinite_mass(*body)) {
    out.fault = QStringLiteral("a force acts on a body that moves");
    return out;
  }
  AppliedForce moved = force;
  moved.body = foot.body;
  moved.point = foot.own;
  out.value = foot_text(foot, sight.mouse.scale);
  out.edits = {Replace<AppliedForce>{moved}};
  return out;
}

Joined with_end(const JointSight& sight, const AppliedForce& force, std::size_t end) {
  if (end == kFoot) return with_foot(sight, force);
  JointSight now = sight;
  now.metres_per_newton *= share_at(force, sight.frame->time);
  const JointTool& tool = *joint_tool(SceneTool::kForce);
  Joined out = tool.join(tool, now, {LinkEnd{force.body, force.point}, LinkEnd{{}, sight.mouse.at}});
  if (out.edits.empty()) return out;
  AppliedForce moved = force;
  moved.force = std::get<Add<AppliedForce>>(out.edits[0]).part.force;
  out.name = name_of_force(force, moved);
  out.edits = {Replace<AppliedForce>{moved}};
  return out;
}

}  // namespace

std::optional<std::size_t> end_of_part_at(const Frame& frame, const Camera& camera, const PartId& part,
                                          const QPointF& at, double metres_per_newton) {
  const auto line = line_of(frame, part, metres_per_newton);
  if (!line || line->from == line->to) return std::nullopt;
  const double to_body = QLineF(camera.to_screen(line->to), at).length();
  const double to_other = QLineF(camera.to_screen(line->from), at).length();
  if (std::min(to_body, to_other) > kHandleReach) return std::nullopt;
  const bool first = to_body <= to_other;
  return first != line->arrow ? 0 : 1;
}

EndDrag::EndDrag(const JointSight& began, const PartId& part, std::size_t end)
    : began_(began),
      part_(part),
      end_(end),
      line_(line_of(*began.frame, part, began.metres_per_newton).value_or(PartLine{})) {}

Joined EndDrag::to(const DragPoint& mouse) {
  const Scene& scene = *began_.frame->scene;
  JointSight sight = began_;
  sight.mouse = mouse;
  if (line_.arrow) sight.mouse.at += (end_ == kFoot ? line_.from : line_.to) - began_.mouse.at;
  const auto move = [&](const auto& part) {
    Joined out = with_end(sight, part, end_);
    if (!out.fault.isEmpty()) out.edits = {Replace<std::decay_t<decltype(part)>>{part}};
    return out;
  };
  Joined out = std::holds_alternative<Id<Joint>>(part_)
                   ? move(*part_of(scene.joints, std::get<Id<Joint>>(part_)))
               : std::holds_alternative<Id<Spring>>(part_)
                   ? move(*part_of(scene.forces.springs, std::get<Id<Spring>>(part_)))
                   : move(*part_of(scene.forces.applied, std::get<Id<AppliedForce>>(part_)));
  out.edits = with_others_back(std::move(out.edits));
  return out;
}

SceneEdits EndDrag::with_others_back(SceneEdits edits) {
  std::vector<Id<Body>> replaced;
  for (const SceneEdit& edit : edits) {
    if (const auto* body = std::get_if<Replace<Body>>(&edit)) replaced.push_back(body->part.id);
  }
  const auto is_replaced = [&](const Body& body) {
    return std::find(replaced.begin(), replaced.end(), body.id) != replaced.end();
  };
  for (const Body& body : changed_) {
    if (!is_replaced(body)) edits.emplace_back(Replace<Body>{body});
  }
  std::erase_if(changed_, is_replaced);
  const std::vector<Body>& bodies = *began_.frame->bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (is_replaced(bodies[i])) changed_.push_back(body_now(*began_.frame, static_cast<int>(i)));
  }
  return edits;
}

}  // namespace carom
