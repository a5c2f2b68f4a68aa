#include "widgets/edit/inspected_parts.h"

#include <algorithm>
#include <array>

#include "physics/math/vectors.h"
#include "physics/scene/edit_rules.h"
#include "widgets/base/number_text.h"
#include "widgets/base/rounding.h"
#include "widgets/edit/derived_fields.h"
#include "widgets/edit/field_rows.h"
#include "widgets/edit/units.h"

namespace carom {
namespace {

constexpr std::size_t kMostListed = 50;

struct PartLine {
  const char* label;
  const char* key;  // as its fields have it, or of a value that follows from those
};
constexpr auto kPartLines = std::to_array<PartLine>({
    {"Point", "point"},
    {"Anchor", "anchor"},
    {"Length", "length"},
    {"Angle", "angle"},
    {"Rest length", "rest_length"},
    {"Stiffness", "stiffness"},
    {"Damping", "damping"},
    {"Size", "size"},
    {"Direction", "direction"},
    {"Force", "force"},
    {"Torque", "torque"},
    {"From", "start"},
    {"Rise", "rise"},
    {"Until", "end"},
});

struct ActsWord {
  SpringActs acts;
  const char* word;
  const char* meaning;
};
constexpr auto kActsWords = std::to_array<ActsWord>({
    {SpringActs::kBoth, "pushes and pulls", "at any length"},
    {SpringActs::kPush, "only pushes", "while it is short and pushes, as a bumper"},
    {SpringActs::kPull, "only pulls", "while it is long and pulls, as a rubber band"},
    {SpringActs::kWhileShort, "only while short", "also where its damper pulls"},
});

QString text_of(const std::string& text) { return QString::fromStdString(text); }

QString kind_of(const Joint& joint) {
  const std::string_view word = name_of(kJointNames, joint.kind);
  return QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()));
}
QString kind_of(const Spring& /*spring*/) { return "spring"; }
QString kind_of(const AppliedForce& /*force*/) { return "force"; }

// Its place, from 1, among those that `is_like` takes.
template <class Part, class IsLike>
int number_of(const std::vector<Part>& list, const Part& part, const IsLike& is_like) {
  int number = 0;
  for (const Part& each : list) {
    number += is_like(each) ? 1 : 0;
    if (each.id == part.id) break;
  }
  return number;
}

QString title_of(const Scene& scene, const Joint& joint) {
  if (!joint.name.empty()) return text_of(joint.name);
  QString kind = kind_of(joint);
  kind[0] = kind[0].toUpper();
  const auto same_kind = [&](const Joint& each) { return each.kind == joint.kind; };
  return QString("%1 %2").arg(kind).arg(number_of(scene.joints, joint, same_kind));
}
QString title_of(const Scene& scene, const Spring& spring) {
  if (!spring.name.empty()) return text_of(spring.name);
  return QString("Spring %1").arg(number_of(scene.forces.springs, spring, [](const Spring&) { return true; }));
}
QString title_of(const Scene& scene, const AppliedForce& force) {
  const auto same_body = [&](const AppliedForce& each) { return each.body == force.body; };
  const int number = number_of(scene.forces.applied, force, same_body);
  return number == 1 ? QString("Force on %1").arg(text_of(force.body))
                     : QString("Force %1 on %2").arg(number).arg(text_of(force.body));
}

QString point_text(const Vec2& point) {
  const double size = point.norm();
  return QString("(%1, %2) m")
      .arg(short_figure(without_rounding(point.x(), size), 3),
           short_figure(without_rounding(point.y(), size), 3));
}
// "A", "A at (0.1, 0) m", "the plane at (0, 2) m".
QString end_text(const std::string& body, const Vec2& point) {
  if (body.empty()) return "the plane at " + point_text(point);
  return text_of(body) + (point.isZero(0.0) ? QString() : " at " + point_text(point));
}
QString ends_of(const Joint& joint) {
  return "from " + end_text(joint.body, joint.point) + " to " + end_text(joint.to, joint.anchor);
}
QString ends_of(const Spring& spring) {
  return "from " + end_text(spring.body, spring.point) + " to " + end_text(spring.to, spring.anchor);
}
QString ends_of(const AppliedForce& force) {
  if (force.point.isZero(0.0)) return "at the centre of " + text_of(force.body);
  return "at " + point_text(force.point) + " of " + text_of(force.body);
}

// What holds while an optional number is not given.
struct Unset {
  double value = 0.0;  // SI
  QString text;
  QString undo_name;  // of taking the number away; "Length of Rod 1 as at the start"
};

