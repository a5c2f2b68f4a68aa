#include "widgets/scene/joint_tools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "physics/math/vectors.h"
#include "physics/scene/edit_rules.h"
#include "widgets/scene/drive_tool.h"
#include "widgets/scene/edit_names.h"
#include "widgets/scene/force_tool.h"
#include "widgets/scene/hit.h"
#include "widgets/scene/joined_velocities.h"
#include "widgets/scene/snap.h"

namespace carom {
namespace {

constexpr double kSpringFrequency = 1.0;  // Hz, of the lighter body on a new spring
constexpr double kCentreReach = 12.0;     // px, from the mouse to the centre that it means

bool moves(const std::optional<Body>& body) { return body && !has_infinite_mass(*body); }

double with_one_figure(double value) { return snapped(value, std::pow(10.0, std::floor(std::log10(value)))); }

QString name_of_end(const LinkEnd& end) {
  return end.body.empty() ? QStringLiteral("the plane") : QString::fromStdString(end.body);
}

// That of the shown moment, or else of the start; null without any.
const Scene* scene_of(const Frame& frame) {
  if (frame.scene) return frame.scene.get();
  return frame.setup ? &frame.setup->scene : nullptr;
}

// With the bodies as they are shown, and the joint.
Scene scene_with(const JointSight& sight, const Joint& joint) {
  Scene scene;
  for (int i = 0; i < body_count(*sight.frame); ++i) scene.bodies.push_back(body_now(*sight.frame, i));
  if (const Scene* shown = scene_of(*sight.frame)) scene.joints = shown->joints;
  std::erase_if(scene.joints, [&](const Joint& other) { return sight.instead_of == other.id; });
  scene.joints.push_back(joint);
  return scene;
}

// "Rod 1", "Rod 2", ...: the first name that no joint and no spring has.
std::string free_name(const Frame& frame, const char* noun) {
  std::string stem(noun);
  stem[0] = static_cast<char>(stem[0] - 'a' + 'A');
  const Scene* scene = scene_of(frame);
  if (scene == nullptr) return stem + " 1";
  for (int number = 1;; ++number) {
    std::string name = stem + " " + std::to_string(number);
    const auto has_it = [&](const auto& part) { return part.name == name; };
    if (std::none_of(scene->joints.begin(), scene->joints.end(), has_it) &&
        std::none_of(scene->forces.springs.begin(), scene->forces.springs.end(), has_it)) {
      return name;
    }
  }
}

// A link that is being made: its first end is on a body that moves, unless there is a fault.
struct Link {
  LinkEnds ends;
  std::array<std::optional<Body>, 2> bodies;
  Joined out;

  Link(const JointTool& tool, const JointSight& sight, const LinkEnds& drawn) : ends(drawn) {
    if (!moves(body_at_end(*sight.frame, ends[0]))) std::swap(ends[0], ends[1]);
    bodies = {body_at_end(*sight.frame, ends[0]), body_at_end(*sight.frame, ends[1])};
    out.from = place_of(*sight.frame, drawn[0]);
    out.to = place_of(*sight.frame, drawn[1]);
    const QString noun = QString::fromUtf8(tool.noun);
    out.name = "Add " + noun + " from " + name_of_end(ends[0]) + " to " + name_of_end(ends[1]);
    if (!moves(bodies[0])) {
      out.fault = QStringLiteral("one end must be on a body that moves");
    } else if (ends[0].body == ends[1].body) {
      out.fault = "a " + noun + " joins two bodies, or one to the plane";
    }
  }

