#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace carom {

// A scene or a preset file is invalid. The message is one line: where (a JSON pointer, or a line for syntax),
// what was found and what is allowed.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws the SceneError for a value: its place, what was found and what is allowed.
[[noreturn]] void refuse_value(const std::string& place, const std::string& found, const std::string& allowed);

// Rules that no table of keys and ranges can state: how the parts of a scene must fit together.
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
     "neither fixed nor driven, and not on one body twice."},
    {Rule::kKeysTogether,
     "Some keys exclude others: a fixed body has no velocity, a driven one no mass, a massless one no density; "
     "drag and attraction stand once."},
    {Rule::kShapeOfPolygon, "The vertices of a polygon are those of a convex one, in order."},
    {Rule::kOrderOfNumbers,
     "static_friction is at least kinetic_friction, the largest radius at least the least one, an end no "
     "earlier than its start, the values of some sweeps rise."},
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

// A SceneError for one of these rules.
class RuleError : public SceneError {
 public:
  RuleError(Rule broken, const std::string& line) : SceneError(line), rule(broken) {}
  Rule rule;
};

// Throws the RuleError for a value.
[[noreturn]] void refuse_by(Rule rule, const std::string& place, const std::string& found,
                            const std::string& allowed);

}  // namespace carom
