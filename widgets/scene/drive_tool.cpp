#include "widgets/scene/drive_tool.h"

#include <algorithm>
#include <numbers>

#include "widgets/edit/driven.h"
#include "widgets/scene/edit_names.h"
#include "widgets/scene/snap.h"

namespace carom {
namespace {

constexpr double kFrequency = 1.0;  // Hz, to and fro

// As it stands in the paused scene; null while a run plays.
const Body* listed(const Frame& frame, const std::string& name) {
  if (!frame.scene) return nullptr;
  const std::vector<Body>& bodies = frame.scene->bodies;
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; });
  return found == bodies.end() ? nullptr : &*found;
}

QString fault_of(const JointSight& sight, const LinkEnd& end) {
  const std::optional<Body> body = body_at_end(*sight.frame, end);
  if (!body) return QStringLiteral("a drive begins on a body");
  const auto* wall = std::get_if<Wall>(&body->shape);
  if (wall != nullptr && !wall->length) return QStringLiteral("a half-plane can only stand still");
  return listed(*sight.frame, end.body) == nullptr ? QStringLiteral("pause the run first") : QString();
}

Vec2 in_steps(const Vec2& line, double step) {
  return snapped(line.norm(), step) * unit_vector(snapped(direction(line), kDirectionStep));
}

}  // namespace

Joined drive(const JointTool& /*tool*/, const JointSight& sight, const LinkEnds& ends) {
  Joined out;
  out.from = place_of(*sight.frame, ends[0]);
  out.to = place_of(*sight.frame, ends[1]);
  out.fault = fault_of(sight, ends[0]);
  if (!out.fault.isEmpty()) return out;
  const bool free = !snaps(sight.mouse);
  Drive drive;
  Vec2 line = out.to - out.from;
  if (sight.mouse.keys.testFlag(Qt::ShiftModifier)) {
    if (!free && !line.isZero(0.0))
      line = drawn_length(line.norm(), sight.mouse) * in_steps(line.normalized(), 1.0);
    drive.amplitude = line;
    drive.angular_frequency = 2.0 * std::numbers::pi * kFrequency;
    out.value =
        QStringLiteral("%1 to and fro, %2 Hz").arg(drawn_text(line.norm(), sight.mouse)).arg(kFrequency);
  } else {
    const double step = step_for_mouse(kSpeedStep, sight.arrow_seconds * sight.mouse.scale);
    drive.velocity = line / sight.arrow_seconds;
    if (!free) drive.velocity = in_steps(drive.velocity, step);
    line = sight.arrow_seconds * drive.velocity;
    out.value = velocity_text(drive.velocity, decimals_of(step) + (free ? 1 : 0), free ? 1 : 0);
  }
  if (line.isZero(0.0)) {
    out.fault = QStringLiteral("pull the arrow out of the body");
    return out;
  }
  out.to = out.from + line;
  out.name = "Drive " + QString::fromStdString(ends[0].body);
  out.edits = {
      Replace<Body>{driven(moved_by_drive(*listed(*sight.frame, ends[0].body), sight.frame->time), drive)}};
  return out;
}

}  // namespace carom