  Joined made(const SceneEdit& edit) {
    if (out.fault.isEmpty()) out.edits = {edit};
    return out;
  }
  // A joint: its bodies, and those joined to them, lose what it does not let them do.
  Joined joined(const JointTool& tool, const JointSight& sight, JointKind kind) {
    if (!out.fault.isEmpty()) return out;
    const Joint made = joint(tool, sight, kind);
    const Scene scene = scene_with(sight, made);
    double most = 0.0;  // m/s
    for (const Body& body : as_joined(scene, made)) {
      most = std::max(most, (body.velocity - part_of(scene.bodies, body.id)->velocity).norm());
      out.edits.emplace_back(Replace<Body>{body});
    }
    out.edits.emplace_back(Add<Joint>{made});
    if (out.edits.size() > 1) {
      out.detail = "velocities change by up to " + fixed_text(most, 2) + " m/s, as it allows no other";
    }
    return out;
  }
  [[nodiscard]] Joint joint(const JointTool& tool, const JointSight& sight, JointKind kind) const {
    Joint joint;
    joint.name = free_name(*sight.frame, tool.noun);
    joint.kind = kind;
    joint.body = ends[0].body;
    joint.point = ends[0].own;
    joint.to = ends[1].body;
    joint.anchor = ends[1].own;
    return joint;
  }
};

// A rod or a string.
Joined distance_link(const JointTool& tool, const JointSight& sight, const LinkEnds& ends, JointKind kind) {
  Link link(tool, sight, ends);
  const Vec2 line = link.out.to - link.out.from;
  link.out.value = line_text(line, sight.mouse);
  if (link.out.fault.isEmpty() && line.isZero(0.0)) {
    link.out.fault = QStringLiteral("its ends are at one place: a pin holds them there");
  }
  return link.joined(tool, sight, kind);
}

// A place of the plane near the line across a body's motion is put on it: there a rod lets the body move on.
LinkEnds across_motion(const JointSight& sight, LinkEnds ends) {
  const std::optional<Body> body = body_at_end(*sight.frame, ends[0]);
  if (!snaps(sight.mouse) || !moves(body) || !ends[1].body.empty()) return ends;
  const Vec2 held = place_of(*sight.frame, ends[0]);
  const Vec2 motion = body->velocity + body->spin * crossed(held - body->position);
  if (motion.isZero(0.0)) return ends;
  const double off = motion.normalized().dot(ends[1].own - held);
  if (std::abs(off) * sight.camera.scale <= kSnapReach) ends[1].own -= off * motion.normalized();
  return ends;
}

Joined rod(const JointTool& tool, const JointSight& sight, const LinkEnds& ends) {
  return distance_link(tool, sight, across_motion(sight, ends), JointKind::kRod);
}

Joined string(const JointTool& tool, const JointSight& sight, const LinkEnds& ends) {
  return distance_link(tool, sight, ends, JointKind::kString);
}

// Of the drawn length, and so stiff that the lighter body would swing on it once a second.
Joined spring(const JointTool& tool, const JointSight& sight, const LinkEnds& ends) {
  Link link(tool, sight, ends);
  const Vec2 line = link.out.to - link.out.from;
  link.out.value = line_text(line, sight.mouse);
  if (link.out.fault.isEmpty() && line.isZero(0.0)) {
    link.out.fault = QStringLiteral("its ends are at one place");
  }
  if (!link.out.fault.isEmpty()) return link.out;
  double mass = mass_of(*link.bodies[0]);
  if (moves(link.bodies[1])) mass = std::min(mass, mass_of(*link.bodies[1]));
  const double omega = 2.0 * std::numbers::pi * kSpringFrequency;
  Spring spring;
  spring.name = free_name(*sight.frame, tool.noun);
  spring.body = link.ends[0].body;
  spring.point = link.ends[0].own;
  spring.to = link.ends[1].body;
  spring.anchor = link.ends[1].own;
  spring.stiffness = with_one_figure(mass * omega * omega);
  spring.rest_length = line.norm();
  return link.made(Add<Spring>{spring});
}

Joined pin(const JointTool& tool, const JointSight& sight, const LinkEnds& ends) {
  Link link(tool, sight, ends);
  if (ends[0].body.empty()) link.out.fault = QStringLiteral("click on a body, or where two overlap");
  link.out.name = QStringLiteral("Add pin");
  link.out.value = place_text(link.out.to, sight.mouse.scale);
  return link.joined(tool, sight, JointKind::kPin);
}

// The point of a body that is near another place: its centre, or of a wall the nearest point.
Vec2 near_point(const Body& body, const Vec2& place) {
  const auto* wall = std::get_if<Wall>(&body.shape);
  if (wall == nullptr) return body.position;
  const Vec2 along = turned_by(body.angle, Vec2::UnitX());
  double share = along.dot(place - body.position);
  if (wall->length) share = std::clamp(share, -0.5 * *wall->length, 0.5 * *wall->length);
  return body.position + share * along;
}

// m from a point of a body to its rim.
double rim(const Body& body, const Vec2& from, const Vec2& along) {
  if (std::holds_alternative<Wall>(body.shape)) return 0.0;
  const auto inside = chord(outline_of(body.shape), turned_by(-body.angle, from - body.position),
                            turned_by(-body.angle, along));
  return inside ? inside->second : 0.0;
}

// The contact of two bodies that touch, else the middle of what lies between them.
Vec2 middle_of(const Body& a, const Body& b) {
  const Vec2 from = near_point(a, b.position);
  const Vec2 to = near_point(b, from);
  const double distance = (to - from).norm();
  if (!(distance > 0.0)) return a.position;
  const Vec2 along = (to - from) / distance;
  return from + 0.5 * (rim(a, from, along) + distance - rim(b, to, -along)) * along;
}

// The same place, held by both bodies.
LinkEnds both_at(const Vec2& place, const Body& a, const std::optional<Body>& b) {
  const auto own = [&](const Body& body) { return turned_by(-body.angle, place - body.position); };
  return {LinkEnd{a.name, own(a)}, b ? LinkEnd{b->name, own(*b)} : LinkEnd{{}, place}};
}

Joined weld(const JointTool& tool, const JointSight& sight, const LinkEnds& ends) {
  const std::optional<Body> a = body_at_end(*sight.frame, ends[0]);
  const std::optional<Body> b = body_at_end(*sight.frame, ends[1]);
  const bool two = a && b && a->name != b->name;
  Link link(tool, sight, two ? both_at(middle_of(*a, *b), *a, b) : ends);
  if (!two) link.out.fault = QStringLiteral("a weld joins two bodies");
  link.out.value = place_text(link.out.to, sight.mouse.scale);
  link.out.from = place_of(*sight.frame, ends[0]);
  link.out.to = place_of(*sight.frame, ends[1]);
  return link.joined(tool, sight, JointKind::kWeld);
}

constexpr std::array<JointTool, 7> kJointTools = {{
    {.tool = SceneTool::kRod, .noun = "rod", .join = rod},
    {.tool = SceneTool::kString, .noun = "string", .join = string},
    {.tool = SceneTool::kSpring, .noun = "spring", .join = spring},
    {.tool = SceneTool::kPin, .noun = "pin", .one_click = true, .join = pin},
    {.tool = SceneTool::kWeld, .noun = "weld", .at_centres = true, .join = weld},
    {.tool = SceneTool::kForce, .noun = "force", .at_centres = true, .to_mouse = true, .join = push},
    {.tool = SceneTool::kDrive, .noun = "drive", .at_centres = true, .to_mouse = true, .join = drive},
}};

// The mouse is so near the centre that it means it, if it snaps.
bool near_centre(const Vec2& centre, const JointSight& sight) {
  const double distance = (sight.mouse.at - centre).norm() * sight.camera.scale;
  return snaps(sight.mouse) && distance <= kCentreReach;
}

LinkEnd end_on(const Body& body, const JointSight& sight, bool at_centre) {
  const Vec2 arm = sight.mouse.at - body.position;
  const bool near = near_centre(body.position, sight);
  return {body.name, at_centre || near ? Vec2(Vec2::Zero()) : turned_by(-body.angle, arm)};
}

LinkEnd end_in_plane(const JointSight& sight) {
  return {{}, drawn_place(sight.mouse.at, sight.mouse, sight.grid)};
}

// A body so small that the mouse is beside it, or else the plane.
LinkEnd end_beside_bodies(const JointSight& sight) {
  std::optional<LinkEnd> found;
  double least = std::numeric_limits<double>::infinity();  // m
  for (int i = 0; i < body_count(*sight.frame); ++i) {
    const Body& body = (*sight.frame->bodies)[static_cast<std::size_t>(i)];
    const Vec2 centre = sight.frame->state.position(i);
    const double distance = (sight.mouse.at - centre).norm();
    if (std::holds_alternative<Wall>(body.shape) || distance >= least || !near_centre(centre, sight)) continue;
    least = distance;
    found = LinkEnd{body.name, Vec2::Zero()};
  }
  return found.value_or(end_in_plane(sight));
}

}  // namespace

const JointTool* joint_tool(SceneTool tool) {
  const auto* found = std::find_if(kJointTools.begin(), kJointTools.end(),
                                   [tool](const JointTool& row) { return row.tool == tool; });
  return found == kJointTools.end() ? nullptr : found;
}

LinkEnd end_at_mouse(const JointTool& tool, const JointSight& sight) {
  const int body = body_at(*sight.frame, sight.camera, sight.camera.to_screen(sight.mouse.at));
  if (body < 0) return end_beside_bodies(sight);
  const Body on = body_now(*sight.frame, body);
  LinkEnd end = end_on(on, sight, tool.at_centres);
  if (!end.own.isZero(0.0) && snaps(sight.mouse))
    end.own = on_rim(on.shape, end.own, kSnapReach / sight.camera.scale).value_or(end.own);
  return end;
}

LinkEnds ends_at_mouse(const JointSight& sight) {
  const Frame& frame = *sight.frame;
  const std::vector<int> under = bodies_at(frame, sight.camera, sight.camera.to_screen(sight.mouse.at));
  if (under.empty()) return {end_in_plane(sight), end_in_plane(sight)};
  const Body top = body_now(frame, under[0]);
  std::optional<Body> below;
  if (under.size() > 1) below = body_now(frame, under[1]);
  LinkEnd end = end_on(top, sight, false);
  if (below && !end.own.isZero(0.0)) {
    const LinkEnd other = end_on(*below, sight, false);
    if (other.own.isZero(0.0)) end = other;
  }
  return both_at(place_of(frame, end), top, below);
}

std::optional<LinkEnds> ends_of(const JointTool& tool, const JointSight& sight,
                                std::span<const std::string> bodies) {
  if (bodies.empty() || bodies.size() > (tool.to_mouse ? 1U : 2U)) return std::nullopt;
  const LinkEnd first{bodies[0], Vec2::Zero()};
  const std::optional<Body> a = body_at_end(*sight.frame, first);
  if (!a) return std::nullopt;
  if (tool.to_mouse) return LinkEnds{first, LinkEnd{{}, usual_tip(sight, *a)}};
  if (bodies.size() == 1) {
    if (tool.one_click) return both_at(a->position, *a, std::nullopt);
    return LinkEnds{first, end_in_plane(sight)};
  }
  const LinkEnd second{bodies[1], Vec2::Zero()};
  const std::optional<Body> b = body_at_end(*sight.frame, second);
  if (!b) return std::nullopt;
  return tool.one_click ? both_at(middle_of(*a, *b), *a, b) : LinkEnds{first, second};
}

std::optional<Body> body_at_end(const Frame& frame, const LinkEnd& end) {
  if (end.body.empty()) return std::nullopt;
  for (int i = 0; i < body_count(frame); ++i) {
    if ((*frame.bodies)[static_cast<std::size_t>(i)].name == end.body) return body_now(frame, i);
  }
  return std::nullopt;
}

Vec2 place_of(const Frame& frame, const LinkEnd& end) {
  const std::optional<Body> body = body_at_end(frame, end);
  return body ? Vec2(body->position + turned_by(body->angle, end.own)) : end.own;
}

}  // namespace carom
