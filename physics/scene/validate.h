#pragma once

#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "physics/scene/limits.h"
#include "physics/scene/method.h"
#include "physics/scene/plain_text.h"
#include "physics/scene/scene.h"

namespace carom {

// A scene or a preset file that cannot be used: one line that says where (a JSON pointer, a line for syntax),
// what was found and what is allowed.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws the SceneError that refuses a value: where it stands, what was found and what is allowed.
[[noreturn]] void refuse_value(const std::string& place, const std::string& found, const std::string& allowed);

// What no table of keys and ranges can say: how parts of a scene must go together.
enum class Rule {
  kOwnNames,
  kReferences,
  kKeysTogether,
  kShapeOfPolygon,
  kOrderOfNumbers,
  kCountInAll,
  kJointedStart,
  kModelled,
  kClosedForm,
  kPlaces,
  kSavedRun
};

struct RuleText {
  Rule rule;
  std::string_view text;
};
inline constexpr auto kRules = std::to_array<RuleText>({
    {Rule::kOwnNames,
     "Names of materials, bodies, springs and links stand once; so does each pair of materials."},
    {Rule::kReferences,
     "Names of bodies and materials are those of the file; links, springs and forces act on bodies that are "
     "neither fixed nor driven, and not on one body twice; an impact is of two bodies."},
    {Rule::kKeysTogether,
     "Some keys exclude others: a fixed body has no velocity, a driven one no mass, a massless one no density; "
     "each type of force on all bodies stands once."},
    {Rule::kShapeOfPolygon, "The vertices of a polygon are those of a convex one, in order."},
    {Rule::kOrderOfNumbers,
     "static_friction is at least kinetic_friction, the largest radius at least the least one, an end no "
     "earlier than its start, the values of some sweeps and the times of added bodies rise."},
    {Rule::kCountInAll,
     "Bodies of the list and of all generators together, and curves of all plots together, are limited."},
    {Rule::kJointedStart, "Bodies start where their links hold them and move as their links let them."},
    {Rule::kModelled,
     "The integrator can run the scene, and simultaneous impacts know no links or surfaces that stick."},
    {Rule::kClosedForm, "A closed form is an expression that can be computed."},
    {Rule::kPlaces,
     "A setting or a sweep names the place of a number of the file, and the scene allows its values."},
    {Rule::kSavedRun, "The state of a saved run is one that Carom wrote, of this scene."},
});

// A SceneError of one of these rules.
class RuleError : public SceneError {
 public:
  RuleError(Rule broken, const std::string& line) : SceneError(line), rule(broken) {}
  Rule rule;
};

// Throws the RuleError that refuses a value.
[[noreturn]] void refuse_by(Rule rule, const std::string& place, const std::string& found,
                            const std::string& allowed);

// Where the forces of a scene stand in the array /forces of its file: one index for each.
struct ForcePlaces {
  std::map<std::string, int> common;  // by type
  std::vector<int> springs;
  std::vector<int> applied;
};

// The places in a file that Carom writes: first the forces that a scene has once, then springs, applied forces.
[[nodiscard]] ForcePlaces written_places(const Forces& forces);

// How a run of the scene begins.
struct RunBegin {
  double time = 0.0;  // s; joints must fit the positions of the drives at this time
  // The run continues from a saved state. Its joints are accepted as they are: a slack string may be too long
  // after a push, and any number of bodies may have stuck together.
  bool goes_on = false;
};

// Checks ranges, unique names, references, and whether the scene can be modelled. Throws SceneError with the
// JSON pointer of the first fault; without `places` the pointers are those of written_places().
void validate(const Scene& scene, const ForcePlaces& places, const RunBegin& begin = {});
void validate(const Scene& scene);
// Checks whether a method's integrator can run a valid scene. Throws SceneError.
void check_integrator(const std::string& place, const Scene& scene, const Method& method);

}  // namespace carom
