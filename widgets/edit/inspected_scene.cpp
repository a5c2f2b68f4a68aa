#include <algorithm>
#include <array>
#include <utility>

#include "widgets/edit/field_rows.h"
#include "widgets/edit/inspected.h"
#include "widgets/edit/units.h"

namespace carom {
namespace {

struct Planet {
  const char* name;
  double gravity;  // m/s², downwards
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
    {"pair by pair", "one after the other until none approaches, as in Newton's cradle"},
    {"all at once", "all touching pairs together, with one restitution"},
});

SetForces forces_of(const Scene& scene) {
  return {scene.forces.gravity, scene.forces.linear_drag, scene.forces.quadratic_drag, scene.forces.attraction};
}

// A number that the scene has once. `member` finds it in its forces.
Inspected force_value(const SetForces& forces, const QString& name, const QString& meaning, const Range& range,
                      double& (*member)(SetForces&)) {
  SetForces now = forces;
  Inspected value;
  value.name = name;
  value.meaning = meaning;
  value.range = range;
  value.values = {member(now)};
  value.edits = [forces, member](const std::vector<double>& values) {
    SetForces changed = forces;
    member(changed) = values[0];
    return SceneEdits{changed};
  };
  value.undo_name = [name, range](const std::vector<double>& from, const std::vector<double>& to) {
    return name + " " + change_text(from[0], to[0], range.unit);
  };
  return value;
}

InspectedRow gravity_row(const SetForces& forces) {
  Inspected x = force_value(forces, "Gravity x", "acceleration of every moving body to the right", kGravity,
                            [](SetForces& f) -> double& { return f.gravity.x(); });
  Inspected y = force_value(forces, "Gravity y", "acceleration of every moving body upwards", kGravity,
                            [](SetForces& f) -> double& { return f.gravity.y(); });
  x.label = "x";
  y.label = "y";
  return {.section = "Forces", .label = "Gravity", .values = {std::move(x), std::move(y)}};
}

InspectedRow planet_row(const SetForces& forces) {
  InspectedChoice choice;
  choice.name = "Gravity of";
  choice.meaning = "Gravity downwards";
  choice.other = "another";
  for (const Planet& planet : kPlanets) {
    if (forces.gravity == Vec2(0.0, -planet.gravity)) choice.chosen = static_cast<int>(choice.words.size());
    choice.words << QString::fromUtf8(planet.name) +
                        (planet.gravity == 0.0 ? QString() : " " + field_text(planet.gravity, kGravity.unit));
  }
  choice.edits = [forces](int index) {
    const Planet& planet = kPlanets[static_cast<std::size_t>(index)];
    SetForces changed = forces;
    changed.gravity = Vec2(0.0, planet.gravity == 0.0 ? 0.0 : -planet.gravity);
    const QString change = change_text(forces.gravity.norm(), planet.gravity, kGravity.unit);
    return NamedEdits{{changed}, "Gravity " + change};
  };
  return {.section = "Forces", .label = "as on", .choice = choice};
}

void add_attraction(std::vector<InspectedRow>& shown, const SetForces& forces) {
  InspectedChoice choice;
  choice.name = "Attraction";
  choice.meaning = "Between every two bodies that move, as of planets";
  choice.words = QStringList{"none", "between all"};
  choice.chosen = forces.attraction ? 1 : 0;
  choice.edits = [forces](int index) {
    SetForces changed = forces;
    changed.attraction.reset();
    if (index == 1) changed.attraction.emplace();
    return NamedEdits{{changed}, index == 1 ? "Add attraction" : "Remove attraction"};
  };
  shown.push_back({.section = "Forces", .label = "Attraction", .choice = choice});
  if (!forces.attraction) return;
  const std::vector<FieldRow> rows = field_rows(*forces.attraction);
  shown.push_back({.section = "Forces",
                   .label = "G",
                   .values = {force_value(forces, "G", "constant of attraction", rows[0].range,
                                          [](SetForces& f) -> double& { return f.attraction->constant; })}});
  shown.push_back({.section = "Forces",
                   .label = "Softening",
                   .values = {force_value(forces, "Softening", rows[1].meaning, rows[1].range,
                                          [](SetForces& f) -> double& { return f.attraction->softening; })}});
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
  const SetForces forces = forces_of(scene);
  std::vector<InspectedRow> shown{gravity_row(forces), planet_row(forces)};
  shown.push_back(
      {.section = "Forces",
       .label = "Linear drag",
       .values = {force_value(forces, "Linear drag", "force against the motion, over speed", kLinearDrag,
                              [](SetForces& f) -> double& { return f.linear_drag; })}});
  shown.push_back(
      {.section = "Forces",
       .label = "Square drag",
       .values = {force_value(forces, "Quadratic drag", "force against the motion, over speed squared",
                              kQuadraticDrag, [](SetForces& f) -> double& { return f.quadratic_drag; })}});
  add_attraction(shown, forces);
  const SetLaws laws{scene.impact_law, scene.several_impacts};
  shown.push_back(law_row(kImpactLaws, "Law", "Impact law", laws, &SetLaws::impact_law));
  shown.push_back(law_row(kSeveralImpacts, "Several", "Several impacts", laws, &SetLaws::several_impacts));
  return shown;
}

}  // namespace carom
