#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>

#include "physics/math/vectors.h"
#include "widgets/edit/field_rows.h"
#include "widgets/edit/inspected.h"
#include "widgets/edit/units.h"

namespace carom {
namespace {

struct Planet {
  const char* name;
  double gravity;  // m/s²
};
constexpr auto kPlanets =
    std::to_array<Planet>({{"Earth", 9.81}, {"Moon", 1.62}, {"Mars", 3.71}, {"none", 0.0}});

struct LawWord {
  const char* word;
  const char* meaning;
};
// In the order of ImpactLawId and of SeveralImpactsId.
constexpr auto kImpactLaws = std::to_array<LawWord>({
    {"energetic", "e says how much energy the normal impulse gives back; friction never gains energy"},
    {"Newton", "e says how fast they part, whatever friction does; it may gain energy, which the run reports"},
});
constexpr auto kSeveralImpacts = std::to_array<LawWord>({
    {"pair by pair", "one after the other, as in Newton's cradle; those that close at one moment at once"},
    {"all at once", "all touching pairs together, with one restitution"},
});

using SetForce = std::function<void(SetForces&, double)>;

// A number of the forces that the scene has once, and how it is set.
Inspected force_value(const SetForces& forces, const QString& name, const QString& meaning, const Range& range,
                      double now, SetForce set) {
  Inspected value;
  value.name = name;
  value.meaning = meaning;
  value.range = range;
  value.values = {now};
  value.edits = [forces, set = std::move(set)](const std::vector<double>& values) {
    SetForces changed = forces;
    set(changed, values[0]);
    return SceneEdits{changed};
  };
  value.undo_name = [name, range](const std::vector<double>& from, const std::vector<double>& to) {
    return name + " " + change_text(from[0], to[0], range.unit);
  };
  return value;
}

constexpr double kDownwards = -std::numbers::pi / 2.0;  // rad

// rad; where there is no gravity, downwards.
double direction_of_gravity(const SetForces& forces) {
  const Vec2& gravity = forces.gravity;
  return gravity.isZero(0.0) ? kDownwards : std::atan2(gravity.y(), gravity.x());
}

// Along the direction that it has.
void set_gravity(SetForces& forces, double size) {
  forces.gravity = size == 0.0 ? Vec2(Vec2::Zero()) : Vec2(size * direction_at(direction_of_gravity(forces)));
}

// A negative size turns the direction round.
InspectedRow gravity_row(const SetForces& forces) {
  Inspected value = force_value(forces, "Gravity",
                                "acceleration of every moving body; a negative one turns its direction round",
                                from_zero("m/s²"), forces.gravity.norm(), set_gravity);
  value.typed_range = any_number("m/s²");
  return {.section = "Forces", .label = "Gravity", .values = {std::move(value)}};
}

InspectedRow direction_row(const SetForces& forces) {
  Inspected value =
      force_value(forces, "Direction of gravity", "counter-clockwise from the right; -90° is downwards",
                  any_number("rad"), direction_of_gravity(forces),
                  [](SetForces& f, double angle) { f.gravity = f.gravity.norm() * direction_at(angle); });
  if (forces.gravity.isZero(0.0))
    value.refusal = "Without gravity there is no direction: its size comes first.";
  return {.section = "Forces", .label = "Direction", .values = {std::move(value)}};
}

InspectedRow planet_row(const SetForces& forces) {
  constexpr double kRounding = 1e-12;  // of a size, from the components in any direction
  InspectedChoice choice;
  choice.name = "Gravity of";
  choice.meaning = "Size of gravity; its direction stays";
  choice.other = "another";
  const double size = forces.gravity.norm();
  for (const Planet& planet : kPlanets) {
    if (std::abs(size - planet.gravity) <= kRounding * planet.gravity)
      choice.chosen = static_cast<int>(choice.words.size());
    choice.words << QString::fromUtf8(planet.name) +
                        (planet.gravity == 0.0 ? QString()
                                               : " " + field_text(planet.gravity, kGravityRange.unit));
  }
  choice.edits = [forces, size](int index) {
    const Planet& planet = kPlanets[static_cast<std::size_t>(index)];
    SetForces changed = forces;
    set_gravity(changed, planet.gravity);
    return NamedEdits{{changed}, "Gravity " + change_text(size, planet.gravity, kGravityRange.unit)};
  };
  return {.section = "Forces", .label = "as on", .choice = choice};
}

// Changes the force of this type, where that is what it is: a coefficient, or an optional with fields.
template <class Value>
void change_common_force(SetForces& forces, const char* type, const auto& change) {
  each_common_force(forces, [&](const CommonForce& force, auto& value, const auto&...) {
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(value)>, Value>) {
      if (force.type == type) change(value);
    }
  });
}

InspectedRow coefficient_row(const SetForces& forces, const CommonForce& force, double value,
                             const Range& range) {
  const auto set = [type = force.type](SetForces& f, double to) {
    change_common_force<double>(f, type, [to](double& coefficient) { coefficient = to; });
  };
  return {.section = "Forces",
          .label = force.name,
          .values = {force_value(forces, force.name, force.meaning, range, value, set)}};
}

// Whether there is the force, and its fields if so.
template <class Value>
void add_optional_force(std::vector<InspectedRow>& shown, const SetForces& forces, const CommonForce& force,
                        const std::optional<Value>& value) {
  using Held = std::optional<Value>;
  InspectedChoice choice;
  choice.name = force.name;
  choice.meaning = force.meaning;
  choice.words = QStringList{"none", "acts"};
  choice.chosen = value ? 1 : 0;
  choice.edits = [forces, force](int index) {
    SetForces changed = forces;
    change_common_force<Held>(changed, force.type, [index](Held& held) {
      held.reset();
      if (index == 1) held.emplace();
    });
    return NamedEdits{{changed}, (index == 1 ? "Add " : "Remove ") + QString(force.name).toLower()};
  };
  shown.push_back({.section = "Forces", .label = force.name, .choice = choice});
  if (!value) return;
  for (const FieldRow& row : field_rows(*value)) {
    const auto set = [type = force.type, place = row.place](SetForces& f, double to) {
      change_common_force<Held>(f, type, [&](Held& held) { held = with_field(*held, place, to); });
    };
    shown.push_back(
        {.section = "Forces",
         .label = row.label,
         .values = {force_value(forces, row.label, row.meaning, row.range, std::get<double>(row.value), set)}});
  }
}

template <std::size_t N, class Id>
InspectedRow law_row(const std::array<LawWord, N>& words, const QString& label, const QString& meaning,
                     const SetLaws& laws, Id SetLaws::*law) {
  InspectedChoice choice;
  choice.name = meaning;
  choice.meaning = meaning;
  for (const LawWord& word : words) {
    choice.words << word.word;
    choice.meanings << word.meaning;
  }
  choice.chosen = static_cast<int>(laws.*law);
  choice.edits = [laws, law, meaning, list = choice.words](int index) {
    SetLaws changed = laws;
    changed.*law = static_cast<Id>(index);
    return NamedEdits{{changed}, meaning + ": " + list[index]};
  };
  return {.section = "Impacts", .label = label, .choice = choice};
}

}  // namespace

