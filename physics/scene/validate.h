#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "physics/scene/scene.h"

namespace carom {

// A scene or a preset file that cannot be used: one line that says where (a JSON pointer, a line for syntax),
// what was found and what is allowed.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A text from a file as an error message shows it: on one line, and cut where it is longer than `most` bytes.
[[nodiscard]] std::string shortened(std::string text, std::size_t most = 60);

// Throws the SceneError that refuses a value: where it stands, what was found and what is allowed.
[[noreturn]] void refuse_value(const std::string& place, const std::string& found, const std::string& allowed);

// The bounds that every number of a scene must keep.
inline constexpr double kLargestNumber =
    1e12;  // of any quantity, SI: beyond it sums of squares lose their meaning
inline constexpr double kLeastPositive =
    1e-12;                                   // of a quantity that must be positive: its inverse stays finite
inline constexpr double kLeastStep = 1e-9;   // s
inline constexpr double kLargestStep = 1.0;  // s
inline constexpr double kLeastTolerance = 1e-14;   // m and m/s
inline constexpr double kLargestTolerance = 1e-1;  // m and m/s
inline constexpr int kMostBodies = 100'000;        // of the list and the generators together

// Where the forces of a scene stand in the array /forces of its file: one index for each.
struct ForcePlaces {
  std::optional<int> linear_drag;
  std::optional<int> quadratic_drag;
  std::vector<int> springs;
  std::optional<int> attraction;
  std::vector<int> applied;
};

// The places that forces have in a file that Carom writes: the drags, springs, attraction, applied forces.
[[nodiscard]] ForcePlaces written_places(const Forces& forces);

// Checks all that a reader cannot see one value at a time: ranges, unique names, references, what is modelled,
// and whether the integrator can run the scene. Throws SceneError with the JSON pointer of the first fault.
void validate(const Scene& scene, const ForcePlaces& places);
void validate(const Scene& scene);
// A method of a scene that is valid.
void validate_method(const std::string& place, const Scene& scene, const Method& method);

}  // namespace carom
