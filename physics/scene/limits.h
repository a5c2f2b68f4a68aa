#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// The bounds that the numbers, texts and lists of a scene keep. The reader of preset files, its description of
// them (physics/preset/preset_json.h) and the validation of scenes all have them from here.
namespace carom {

inline constexpr double kLargestNumber = 1e12;     // SI; sums of squares lose their meaning beyond
inline constexpr double kLeastPositive = 1e-12;    // of a positive quantity; its inverse stays finite
inline constexpr double kLeastStep = 1e-9;         // s
inline constexpr double kLargestStep = 1.0;        // s
inline constexpr double kLeastTolerance = 1e-14;   // m and m/s
inline constexpr double kLargestTolerance = 1e-1;  // m and m/s

// The numbers from `low` to `high`, and with `or_zero` also 0.
struct Range {
  double low = -kLargestNumber;
  double high = kLargestNumber;
  std::string_view unit = "";
  bool or_zero = false;

  [[nodiscard]] constexpr bool contains(double x) const {
    return (x >= low && x <= high) || (or_zero && x == 0.0);
  }
  // For messages: "0, or a number from 1e-12 to 1000000000000 m".
  [[nodiscard]] std::string text() const;
};

[[nodiscard]] constexpr Range any_number(std::string_view unit) { return {.unit = unit}; }
[[nodiscard]] constexpr Range positive(std::string_view unit) { return {.low = kLeastPositive, .unit = unit}; }
[[nodiscard]] constexpr Range from_zero(std::string_view unit) { return {.low = 0.0, .unit = unit}; }

inline constexpr Range kRestitutionRange{.low = 0.0, .high = 1.0};
inline constexpr Range kTangentialRestitution{.low = -1.0, .high = 1.0};
inline constexpr Range kFrictionCoefficient{.low = 0.0, .high = 1e3};  // also of rolling resistance
inline constexpr Range kDiscRadiusRange{.low = kLeastPositive, .unit = "m", .or_zero = true};
inline constexpr Range kDuration = positive("s");  // of a run
inline constexpr Range kStepRange{.low = kLeastStep, .high = kLargestStep, .unit = "s"};
inline constexpr Range kToleranceRange{.low = kLeastTolerance, .high = kLargestTolerance, .unit = "m and m/s"};

inline constexpr int kMostBodies = 100'000;  // of the list and the generators together
inline constexpr std::size_t kMostMaterials = 1'000;
inline constexpr std::size_t kMostMaterialPairs = 100'000;
inline constexpr std::size_t kMostForces = 100'000;
inline constexpr std::size_t kMostJoints = 100'000;
inline constexpr std::size_t kMostPlots = 100;
inline constexpr std::size_t kMostPlotCurves = 100;  // of one plot
inline constexpr std::size_t kMostCurvesInAll = 200;
inline constexpr std::size_t kMostNotes = 1'000;  // of one plot
inline constexpr std::size_t kMostStops = 100;
inline constexpr std::size_t kMostExpectations = 1'000;
inline constexpr std::size_t kMostSettings = 1'000;  // of one expectation
inline constexpr std::size_t kMostSweepValues = 10'000;

// Lengths of texts, in characters of UTF-8.
inline constexpr std::size_t kLongestName = 200;
inline constexpr std::size_t kLongestStem = kLongestName - 7;  // of generated names: up to "-100000" follows
inline constexpr std::size_t kLongestTitle = 1'000;            // also of a closed form
inline constexpr std::size_t kLongestText = 100'000;

}  // namespace carom
