#pragma once

#include <QStringList>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "physics/scene/edit.h"
#include "physics/scene/limits.h"
#include "physics/scene/part_id.h"
#include "physics/scene/scene.h"
#include "widgets/edit/field_rows.h"
#include "widgets/edit/quantity.h"
#include "widgets/edit/reshaping.h"

// What the inspector shows of a scene, and which edits its fields make; no widgets.
namespace carom {

// Edits with their name in the undo stack.
struct NamedEdits {
  SceneEdits edits;
  QString name;
};

// A value that can be typed. Of several bodies it has one for each.
struct Inspected {
  QString label;    // of its own in its row: "x"; empty: the row's label is its
  QString name;     // in sentences: "Position x", "e"
  QString subject;  // whose it is, if the selection doesn't say so: "wood"
  QString meaning;  // for tooltips
  Range range;
  std::vector<double> values;                 // SI
  std::vector<FormulaNames> formula_names{};  // that a formula knows for each value, or none
  QString unset;             // what a field reads, in grey, whose value is not given; `values` hold meanwhile
  bool is_duration = false;  // of a run: it is no part of the scene, and has no edits
  // The edits that give the parts these values, in the same order.
  std::function<SceneEdits(const std::vector<double>&)> edits;
  // What an edit from the first to the second values is called in the undo stack.
  std::function<QString(const std::vector<double>&, const std::vector<double>&)> undo_name;
  // What an empty field does; without it a value must be typed.
  std::optional<NamedEdits> emptied{};
  QString refusal{};          // why no value can be typed now, in one sentence
  bool is_of_motion = false;  // a place, an angle, a velocity or a spin, which change while a run plays
  // What else than the range forbids these values, in one sentence; empty: nothing.
  std::function<QString(const std::vector<double>&)> fault{};
  std::optional<Range> typed_range{};  // of what is typed, where that may be more than steps and sliders reach
};

// One of several words.
struct InspectedChoice {
  QString name;     // as in sentences
  QString meaning;  // for the tooltip
  QStringList words;
  QStringList meanings;  // of the words; may be fewer
  int chosen = -1;
  QString other;  // what it reads if no word is chosen
  std::function<NamedEdits(int)> edits;
  bool side_by_side = false;  // all words are seen
  QString refusal{};          // why no other word can be chosen, in one sentence
  QString remark{};           // after the word, in grey
  bool is_keeps = false;      // what bodies keep that get another size; no edit
};

// The name of a part that may have one.
struct InspectedName {
  QString name;  // of the field
  QString of;    // what must have a name, in its sentence: "A surface"; empty: there need be none
  QString text;
  QString unset;  // what an empty field reads, in grey
  std::function<NamedEdits(const QString&)> edits;
};

// A button.
struct InspectedAction {
  QString text{};
  QString name{};  // for readers, if the text says too little
  QString meaning{};
  NamedEdits edits{};
  QString refusal{};               // why it can't be, in one sentence
  std::optional<PartId> opens{};   // shows this part; no edit
  std::optional<QString> folds{};  // shows or hides the list of this name; no edit
  bool opens_stops = false;        // shows the editor of the stops; no edit
};

// One line: a label and one value, or the two components of a vector, perhaps with small buttons; or else a
// choice, a name, buttons, or a text that only informs.
struct InspectedRow {
  QString section{};
  QString label{};
  std::vector<Inspected> values{};
  std::optional<InspectedChoice> choice{};
  std::optional<InspectedName> named{};
  std::vector<InspectedAction> actions{};
  QString text{};
  QString tip{};  // of the text
};

// The bodies of these names, in the scene's order; those of generators last.
[[nodiscard]] std::vector<Body> bodies_named(const Scene& scene, const std::vector<std::string>& names);

// Whether these bodies move.
[[nodiscard]] InspectedRow inspected_kind(const std::vector<Body>& bodies);

// The values that all of these bodies have and lessons change, and their other ones.
[[nodiscard]] std::vector<InspectedRow> inspected_bodies(const std::vector<Body>& bodies,
                                                         Keeps keeps = Keeps::kDensity);
[[nodiscard]] std::vector<InspectedRow> more_of_bodies(const std::vector<Body>& bodies,
                                                       Keeps keeps = Keeps::kDensity);

// Those of each shape of a compound, and its surface; the first ones of many. An edit leaves the others where
// they are. For `unfolded` see inspected_corners.h.
[[nodiscard]] std::vector<InspectedRow> inspected_shapes(const Scene& scene, const Body& body,
                                                         const std::set<QString>& unfolded,
                                                         Keeps keeps = Keeps::kDensity);

// The value of one body at one place; none if it has none, as the mass of a fixed one.
[[nodiscard]] std::optional<Inspected> inspected_value(const Body& body, const FieldPlace& place);

[[nodiscard]] NamedEdits renaming(const Body& body, const QString& name);

// The surface of these bodies, with its e if they share one.
[[nodiscard]] std::vector<InspectedRow> inspected_surface(const Scene& scene, const std::vector<Body>& bodies);
// Of a surface that they share: its friction, and how they part from the others that have it.
[[nodiscard]] std::vector<InspectedRow> more_of_surface(const Scene& scene, const std::vector<Body>& bodies);

// e of the body's surface.
[[nodiscard]] Inspected inspected_restitution(const Scene& scene, const Body& body);

// The forces that a scene has once, and the laws of impacts.
[[nodiscard]] std::vector<InspectedRow> inspected_scene(const Scene& scene);

// What a document says of its runs beside the scene.
struct DurationAndStops {
  double duration = 0.0;  // s
  QStringList stops{};    // their sentences

  bool operator==(const DurationAndStops&) const = default;
};
[[nodiscard]] std::vector<InspectedRow> inspected_duration_and_stops(const DurationAndStops& shown);

// The first of "stem 2", "stem 3", ... that is no surface's name.
[[nodiscard]] std::string free_surface_name(const Scene& scene, const std::string& stem);

// The surfaces and the pairs of them with a law of their own.
[[nodiscard]] std::vector<InspectedRow> inspected_surfaces(const Scene& scene);

// "light", or "3 bodies".
[[nodiscard]] QString subject_of(const std::vector<Body>& bodies);

// The edits that change these bodies.
[[nodiscard]] SceneEdits edits_of(std::vector<Body> bodies, const std::function<void(Body&)>& change);

// "p 2.00 kg m/s", "K 2.00 J": the momentum, kinetic energy and angular momentum about the origin of the bodies
// that move; if they are several also their mass, the place of their centre of mass and its velocity, else the
// inertia. Empty if none moves.
[[nodiscard]] QStringList derived_texts(const std::vector<Body>& bodies);
// The formulas of these, a line each.
[[nodiscard]] QString derived_formulas(bool several);

}  // namespace carom