// The body called so; the plane if there is none.
Body body_of(const std::vector<Body>& bodies, const std::string& name) {
  const auto found =
      std::find_if(bodies.begin(), bodies.end(), [&](const Body& body) { return body.name == name; });
  return found == bodies.end() ? Body{} : *found;
}

// A joint between its bodies as they stand.
struct Span {
  Body from, to;  // the plane: at its origin
  Vec2 line;      // m, from the other end to that of `from`
};
Span span_of(const Scene& scene, const Joint& joint) {
  const std::vector<Body> bodies = all_bodies(scene);
  Span span{body_of(bodies, joint.body), joint.to.empty() ? Body{} : body_of(bodies, joint.to), {}};
  const auto point_of = [](const Body& body, const Vec2& point) {
    return Vec2(body.position + turned_by(body.angle, point));
  };
  span.line = point_of(span.from, joint.point) - point_of(span.to, joint.anchor);
  return span;
}

// An end at another place: what the other one holds goes with a pin and a weld, and a stated length follows.
SceneEdits with_end(const Scene& scene, const Joint& before, Joint joint) {
  const Span was = span_of(scene, before);
  const Span now = span_of(scene, joint);
  if (joint.kind == JointKind::kPin || joint.kind == JointKind::kWeld) {
    const Vec2 moved = now.line - was.line;  // of one end from the other
    if (joint.point != before.point) {
      joint.anchor += turned_by(-now.to.angle, moved);
    } else {
      joint.point -= turned_by(-now.from.angle, moved);
    }
  } else if (joint.length) {
    const double distance = now.line.norm();
    joint.length = joint.kind == JointKind::kRod ? distance : std::max(*joint.length, distance);
  }
  return {Replace<Joint>{joint}};
}

// A rod of another length, or a string that is too short, takes its body along.
SceneEdits changed_part(const Scene& scene, const Joint& before, const Joint& joint) {
  if (joint.point != before.point || joint.anchor != before.anchor) return with_end(scene, before, joint);
  SceneEdits edits;
  Span span = span_of(scene, joint);
  const double now = span.line.norm();
  const bool moves = joint.length && now > 0.0 && (joint.kind == JointKind::kRod || *joint.length < now);
  if (moves && *joint.length != now) {
    span.from.position += (*joint.length / now - 1.0) * span.line;
    edits.emplace_back(Replace<Body>{span.from});
  }
  edits.emplace_back(Replace<Joint>{joint});
  return edits;
}
template <class Part>
SceneEdits changed_part(const Scene& /*scene*/, const Part& /*before*/, const Part& part) {
  return {Replace<Part>{part}};
}

template <class Part>
Part with_number(Part part, const FieldPlace& place, double value) {
  if constexpr (std::is_same_v<Part, AppliedForce>) {
    if (set_derived(part, place.key, value)) return part;
  }
  return with_field(std::move(part), place, value);
}

Unset unset_of(const Scene& scene, const Joint& joint, const std::string& key) {
  const Span span = span_of(scene, joint);
  const bool is_angle = key == "angle";
  const double value = is_angle ? span.from.angle - span.to.angle : span.line.norm();
  return {value, field_text(value, is_angle ? "rad" : "m"), "as at the start"};
}
Unset unset_of(const Scene& /*scene*/, const Spring& /*spring*/, const std::string& /*key*/) { return {}; }
Unset unset_of(const Scene& /*scene*/, const AppliedForce& force, const std::string& /*key*/) {
  return {force.start + force.rise, "never", "never"};
}

template <class Part>
Inspected part_value(const Scene& scene, const Part& part, const PartLine& line, const FieldRow& row) {
  Inspected value;
  value.label = row.place.part < 0 ? "" : row.place.part == 0 ? "x" : "y";
  value.name = QString::fromUtf8(line.label) + (row.place.part < 0 ? "" : " ") + value.label;
  value.meaning = row.meaning;
  value.range = row.range;
  value.edits = [scene, part, place = row.place](const std::vector<double>& values) {
    return changed_part(scene, part, with_number(part, place, values[0]));
  };
  const QString text = value.name + " of " + title_of(scene, part) + " ";
  value.undo_name = [text, unit = row.range.unit](const std::vector<double>& from,
                                                  const std::vector<double>& to) {
    return text + change_text(from[0], to[0], unit);
  };
  if (const auto* number = std::get_if<double>(&row.value)) value.values = {*number};
  if constexpr (std::is_same_v<Part, AppliedForce>) {
    if (row.place.key == "direction" && part.force.isZero(0.0))
      value.refusal = "Without a force there is no direction: its size comes first.";
  }
  if (const Unset unset = unset_of(scene, part, row.place.key); !unset.text.isEmpty()) {
    value.emptied =
        NamedEdits{{Replace<Part>{with_field(part, row.place, std::monostate{})}}, text + unset.undo_name};
    if (value.values.empty()) {
      value.unset = unset.text;
      value.values = {unset.value};
    }
  }
  return value;
}

