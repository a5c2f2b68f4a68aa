#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "physics/observe/quantity_name.h"
#include "physics/run/run_setup.h"
#include "physics/scene/method.h"
#include "physics/scene/scene.h"
#include "physics/scene/stop.h"

namespace carom {

// A number that replaces another in the preset file; `place` is its JSON pointer, such as /bodies/0/mass.
struct Setting {
  std::string place;
  double value = 0.0;

  bool operator==(const Setting&) const = default;
};

// One run for each of `values` at `place`; the numbers from these runs are reduced to one.
struct Sweep {
  enum class Reduction {
    kMean,
    kMaximum,
    kMinimum,
    kWhereMaximum,  // the value at `place` that gives the largest number, by the parabola through three
    kWhereMinimum,
    kExponent  // slope of ln(number) over ln(value at `place`)
  };
  std::string place;
  std::vector<double> values;
  Reduction reduction = Reduction::kMean;
};

// A statement that the experiment must fulfil: an observable, reduced to one number, beside theory.
struct Expectation {
  enum class Reduction { kAt, kAtImpact, kMaximum, kMinimum, kMean, kFinal, kCount, kFit };
  std::string observable;           // a name of physics/observe/observables.h
  std::vector<std::string> bodies;  // the bodies it looks at; as many as the observable asks for
  Reduction reduction = Reduction::kFinal;
  double time = 0.0;              // s, for kAt
  int impact = 0;                 // 1, 2, ... for kAtImpact: the value just after the n-th impact
  double above = 0.0;             // for kCount: the share of readings above this
  double from = 0.0;              // s: maximum, minimum, mean, count and fit start here
  std::optional<double> until;    // s: the run's end for this expectation; none: the scene's duration
  std::vector<Setting> settings;  // how its runs differ from the scene
  std::optional<Sweep> over;      // many runs instead of one
  double value = 0.0;             // in the observable's unit
  double tolerance = 0.0;         // same unit, >= 0
  std::string source;             // where the value comes from
};

// A box of the plane that the window shows at first, all of it; without it the scene is fitted.
struct View {
  Vec2 center = Vec2::Zero();      // m
  double width = 0.0;              // m, > 0
  std::optional<double> height{};  // m, > 0; none: five eighths of the width
};

// What the mouse does in the window's scene.
enum class SceneTool {
  kSelect,
  kDisc,
  kBox,
  kPolygon,
  kWall,
  kRod,
  kString,
  kSpring,
  kPin,
  kWeld,
  kForce,
  kDrive
};

// A remark at a point of a plot, in the units of its axes.
struct PlotNote {
  double x = 0.0;
  double y = 0.0;
  std::string text;

  bool operator==(const PlotNote&) const = default;
};

// A plot to open with the scene: one of the named ones, or its own choice of quantities.
struct Plot {
  std::string id;                 // of physics/preset/names.h; empty: the members below define it
  std::string title;              // empty: made of what it shows
  std::vector<QuantityName> y;    // a curve each
  std::optional<QuantityName> x;  // the horizontal axis; none: time
  bool logarithmic = false;       // the axis of y
  std::vector<PlotNote> notes{};

  bool operator==(const Plot&) const = default;
};

// Methods beside the scene's own.
inline constexpr std::size_t kMostCompared = 5;

// An experiment as a document: its physics, how it is computed, and what people read, look at and expect.
struct Preset {
  std::string title;
  std::string about;      // what it is, a paragraph
  std::string observe;    // what to look at
  std::string topic;      // the folder it stands in; not stored in the file
  double duration = 5.0;  // s, > 0: the default length of a run
  Scene scene;
  Method method;
  std::vector<Method> compare;  // other methods to run beside it, at most kMostCompared
  std::vector<RunEdit> edits;   // bodies that come in during a run, an Add<Body> each, in the order of time
  std::vector<Stop> stops;      // where a run stops before its end
  std::vector<Expectation> expect;
  std::vector<Plot> plots;  // to open with; none: the usual ones
  std::optional<View> view;
  SceneTool tool = SceneTool::kSelect;  // that the window has in hand at first, and keeps
  std::optional<SavedRun> saved;
  std::string extra;  // a JSON object kept as it is; empty if there is none
};

// The setup of a run. Impacts of the pairs of bodies that plots name are counted.
[[nodiscard]] RunSetup setup_of(const Preset& preset);
// The body that an edit of a preset's runs adds.
[[nodiscard]] const Body& added_body(const RunEdit& edit);
// All bodies, as they start: those of the scene, then those that come in later.
[[nodiscard]] std::vector<Body> all_bodies(const Preset& preset);

}  // namespace carom
