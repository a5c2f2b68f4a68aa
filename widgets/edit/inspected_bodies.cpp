#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>
#include <unordered_set>

#include "physics/math/vectors.h"
#include "widgets/base/number_text.h"
#include "widgets/base/rounding.h"
#include "widgets/edit/derived_fields.h"
#include "widgets/edit/inspected.h"
#include "widgets/edit/units.h"

namespace carom {
namespace {

using Bodies = std::shared_ptr<const std::vector<Body>>;

// The lines of bodies, in order: first what lessons change, then under kMore the others. Numbers of a body that
// stand in none of them follow after these.
constexpr const char* kMain = "";
constexpr const char* kMore = "More";
constexpr const char* kLengthOfWall = "shape/length";
constexpr double kUsualLength = 1.0;  // m, of a half-plane that becomes a thin wall
struct BodyLine {
  const char* section;
  const char* label;
  const char* key;            // as its fields have it, or of a value that follows from those
  bool vector = false;        // two components in one line
  const char* act = nullptr;  // the verb of an undo name without values, "Move light"
};
constexpr std::array<std::string_view, 6> kMotion = {"position", "angle",     "velocity",
                                                     "speed",    "direction", "spin"};
constexpr auto kBodyLines = std::to_array<BodyLine>({
    {kMain, "Mass", "mass"},
    {kMain, "Radius", "shape/radius"},
    {kMain, "Width", "shape/width"},
    {kMain, "Height", "shape/height"},
    {kMain, "Length", kLengthOfWall},
    {kMain, "Position", "position", true, "Move"},
    {kMain, "Angle", "angle", false, "Turn"},
    {kMain, "Speed", "speed"},
    {kMain, "Direction", "direction"},
    {kMain, "Spin", "spin"},
    {kMain, "Velocity", "drive/velocity", true},
    {kMain, "Amplitude", "drive/amplitude", true},
    {kMain, "Frequency", "drive/frequency"},
    {kMain, "Phase", "drive/phase"},
    {kMore, "Velocity", "velocity", true},
    {kMore, "Density", "density"},
    {kMore, "Rounding", "shape/rounding"},
    {kMore, "ω", "drive/angular_frequency"},
});

// The density that a body has, whichever of mass and density it states; none without an area.
std::optional<double> density_of(const Body& body) {
  const double size = area(body.shape);
  if (size <= 0.0 || std::isinf(size)) return std::nullopt;
  return mass_of(body) / size;
}

// The value of a member as people know it: mass and density are both shown, whichever the body states.
std::optional<double> value_at(const Body& body, const FieldRow& row) {
  const bool mass = row.place.key == "mass";
  if (mass || row.place.key == "density") {
    if (has_infinite_mass(body)) return std::nullopt;
    return mass ? mass_of(body) : density_of(body);
  }
  const auto* number = std::get_if<double>(&row.value);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

Body with_value(Body body, const FieldPlace& place, double value, Keeps keeps) {
  if (set_derived(body, place.key, value)) return body;
  if (place.key.starts_with("shape/")) return resized(body, with_field(body, place, value).shape, keeps);
  if (place.key == "mass") body.density.reset();
  if (place.key == "density") body.mass.reset();
  return with_field(std::move(body), place, value);
}

QString undo_name_of(const char* act, const QString& name, const Bodies& bodies,
                     const std::vector<double>& before, const std::vector<double>& after, const Range& range) {
  const QString subject = subject_of(*bodies);
  if (act != nullptr) return QString::fromUtf8(act) + " " + subject;
  const QString text = name + " of " + subject;
  return before.size() == 1 ? text + " " + change_text(before[0], after[0], range.unit) : text;
}

// What a line of the inspector is called, and the verb of its undo name, if it has one.
struct LineWords {
  QString label;
  const char* act = nullptr;
};

// The value of all bodies at the place; nothing if one has none.
std::optional<Inspected> inspected_at(const LineWords& words, const FieldPlace& place, const Bodies& bodies,
                                      const std::vector<std::vector<FieldRow>>& rows, Keeps keeps) {
  Inspected shown;
  for (std::size_t i = 0; i < bodies->size(); ++i) {
    const auto row =
        std::find_if(rows[i].begin(), rows[i].end(), [&](const FieldRow& r) { return r.place == place; });
    if (row == rows[i].end()) return std::nullopt;
    std::optional<double> value = value_at((*bodies)[i], *row);
    if (!value && place.key == kLengthOfWall) {
      value = kUsualLength;
      shown.unset = "half-plane";
    }
    if (!value) return std::nullopt;
    shown.values.push_back(*value);
    shown.formula_names.push_back(formula_names((*bodies)[i]));
    shown.meaning = row->meaning;
    shown.range = row->range;
  }
  if (place.key == kLengthOfWall) {
    shown.emptied = NamedEdits{edits_of(*bodies, [](Body& body) { body.shape = Wall{}; }),
                               QString("Make %1 a half-plane").arg(subject_of(*bodies))};
  }
  const auto rests = [](const Body& body) { return body.velocity.isZero(0.0); };
  if (place.key == "direction" && std::all_of(bodies->begin(), bodies->end(), rests))
    shown.refusal = "At rest there is no direction: a speed comes first.";
  shown.is_of_motion = std::find(kMotion.begin(), kMotion.end(), place.key) != kMotion.end();
  const QString component = place.part < 0 ? "" : place.part == 0 ? "x" : "y";
  shown.label = component;
  shown.name = words.label + (component.isEmpty() ? "" : " ") + component;
  shown.edits = [bodies, place, keeps](const std::vector<double>& values) {
    SceneEdits edits;
    for (std::size_t i = 0; i < bodies->size(); ++i)
      edits.emplace_back(Replace<Body>{with_value((*bodies)[i], place, values[i], keeps)});
    return edits;
  };
  shown.undo_name = [act = words.act, bodies, name = shown.name, range = shown.range](
                        const std::vector<double>& before, const std::vector<double>& after) {
    return undo_name_of(act, name, bodies, before, after, range);
  };
  return shown;
}

// A row of the inspector with the line's values: one, or two components.
InspectedRow row_of(const char* section, const LineWords& words, const std::vector<FieldPlace>& places,
                    const Bodies& bodies, const std::vector<std::vector<FieldRow>>& rows, Keeps keeps) {
  InspectedRow row{QString::fromUtf8(section), words.label, {}};
  for (const FieldPlace& place : places) {
    if (auto value = inspected_at(words, place, bodies, rows, keeps)) row.values.push_back(*value);
  }
  return row;
}

// Whether the member of a body, not of its shape or its drive, stands in no line.
bool is_other(const FieldPlace& place) {
  return place.part < 0 && place.key.find('/') == std::string::npos &&
         std::none_of(kBodyLines.begin(), kBodyLines.end(),
                      [&place](const BodyLine& line) { return line.key == place.key; });
}

// The rows of one section.
class Lines {
 public:
  Lines(const std::vector<Body>& bodies, std::string_view section, Keeps keeps)
      : bodies_(std::make_shared<const std::vector<Body>>(bodies)), keeps_(keeps) {
    rows_.reserve(bodies.size());
    for (const Body& body : bodies) rows_.push_back(all_rows(body));
    for (const BodyLine& line : kBodyLines) {
      if (line.section != section) continue;
      std::vector<FieldPlace> places{{line.key, line.vector ? 0 : -1}};
      if (line.vector) places.push_back({line.key, 1});
      add(line.section, {QString::fromUtf8(line.label), line.act}, places);
    }
  }
  // What stands in no line.
  void add_others() {
    for (const FieldRow& row : rows_.front()) {
      if (is_other(row.place)) add(kMore, {row.label}, {row.place});
    }
  }
  [[nodiscard]] std::vector<InspectedRow> take() { return std::move(shown_); }

 private:
  void add(const char* section, const LineWords& words, const std::vector<FieldPlace>& places) {
    InspectedRow row = row_of(section, words, places, bodies_, rows_, keeps_);
    if (!row.values.empty()) shown_.push_back(std::move(row));
  }

  Bodies bodies_;
  Keeps keeps_;
  std::vector<std::vector<FieldRow>> rows_;  // of each body
  std::vector<InspectedRow> shown_;
};

// "p 2.00 kg m/s", in one line.
QString fact(const char* symbol, const QString& value, const char* unit) {
  return QString("%1 %2 %3").arg(symbol, value, QString::fromUtf8(unit)).replace(' ', QChar::Nbsp);
}
QString fact(const char* symbol, double value, const char* unit) {
  return fact(symbol, figure(value, 3), unit);
}
QString fact(const char* symbol, const Vec2& value, const char* unit) {
  return fact(symbol, figures(value), unit);
}

// What cancels but for rounding is 0.
class VectorSum {
 public:
  void add(const Vec2& part) {
    sum_ += part;
    sizes_ += part.norm();
  }
  [[nodiscard]] Vec2 value() const {
    return {without_rounding(sum_.x(), sizes_), without_rounding(sum_.y(), sizes_)};
  }

 private:
  Vec2 sum_ = Vec2::Zero();
  double sizes_ = 0.0;
};

InspectedRow keeps_row(Keeps keeps) {
  InspectedChoice choice;
  choice.name = "Resized";
  choice.meaning = "What stays when a body gets another size, by hand or by a typed number";
  choice.words = {"keeps its density", "keeps its mass"};
  choice.meanings = {"the mass follows the area", "the density changes"};
  choice.chosen = static_cast<int>(keeps);
  choice.is_keeps = true;
  return {.section = kMore, .label = "Resized", .choice = choice};
}

constexpr const char* kNoGroup = "none";  // typed: takes bodies out of their groups

InspectedRow group_row(const std::vector<Body>& bodies) {
  const auto same = [&](const Body& body) { return body.group == bodies.front().group; };
  const bool shared = std::all_of(bodies.begin(), bodies.end(), same);
  InspectedName named;
  named.name = "Group";
  named.text = shared ? QString::fromStdString(bodies.front().group) : QString();
  named.unset = shared ? kNoGroup : "several";
  named.edits = [bodies, shared](const QString& typed) {
    const QString group = typed.compare(kNoGroup, Qt::CaseInsensitive) == 0 ? QString() : typed;
    const QString subject = subject_of(bodies);
    return NamedEdits{
        edits_of(bodies, [&](Body& body) { body.group = group.toStdString(); }),
        group.isEmpty()
            ? QString(shared ? "Take %1 out of the group" : "Take %1 out of their groups").arg(subject)
            : QString("Put %1 into group %2").arg(subject, group)};
  };
  return {.section = kMore, .label = "Group", .named = named};
}

}  // namespace

std::vector<Body> bodies_named(const Scene& scene, const std::vector<std::string>& names) {
  const std::unordered_set<std::string> wanted(names.begin(), names.end());
  std::vector<Body> bodies;
  const auto take = [&](const std::vector<Body>& list) {
    std::copy_if(list.begin(), list.end(), std::back_inserter(bodies),
                 [&](const Body& b) { return wanted.contains(b.name); });
  };
  take(scene.bodies);
  if (bodies.size() < wanted.size() && !scene.generators.empty()) {
    bodies.clear();
    take(all_bodies(scene));
  }
  return bodies;
}

QString subject_of(const std::vector<Body>& bodies) {
  if (bodies.size() == 1) return QString::fromStdString(bodies[0].name);
  return QString("%1 bodies").arg(bodies.size());
}

std::vector<InspectedRow> inspected_bodies(const std::vector<Body>& bodies, Keeps keeps) {
  return Lines(bodies, kMain, keeps).take();
}

std::vector<InspectedRow> more_of_bodies(const std::vector<Body>& bodies, Keeps keeps) {
  Lines lines(bodies, kMore, keeps);
  lines.add_others();
  std::vector<InspectedRow> rows = lines.take();
  if (std::none_of(bodies.begin(), bodies.end(), has_infinite_mass)) rows.push_back(keeps_row(keeps));
  rows.push_back(group_row(bodies));
  return rows;
}

std::optional<Inspected> inspected_value(const Body& body, const FieldPlace& place) {
  const auto line = std::find_if(kBodyLines.begin(), kBodyLines.end(),
                                 [&](const BodyLine& each) { return each.key == place.key; });
  if (line == kBodyLines.end()) return std::nullopt;
  return inspected_at({QString::fromUtf8(line->label), line->act}, place,
                      std::make_shared<const std::vector<Body>>(1, body), {all_rows(body)}, Keeps::kDensity);
}

NamedEdits renaming(const Body& body, const QString& name) {
  return {edits_of({body}, [&](Body& renamed) { renamed.name = name.toStdString(); }),
          QString("Rename %1 to %2").arg(QString::fromStdString(body.name), name)};
}

SceneEdits edits_of(std::vector<Body> bodies, const std::function<void(Body&)>& change) {
  SceneEdits edits;
  for (Body& body : bodies) {
    change(body);
    edits.emplace_back(Replace<Body>{std::move(body)});
  }
  return edits;
}

QString derived_formulas(bool several) {
  if (several) {
    return QStringLiteral(
        "m = Σ m\np = |Σ m v|\nK = Σ (½ m v² + ½ I ω²)\n"
        "L = Σ (m (x vy − y vx) + I ω), about the origin\n"
        "centre of mass: Σ m x / m, Σ m y / m\nits velocity: Σ m v / m");
  }
  return QStringLiteral(
      "p = m v\nK = ½ m v² + ½ I ω²\nL = m (x vy − y vx) + I ω, about the origin\n"
      "I = ∫ r² dm, about the centre of mass");
}

QStringList derived_texts(const std::vector<Body>& bodies) {
  int moving = 0;
  double mass = 0.0;
  double energy = 0.0;
  VectorSum momentum;
  VectorSum moment;
  VectorSum angular;  // in its first component
  for (const Body& body : bodies) {
    if (has_infinite_mass(body)) continue;
    const double m = mass_of(body);
    ++moving;
    mass += m;
    momentum.add(m * body.velocity);
    moment.add(m * body.position);
    const double own = inertia_of(body) * body.spin;
    angular.add({m * cross(body.position, body.velocity), 0.0});
    angular.add({own, 0.0});
    energy += 0.5 * m * body.velocity.squaredNorm() + 0.5 * own * body.spin;
  }
  if (moving == 0) return {};
  const Vec2 p = momentum.value();
  QStringList texts;
  if (bodies.size() > 1) texts << fact("m", mass, "kg");
  texts << fact("p", p.norm(), "kg m/s") << fact("K", energy, "J") << fact("L", angular.value().x(), "kg m²/s");
  if (bodies.size() == 1) {
    texts << fact("I", inertia_of(bodies[0]), "kg m²");
  } else {
    texts << fact("centre of mass x, y:", moment.value() / mass, "m") << fact("its velocity:", p / mass, "m/s");
  }
  return texts;
}

}  // namespace carom