template <class Part>
void add_name(InspectedPart& shown, const Part& part) {
  InspectedName named;
  named.name = "Name";
  named.text = text_of(part.name);
  named.unset = shown.title;
  named.edits = [part, title = shown.title](const QString& name) {
    Part renamed = part;
    renamed.name = name.toStdString();
    return NamedEdits{{Replace<Part>{renamed}},
                      name.isEmpty() ? "Name of " + title : "Rename " + title + " to " + name};
  };
  shown.rows.push_back({.label = "Name", .named = named});
}

void add_acts(InspectedPart& shown, const Spring& spring) {
  InspectedChoice choice;
  choice.name = "Acts";
  choice.meaning = "When the spring acts";
  for (const ActsWord& word : kActsWords) {
    if (word.acts == spring.acts) choice.chosen = static_cast<int>(choice.words.size());
    choice.words << word.word;
    choice.meanings << word.meaning;
  }
  choice.edits = [spring, title = shown.title](int index) {
    const ActsWord& word = kActsWords[static_cast<std::size_t>(index)];
    Spring changed = spring;
    changed.acts = word.acts;
    return NamedEdits{{Replace<Spring>{changed}}, title + " " + word.word};
  };
  shown.rows.push_back({.label = "Acts", .choice = choice});
}

template <class Part>
InspectedPart shown_part(const Scene& scene, const Part& part) {
  InspectedPart shown{title_of(scene, part), kind_of(part), {}};
  if constexpr (requires { part.name; }) add_name(shown, part);
  shown.rows.push_back({.label = "Ends", .text = ends_of(part)});
  std::vector<FieldRow> rows = field_rows(part);
  if constexpr (std::is_same_v<Part, AppliedForce>) {
    for (FieldRow& row : derived_rows(part)) rows.push_back(std::move(row));
  }
  for (const PartLine& line : kPartLines) {
    InspectedRow shown_row{.label = QString::fromUtf8(line.label)};
    for (const FieldRow& row : rows) {
      if (row.place.key == line.key) shown_row.values.push_back(part_value(scene, part, line, row));
    }
    if (!shown_row.values.empty()) shown.rows.push_back(std::move(shown_row));
  }
  if constexpr (std::is_same_v<Part, Spring>) add_acts(shown, part);
  if constexpr (std::is_same_v<Part, AppliedForce>) shown.rows.front().label = "Acts";
  return shown;
}

const std::vector<Joint>& list_of(const Scene& scene, Id<Joint> /*id*/) { return scene.joints; }
const std::vector<Spring>& list_of(const Scene& scene, Id<Spring> /*id*/) { return scene.forces.springs; }
const std::vector<AppliedForce>& list_of(const Scene& scene, Id<AppliedForce> /*id*/) {
  return scene.forces.applied;
}

template <class Part>
void list_parts(std::vector<InspectedRow>& shown, const Scene& scene, const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    if (shown.size() == kMostListed) return;
    const QString ends = std::is_same_v<Part, AppliedForce> ? QString() : ", " + ends_of(part);
    InspectedAction action;
    action.text = title_of(scene, part) + ends;
    action.meaning = action.text;
    action.opens = part.id;
    shown.push_back({.section = "Joints, springs and forces", .actions = {action}});
  }
}

}  // namespace

std::optional<InspectedPart> inspected_part(const Scene& scene, const PartId& part) {
  return std::visit(
      [&](const auto id) -> std::optional<InspectedPart> {
        const auto* found = part_of(list_of(scene, id), id);
        if (found == nullptr) return std::nullopt;
        return shown_part(scene, *found);
      },
      part);
}

std::vector<InspectedRow> listed_parts(const Scene& scene) {
  std::vector<InspectedRow> shown;
  list_parts(shown, scene, scene.joints);
  list_parts(shown, scene, scene.forces.springs);
  list_parts(shown, scene, scene.forces.applied);
  const std::size_t all = scene.joints.size() + scene.forces.springs.size() + scene.forces.applied.size();
  if (all > shown.size())
    shown.push_back({.section = shown.front().section,
                     .text = QString("and %1 more").arg(static_cast<qulonglong>(all - shown.size()))});
  return shown;
}

}  // namespace carom
