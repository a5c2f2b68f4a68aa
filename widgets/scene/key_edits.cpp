#include "widgets/scene/key_edits.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "physics/scene/edit_rules.h"
#include "physics/scene/scene.h"
#include "widgets/base/method_names.h"
#include "widgets/edit/reshaping.h"
#include "widgets/scene/drag.h"
#include "widgets/scene/edit_names.h"
#include "widgets/scene/snap.h"

namespace carom {
namespace {

constexpr double kTurnStep = 5.0;  // degrees
constexpr double kLargeTurnStep = 45.0;
constexpr double kFaster = 10.0;  // with Shift
constexpr double kLarger = 1.05;

Vec2 arrow_of(int key) {
  switch (key) {
    case Qt::Key_Left:
      return -Vec2::UnitX();
    case Qt::Key_Right:
      return Vec2::UnitX();
    case Qt::Key_Up:
      return Vec2::UnitY();
    case Qt::Key_Down:
      return -Vec2::UnitY();
    default:
      return Vec2::Zero();
  }
}

bool turns_left(int key) {
  return key == Qt::Key_BracketLeft || key == Qt::Key_BraceLeft || key == Qt::Key_Less;
}

// Which of < and > is typed with Shift depends on the keyboard.
bool is_sign(int key) { return key == Qt::Key_Less || key == Qt::Key_Greater; }

// A sum that stays round if it was.
double stepped(double value, double change, double step) {
  const double sum = value + change;
  const double round = snapped(sum, step);
  return std::abs(sum - round) < 1e-9 * step ? round : sum;
}

Vec2 stepped(const Vec2& value, const Vec2& change, double step) {
  return {stepped(value.x(), change.x(), step), stepped(value.y(), change.y(), step)};
}

// "1 rod", "2 strings", "3 links" of several kinds.
QString count_of(const QStringList& kinds) {
  const bool alike = std::all_of(kinds.begin(), kinds.end(), [&](const QString& k) { return k == kinds[0]; });
  const QString kind = alike ? kinds[0] : QStringLiteral("link");
  return QStringLiteral("%1 %2%3").arg(kinds.size()).arg(kind, kinds.size() == 1 ? "" : "s");
}

template <class Part>
Deletion deletion_of(const std::vector<Part>& list, Id<Part> id) {
  const Part* part = part_of(list, id);
  if (part == nullptr) return {};
  return {{Remove<Part>{id}}, "Delete " + name_of_part(*part), {}};
}

}  // namespace

std::optional<KeyEdit> key_edit(int key, Qt::KeyboardModifiers modifiers) {
  const bool ctrl = modifiers.testFlag(Qt::ControlModifier);
  switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      return ctrl ? KeyEdit::kVelocity : KeyEdit::kMove;
    case Qt::Key_BracketLeft:
    case Qt::Key_BracketRight:
    case Qt::Key_BraceLeft:
    case Qt::Key_BraceRight:
    case Qt::Key_Less:
    case Qt::Key_Greater:
      return ctrl ? std::nullopt : std::optional(KeyEdit::kTurn);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
      return ctrl ? std::nullopt : std::optional(KeyEdit::kResize);
    case Qt::Key_0:
      return ctrl ? std::nullopt : std::optional(KeyEdit::kRest);
    case Qt::Key_X:
      return modifiers == Qt::NoModifier ? std::optional(KeyEdit::kReverse) : std::nullopt;
    default:
      return std::nullopt;
  }
}

