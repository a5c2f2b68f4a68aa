#pragma once

#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "app/lab/own_theories.h"
#include "physics/compare/reference.h"
#include "physics/preset/preset.h"
#include "widgets/plot/plot_content.h"

namespace carom {

// The methods of a scene's runs, side by side, and their reference.
struct Methods {
  Method own;
  std::vector<Method> others;
  ReferenceId reference = ReferenceId::kNone;
};

// How a start of the runs came about: as opened or saved, or at a moment of the run before, by an edit.
struct StartOrigin {
  std::optional<double> from{};  // s, in the run before
  QString by{};                  // the edit
  bool saved = false;            // else opened
  std::uint64_t scene = 0;       // fingerprint_of_start(), as opened or saved
};

// What a session edits: a preset, and what belongs to its runs but stands in no file.
struct Document {
  Preset preset;
  ReferenceId reference = ReferenceId::kNone;
  std::optional<Methods> before_usual{};  // while Euler, RK4 and the exact run are compared
  // A built-in experiment: the theories on its plots are those of its own start.
  bool is_experiment = false;
  // Its plots as they were before an edit took the theories from them.
  std::vector<Plot> first_theories{};
  // Else: theories that were on its plots when its scene was edited. They stay there.
  std::vector<OwnTheory> own_theories{};
  StartOrigin start{};

  [[nodiscard]] Methods methods() const { return {preset.method, preset.compare, reference}; }
};

// Another value of a member of the preset.
template <auto Member>
struct Set {
  std::remove_cvref_t<decltype(std::declval<Preset>().*Member)> value;
};
using SetScene = Set<&Preset::scene>;
using SetLateBodies = Set<&Preset::edits>;
using SetSaved = Set<&Preset::saved>;
using SetExpectations = Set<&Preset::expect>;
using SetPlots = Set<&Preset::plots>;
using SetStops = Set<&Preset::stops>;
using SetDuration = Set<&Preset::duration>;

struct SetMethods {
  Methods methods;
  std::optional<Methods> before_usual;
};

// Another origin of the start.
struct SetOrigin {
  StartOrigin origin;
};

// Other plots with the theories of the first scene.
struct SetFirstTheories {
  std::vector<Plot> plots;
};

// Other theories of one's own that the document knows.
struct SetOwnTheories {
  std::vector<OwnTheory> theories;
};

// A change of a document as a value: its parts in the order in which they are made.
using DocumentChange =
    std::vector<std::variant<SceneEdits, SetScene, SetLateBodies, SetSaved, SetExpectations, SetPlots, SetStops,
                             SetDuration, SetMethods, SetOrigin, SetFirstTheories, SetOwnTheories>>;

// Makes the change and returns the one that takes it back. Throws std::out_of_range if a part that is edited
// is not there.
DocumentChange apply_change(Document& document, const DocumentChange& change);

// The theories of the document that are not of its scene as it is now.
[[nodiscard]] FirstTheories first_theories_of(const Document& document);

// The change of the start of runs by edits of its scene: what names bodies follows, late bodies too;
// expectations, an experiment's theories and the inner state of a saved run, which are those of another scene,
// go. Bodies of generators
// are listed if one of them is edited. Throws std::out_of_range as apply_change().
[[nodiscard]] DocumentChange change_of_start(const Document& document, const SceneEdits& edits);

// The same where the edited start is this scene, a moment (s) of the document's run. Its clock begins anew
// unless drives or forces depend on it.
[[nodiscard]] DocumentChange change_to_moment(const Document& document, const Scene& now, double time,
                                              const SceneEdits& edits);

// The change where other bodies come in on the way of the document's runs, which is another scene.
[[nodiscard]] DocumentChange change_of_late_bodies(const Document& document, std::vector<RunEdit> late);

// The change to the methods that such a scene allows, where those of the document are not: RK4 instead of exact
// flight, and another reference.
[[nodiscard]] DocumentChange change_of_methods(const Document& document, const Scene& scene);
// The sentence on the methods that such a change sets because the scene does not allow those of the document;
// empty if there are none.
[[nodiscard]] QString said_of_methods(const Document& document, const DocumentChange& change,
                                      const Scene& scene);
// The methods of the document's runs, as many before as after, that such a change will replace, by their runs.
[[nodiscard]] std::vector<std::pair<std::size_t, Method>> methods_changed(const Document& document,
                                                                          const DocumentChange& change);

// A start of a document's runs, to go back to.
struct Start {
  StartOrigin origin;
  Scene scene;
  std::vector<RunEdit> late;
  std::optional<SavedRun> saved;
  std::vector<Expectation> expectations;
  std::vector<Plot> plots;  // with the theories of this start
};
[[nodiscard]] Start start_of(const Document& document);
// The document of a run that goes on from another moment, with this scene and the edits that are left then: its
// plots and stops call bodies as they are called there; those of bodies that are not there, nor come, go.
[[nodiscard]] Preset as_named_in(const Scene& scene, const std::vector<RunEdit>& left, Preset document);
// Whether both begin the same runs.
[[nodiscard]] bool begin_alike(const Start& a, const Start& b);
// The change to another start: methods stay as far as it allows them, and so do plots, but for those of bodies
// that it does not have.
[[nodiscard]] DocumentChange change_to_start(const Document& document, const Start& start);
// An experiment's plots with the theories that the way from this start to the document took from them.
[[nodiscard]] std::vector<Plot> theories_left_at(const Start& start, const Document& document);

// What the start takes over from edits of a running scene that are not about motion: bodies keep the place and
// the motion that they have at the start.
[[nodiscard]] SceneEdits at_the_start(const Preset& preset, const SceneEdits& edits);

// The same from edits of a moment that became a new start: bodies have the places and motions that were edited,
// all others are those of the start. `moment`: the scene as it was edited.
[[nodiscard]] SceneEdits at_the_start(const Preset& preset, const SceneEdits& edits, const Scene& moment);

// Edits of a running scene that were made of an earlier moment of it, as edits of the one with these bodies:
// what they don't change of places and motions is that of now.
[[nodiscard]] SceneEdits moved_to(const std::vector<Body>& now, const SceneEdits& edits, const Scene& moment);

// The edits, with the places and motions that these bodies have.
[[nodiscard]] SceneEdits with_motion_of(const std::vector<Body>& bodies, const SceneEdits& edits);

// The scene at the start of a run, as scene_now() gives it.
[[nodiscard]] std::shared_ptr<const Scene> scene_at_start(const Scene& start);

// The best reference that the scene allows; none where it would be costly.
[[nodiscard]] ReferenceId first_reference(const Preset& preset);

}  // namespace carom