std::vector<InspectedRow> inspected_scene(const Scene& scene) {
  const SetForces& forces = scene.forces;
  std::vector<InspectedRow> shown{gravity_row(forces), direction_row(forces), planet_row(forces)};
  each_common_force(forces, [&](const CommonForce& force, const auto& value, const auto&... range) {
    if constexpr (sizeof...(range) > 0) {
      shown.push_back(coefficient_row(forces, force, value, range...));
    } else {
      add_optional_force(shown, forces, force, value);
    }
  });
  const SetLaws laws{scene.impact_law, scene.several_impacts};
  shown.push_back(law_row(kImpactLaws, "Law", "Impact law", laws, &SetLaws::impact_law));
  shown.push_back(law_row(kSeveralImpacts, "Several", "Several impacts", laws, &SetLaws::several_impacts));
  return shown;
}

std::vector<InspectedRow> inspected_duration_and_stops(const DurationAndStops& shown) {
  Inspected duration;
  duration.name = "Duration";
  duration.meaning = "how long a run lasts";
  duration.range = kDuration;
  duration.values = {shown.duration};
  duration.is_duration = true;
  duration.undo_name = [](const std::vector<double>& from, const std::vector<double>& to) {
    return "Duration " + change_text(from[0], to[0], kDuration.unit);
  };
  const QString stops = shown.stops.isEmpty() ? "none" : shown.stops.join('\n');
  const InspectedAction editor{
      .text = "Edit the stops", .meaning = "What a run stops at, in one sentence each", .opens_stops = true};
  return {{.section = "Run", .label = "Duration", .values = {std::move(duration)}},
          {.section = "Run", .label = "Stops", .text = stops},
          {.section = "Run", .actions = {editor}}};
}

}  // namespace carom
