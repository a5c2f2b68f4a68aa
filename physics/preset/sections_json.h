#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "physics/dynamics/integrators/method_fields.h"
#include "physics/preset/names.h"
#include "physics/preset/preset.h"
#include "physics/preset/value_reader.h"
#include "physics/scene/validate.h"

// The parts of a preset file and what they stand for.
namespace carom {

// Moments of a run, and where a saved one goes on.
inline constexpr Range kMomentOfRun = from_zero("s");
// What stands at a place of the file in another run, by a setting or a sweep.
inline constexpr Range kSetNumber = any_number("");

// The types of the forces that a scene has lists of.
inline constexpr std::string_view kSpringType = "spring";
inline constexpr std::string_view kAppliedForceType = "force";

// What is said of an experiment as a whole, before its parts.
template <class V>
void head_fields(V& v, Is<Preset> auto& preset) {
  v.required({"title", "a few words"}, preset.title, kWords);
  v.field({"about", "what the experiment is, a paragraph"}, preset.about, kText);
  v.field({"observe", "what to look at, a few words"}, preset.observe, kText);
  v.field({"duration", "how long a run lasts"}, preset.duration, kDuration);
  v.field({"gravity", "on every body that moves, [x, y]"}, preset.scene.forces.gravity, kGravityRange);
}

// The laws of a scene's impacts: of a Scene, or of an edit that sets them.
template <class V>
void law_fields(V& v, auto& laws) {
  v.choice({"impact_law", "of impacts off the line of centres"}, kImpactLawNames, laws.impact_law);
  v.choice({"several_impacts", "of bodies that touch several others"}, kSeveralImpactsNames,
           laws.several_impacts);
}

template <class V>
void fields(V& v, Is<View> auto& view) {
  v.field({"center", "[x, y]"}, view.center, any_number("m"));
  v.required({"width", "of the box that is shown"}, view.width, positive("m"));
  v.field({"height", "of the box; without it five eighths of the width"}, view.height, positive("m"));
}

// What the window begins with, beside its plots.
template <class V>
void window_fields(V& v, Is<Preset> auto& preset) {
  v.object({"view", "what the window shows at first"}, preset.view);
  v.choice({"tool", "that the mouse has in hand at first"}, kSceneToolNames, preset.tool);
}

// A body that comes in during a run, as a file states it: in a preset an edit of its runs.
struct LateBody {
  double time = 0.0;  // s
  Body body;
};

template <class V>
void fields(V& v, Is<LateBody> auto& late) {
  v.required({"time", "when it comes in"}, late.time, kMomentOfRun);
  v.required_object({"body", "as it is then, with the keys of a body"}, late.body);
}

// The types of forces: those that a scene has once, then those of the lists.
[[nodiscard]] std::vector<std::string> types_of_force();

// One force of the array, of any type; found(type) is called before its other keys.
template <class V>
void force_fields(V& v, Forces& forces, const auto& found) {
  const std::vector<std::string> types = types_of_force();
  v.cases({"type", "the kind of force"}, types, 0, [&](std::size_t kind, V& k) {
    const std::string& type = types[kind];
    found(type);
    each_common_force(forces, [&](const CommonForce& force, auto& value, const auto&... range) {
      if (type != force.type) return;
      if constexpr (sizeof...(range) > 0) {
        k.required({"coefficient", force.meaning}, value, range...);
      } else {
        fields(k, value.emplace());
      }
    });
    if (type == kSpringType) fields(k, forces.springs.emplace_back());
    if (type == kAppliedForceType) fields(k, forces.applied.emplace_back());
  });
}

// What an expectation observes, and what its runs change. The reader and the table of keys say more of each.
inline constexpr Key kObservableKey{"observable", "the name of one"};
inline constexpr Key kObservedBodiesKey{"bodies", "as many as the observable asks for"};
inline constexpr Key kSettingsKey{"with", "numbers of this file by their JSON pointers"};
inline constexpr Key kSweepKey{"over", "one run for each of several values"};

template <class V>
void fields(V& v, Is<Sweep> auto& s) {
  v.required({"place", "the JSON pointer of a number of this file"}, s.place, kWords);
  v.numbers({"values", "an array of numbers"}, s.values, Count{1, kMostSweepValues}, kSetNumber);
  v.cases({"reduction", "what the numbers of the runs are reduced to"}, words_of(kSweepNames),
          index_of(kSweepNames, s.reduction),
          [&](std::size_t i, V& k) { k.chosen(s.reduction, kSweepNames[i].id); });
}

// Whether it looks at the readings from a time on.
[[nodiscard]] constexpr bool looks_over_time(Expectation::Reduction reduction) {
  using Reduction = Expectation::Reduction;
  return reduction != Reduction::kAt && reduction != Reduction::kAtImpact && reduction != Reduction::kFinal;
}

// Which number an expectation looks at.
template <class V>
void reduction_fields(V& v, Is<Expectation> auto& e) {
  using Reduction = Expectation::Reduction;
  v.cases({"reduction", "the number that is looked at"}, words_of(kReductionNames),
          index_of(kReductionNames, e.reduction), [&](std::size_t i, V& k) {
            const Reduction reduction = kReductionNames[i].id;
            k.chosen(e.reduction, reduction);
            if (reduction == Reduction::kAt) k.required({"time", "when"}, e.time, kMomentOfRun);
            if (reduction == Reduction::kAtImpact)
              k.required({"impact", "after which impact: 1, 2, ..."}, e.impact, Whole{1, 1e9});
            if (reduction == Reduction::kCount)
              k.required({"above", "in the observable's unit"}, e.above, any_number(""));
            if (looks_over_time(reduction) && k.shows(e.from != 0.0))
              k.field({"from", "when it begins"}, e.from, kMomentOfRun);
            if (reduction != Reduction::kAt) k.field({"until", "when it ends"}, e.until, kMomentOfRun);
          });
}

// What that number must be.
template <class V>
void value_fields(V& v, Is<Expectation> auto& e) {
  v.required({"value", "in the observable's unit"}, e.value, any_number(""));
  v.required({"tolerance", "in the observable's unit"}, e.tolerance, from_zero(""));
  v.field({"source", "where the value comes from"}, e.source, kText);
}

// This writes, too (see `written_by`).
void read_expectation(FieldReader& r, Expectation& expectation);

// Reads the force that stands at `at`, /forces/`index`, and notes its place.
void read_force(FieldReader& r, const std::string& at, int index, Forces& forces, ForcePlaces& places);

// The array, in the order of written_places(); with `all`, members that hold their default too.
[[nodiscard]] Json forces_json(const Forces& forces, bool all);

// One element of the array; with `all`, members that hold their default too.
[[nodiscard]] Json joint_json(const Joint& joint, bool all);

// A plot of a preset file: the name of a known one, or an object. Bodies are not looked up here.
[[nodiscard]] Plot read_plot(const ValueReader& value);
[[nodiscard]] Json plot_json(const Plot& plot);

// The section "state": the clock and, where there is one, the fingerprint. Throws SceneError.
[[nodiscard]] SavedRun read_clock(const Json& json);

// Reads the checkpoint, of a scene that is valid and that it belongs to (see state_belongs). Throws SceneError
// where it is none of a run of this scene.
void read_checkpoint(const Json& json, Preset& preset);

[[nodiscard]] Json state_json(const SavedRun& saved, const Scene& scene);

}  // namespace carom