std::vector<Body> edited_by_key(std::span<const Body> bodies, int key, Qt::KeyboardModifiers modifiers,
                                double step, Keeps keeps) {
  std::vector<Body> after(bodies.begin(), bodies.end());
  const std::optional<KeyEdit> edit = key_edit(key, modifiers);
  if (!edit) return after;
  const bool shift = modifiers.testFlag(Qt::ShiftModifier);
  const double times = shift ? kFaster : 1.0;
  for (Body& body : after) {
    switch (*edit) {
      case KeyEdit::kMove:
        body.position = stepped(body.position, times * step * arrow_of(key), step);
        break;
      case KeyEdit::kVelocity:
        body.velocity = stepped(body.velocity, times * kSpeedStep * arrow_of(key), kSpeedStep);
        break;
      case KeyEdit::kTurn: {
        const double by =
            (turns_left(key) ? 1.0 : -1.0) * (shift && !is_sign(key) ? kLargeTurnStep : kTurnStep);
        body.angle = stepped(body.angle * 180.0 / std::numbers::pi, by, kTurnStep) * std::numbers::pi / 180.0;
        break;
      }
      case KeyEdit::kResize:
        body = resized(body, scaled(body.shape, key == Qt::Key_Minus ? 1.0 / kLarger : kLarger), keeps);
        break;
      case KeyEdit::kRest:
        body.velocity.setZero();
        body.spin = 0.0;
        break;
      case KeyEdit::kReverse:
        body.velocity = -body.velocity;
        body.spin = -body.spin;
        break;
    }
  }
  return after;
}

QString name_of(KeyEdit edit, std::span<const Body> before, std::span<const Body> after) {
  const QString who = name_of_bodies(before);
  switch (edit) {
    case KeyEdit::kMove:
      return "Move " + who;
    case KeyEdit::kVelocity:
      return name_of_velocity(before, after);
    case KeyEdit::kTurn:
      return "Turn " + who;
    case KeyEdit::kResize:
      return "Resize " + who;
    case KeyEdit::kRest:
      return "Bring " + who + " to rest";
    case KeyEdit::kReverse:
      break;
  }
  return "Reverse " + who;
}

QString value_of(KeyEdit edit, const Body& body, double scale) {
  switch (edit) {
    case KeyEdit::kMove:
      return place_text(body.position, scale);
    case KeyEdit::kTurn:
      return angle_text(body.angle);
    case KeyEdit::kResize:
      return size_text(body.shape, {.at = Vec2::Zero(), .scale = scale, .snapping = false});
    default:
      return velocity_text(body.velocity, 2);
  }
}

Deletion deletion(const Scene& scene, std::span<const std::string> names) {
  const auto goes = [&](const std::string& name) {
    return !name.empty() && std::find(names.begin(), names.end(), name) != names.end();
  };
  Deletion out;
  std::vector<Body> bodies;
  for (const Body& body : scene.bodies) {
    if (goes(body.name)) bodies.push_back(body);
  }
  if (bodies.empty()) return out;
  QStringList links;
  for (const Joint& joint : scene.joints) {
    if (joint.id.number == 0 || (!goes(joint.body) && !goes(joint.to))) continue;
    out.edits.emplace_back(Remove<Joint>{joint.id});
    links.push_back(text_of(name_of(kJointNames, joint.kind)));
  }
  for (const Spring& spring : scene.forces.springs) {
    if (!goes(spring.body) && !goes(spring.to)) continue;
    out.edits.emplace_back(Remove<Spring>{spring.id});
    links.push_back(QStringLiteral("spring"));
  }
  for (const AppliedForce& force : scene.forces.applied) {
    if (goes(force.body)) out.edits.emplace_back(Remove<AppliedForce>{force.id});
  }
  for (const Body& body : bodies) out.edits.emplace_back(Remove<Body>{body.id});
  out.name = "Delete " + name_of_bodies(bodies);
  if (links.empty()) return out;
  out.links = count_of(links);
  out.name += " and " + out.links;
  return out;
}

Deletion deletion(const Scene& scene, const PartId& part) {
  if (const auto* joint = std::get_if<Id<Joint>>(&part)) return deletion_of(scene.joints, *joint);
  if (const auto* spring = std::get_if<Id<Spring>>(&part)) return deletion_of(scene.forces.springs, *spring);
  return deletion_of(scene.forces.applied, std::get<Id<AppliedForce>>(part));
}

}  // namespace carom
