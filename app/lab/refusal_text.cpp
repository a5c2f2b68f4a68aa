#include "app/lab/refusal_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <optional>

#include "physics/scene/forces.h"
#include "physics/scene/validate.h"
#include "widgets/edit/inspected_parts.h"

namespace carom {
namespace {

QString text_of(const std::string& text) { return QString::fromStdString(text); }

QString title_of(const Scene& scene, const PartId& part) {
  const auto inspected = inspected_part(scene, part);
  return inspected ? inspected->title : QString();
}

QString name_of_force(const Scene& scene, int place) {
  const ForcePlaces places = written_places(scene.forces);
  for (std::size_t i = 0; i < places.springs.size(); ++i) {
    if (places.springs[i] == place) return title_of(scene, scene.forces.springs[i].id);
  }
  for (std::size_t i = 0; i < places.applied.size(); ++i) {
    if (places.applied[i] == place) return title_of(scene, scene.forces.applied[i].id);
  }
  QString name;
  each_common_force(scene.forces, [&](const CommonForce& force, const auto&...) {
    const auto at = places.common.find(force.type);
    if (at != places.common.end() && at->second == place) name = QString::fromUtf8(force.name);
  });
  return name;
}

// What stands at /list/index of the scene's file; empty if it has no name of its own.
QString name_of_item(const Scene& scene, const QString& list, int index) {
  const auto i = static_cast<std::size_t>(index);
  if (list == "bodies" && i < scene.bodies.size()) return text_of(scene.bodies[i].name);
  if (list == "links" && i < scene.joints.size()) return title_of(scene, scene.joints[i].id);
  if (list == "materials" && i < scene.materials.size()) return text_of(scene.materials[i].name);
  return list == "forces" ? name_of_force(scene, index) : QString();
}

// "shape/radius" is "radius", "position/1" is "position y".
QString words_of(QStringList keys) {
  QStringList words;
  for (const QString& key : keys) {
    bool is_number = false;
    const int number = key.toInt(&is_number);
    if (key == "shape" || key.isEmpty()) continue;
    const bool of_point = is_number && &key == &keys.back() && number < 2;
    words << (of_point ? (number == 0 ? "x" : "y") : is_number ? QString::number(number + 1) : key);
  }
  return words.join(' ').replace('_', ' ');
}

QString with_few_digits(const QString& text) {
  static const QRegularExpression kLong(R"((?<![\w.])-?\d+\.\d+(?:e[+-]?\d+)?)");
  QString shown;
  qsizetype done = 0;
  auto matches = kLong.globalMatch(text);
  while (matches.hasNext()) {
    const QRegularExpressionMatch match = matches.next();
    shown +=
        text.mid(done, match.capturedStart() - done) + QString::number(match.captured().toDouble(), 'g', 6);
    done = match.capturedEnd();
  }
  return shown + text.mid(done);
}

// Not in names, which are quoted.
QString readable(const QString& sentence) {
  QStringList parts = sentence.split('"');
  for (qsizetype i = 0; i < parts.size(); i += 2) parts[i] = with_few_digits(parts[i]);
  return parts.join('"');
}

// "A and B", or "A and the plane".
QString ends_of(const Joint& joint) {
  return QCoreApplication::translate("Refusal", "%1 and %2")
      .arg(text_of(joint.body),
           joint.to.empty() ? QCoreApplication::translate("Refusal", "the plane") : text_of(joint.to));
}

// What the motion at the start would do to a joint, and what to change; empty if the refusal is about another
// thing.
QString motion_text(const Scene& scene, const Joint& joint, const QString& name, const QString& why) {
  static const QRegularExpression kEnds(R"(^a \w+ whose ends (part|close) at ([^ ,;]+) m/s)");
  static const QRegularExpression kTurn(R"(^a weld of bodies that turn against each other at ([^ ,;]+) rad/s)");
  const auto speed = [](const QString& digits) { return QString::number(digits.toDouble(), 'g', 3); };
  QString what;
  if (const auto ends = kEnds.match(why); ends.hasMatch()) {
    what = (ends.captured(1) == "part"
                ? QCoreApplication::translate("Refusal", "their ends would part at %1 m/s")
                : QCoreApplication::translate("Refusal", "their ends would close in at %1 m/s"))
               .arg(speed(ends.captured(2)));
  } else if (const auto turn = kTurn.match(why); turn.hasMatch()) {
    what = QCoreApplication::translate("Refusal", "they would turn against each other at %1 rad/s")
               .arg(speed(turn.captured(1).remove('-')));
  } else {
    return {};
  }
  const bool free_pair = std::any_of(scene.bodies.begin(), scene.bodies.end(), [&joint](const Body& body) {
    return body.name == joint.to && !has_infinite_mass(body);
  });
  const QString advice =
      free_pair ? QCoreApplication::translate("Refusal", "Select both, or change both at once.")
                : QCoreApplication::translate("Refusal", "Give a velocity that it allows, or remove it.");
  return QCoreApplication::translate("Refusal", "%1 joins %2: %3. %4").arg(name, ends_of(joint), what, advice);
}

}  // namespace

QString refusal_text(const std::string& refusal, const Scene& scene) {
  static const QRegularExpression kPlace(R"(^/([^:\s]*): (.*)$)",
                                         QRegularExpression::DotMatchesEverythingOption);
  const QString line = text_of(refusal);
  const QRegularExpressionMatch match = kPlace.match(line);
  if (!match.hasMatch()) return readable(line);
  QStringList keys = match.captured(1).split('/');
  QString name;
  bool is_item = false;
  const int index = keys.size() > 1 ? keys[1].toInt(&is_item) : 0;
  if (is_item) name = name_of_item(scene, keys[0], index);
  if (!name.isEmpty()) keys.remove(0, 2);
  const bool is_link = is_item && match.captured(1).startsWith("links/");
  if (is_link && match.captured(2).startsWith("the link's own body"))
    return QCoreApplication::translate("Refusal", "Both ends of %1 are on %2; it joins two bodies.")
        .arg(name, text_of(scene.joints[static_cast<std::size_t>(index)].body));
  if (is_link && !name.isEmpty()) {
    const Joint& joint = scene.joints[static_cast<std::size_t>(index)];
    if (QString text = motion_text(scene, joint, name, match.captured(2)); !text.isEmpty()) return text;
  }
  if (match.captured(2).startsWith("no mass of a body without an area") && !name.isEmpty())
    return QCoreApplication::translate(
               "Refusal",
               "Without an area %1 has no mass by its density. Give it a mass first, or a size above 0.")
        .arg(name);
  static const QRegularExpression kUnmoved(R"re(^"(.*)", which no force moves)re");
  if (const auto unmoved = kUnmoved.match(match.captured(2)); unmoved.hasMatch() && !name.isEmpty())
    return QCoreApplication::translate("Refusal",
                                       "%1 acts on %2, which would no longer move freely. Remove %1 first.")
        .arg(name, unmoved.captured(1));
  const QString words = words_of(keys);
  const QString subject = name.isEmpty() || words.isEmpty() ? name + words : name + ", " + words;
  return subject.isEmpty() ? readable(match.captured(2)) : subject + ": " + readable(match.captured(2));
}

}  // namespace carom
