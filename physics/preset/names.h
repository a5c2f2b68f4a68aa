#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

// The words of a preset file that stand for a choice, shared by its reader and its writer.
namespace carom {

inline constexpr auto kReductionNames = std::to_array<std::pair<Expectation::Reduction, std::string_view>>({
    {Expectation::Reduction::kAt, "at"},
    {Expectation::Reduction::kAtImpact, "impact"},
    {Expectation::Reduction::kMaximum, "maximum"},
    {Expectation::Reduction::kMinimum, "minimum"},
    {Expectation::Reduction::kMean, "mean"},
    {Expectation::Reduction::kFinal, "final"},
    {Expectation::Reduction::kCount, "count"},
    {Expectation::Reduction::kFit, "fit"},
});

inline constexpr auto kSweepNames = std::to_array<std::pair<Sweep::Reduction, std::string_view>>({
    {Sweep::Reduction::kMean, "mean"},
    {Sweep::Reduction::kMaximum, "maximum"},
    {Sweep::Reduction::kMinimum, "minimum"},
    {Sweep::Reduction::kWhereMaximum, "where-maximum"},
    {Sweep::Reduction::kWhereMinimum, "where-minimum"},
    {Sweep::Reduction::kExponent, "exponent"},
});

inline constexpr auto kSpringActsNames = std::to_array<std::pair<SpringActs, std::string_view>>({
    {SpringActs::kBoth, "both"},
    {SpringActs::kPush, "push"},
    {SpringActs::kPull, "pull"},
    {SpringActs::kWhileShort, "while-short"},
});

inline constexpr auto kImpactLawNames = std::to_array<std::pair<ImpactLawId, std::string_view>>({
    {ImpactLawId::kEnergetic, "energetic"},
    {ImpactLawId::kNewton, "newton"},
});

inline constexpr auto kSeveralImpactsNames = std::to_array<std::pair<SeveralImpactsId, std::string_view>>({
    {SeveralImpactsId::kPairwise, "pairwise"},
    {SeveralImpactsId::kSimultaneous, "simultaneous"},
});

inline constexpr auto kJointNames = std::to_array<std::pair<JointKind, std::string_view>>({
    {JointKind::kRod, "rod"},
    {JointKind::kString, "string"},
    {JointKind::kPin, "pin"},
    {JointKind::kWeld, "weld"},
});

inline constexpr auto kPlotNames = std::to_array<std::string_view>(
    {"energy", "momentum", "impulse", "ledger", "drift", "momentum_drift", "error", "speeds", "impulses"});

// The word for `id`; the tables contain every id.
template <class Table, class Id>
[[nodiscard]] constexpr std::string_view name_of(const Table& table, Id id) {
  for (const auto& [known, name] : table) {
    if (known == id) return name;
  }
  return table.front().second;
}

}  // namespace carom
