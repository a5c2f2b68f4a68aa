#pragma once

#include <array>
#include <string>
#include <string_view>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

// The words of a preset file that stand for a choice, shared by its reader and its writer.
namespace carom {

template <class Id>
struct Named {
  Id id;
  std::string_view name;
};

inline constexpr auto kReductionNames = std::to_array<Named<Expectation::Reduction>>({
    {Expectation::Reduction::kAt, "at"},
    {Expectation::Reduction::kAtImpact, "impact"},
    {Expectation::Reduction::kMaximum, "maximum"},
    {Expectation::Reduction::kMinimum, "minimum"},
    {Expectation::Reduction::kMean, "mean"},
    {Expectation::Reduction::kFinal, "final"},
    {Expectation::Reduction::kCount, "count"},
    {Expectation::Reduction::kFit, "fit"},
});

inline constexpr auto kSweepNames = std::to_array<Named<Sweep::Reduction>>({
    {Sweep::Reduction::kMean, "mean"},
    {Sweep::Reduction::kMaximum, "maximum"},
    {Sweep::Reduction::kMinimum, "minimum"},
    {Sweep::Reduction::kWhereMaximum, "where-maximum"},
    {Sweep::Reduction::kWhereMinimum, "where-minimum"},
    {Sweep::Reduction::kExponent, "exponent"},
});

inline constexpr auto kSpringActsNames = std::to_array<Named<SpringActs>>({
    {SpringActs::kBoth, "both"},
    {SpringActs::kPush, "push"},
    {SpringActs::kPull, "pull"},
    {SpringActs::kWhileShort, "while-short"},
});

inline constexpr auto kImpactLawNames = std::to_array<Named<ImpactLawId>>({
    {ImpactLawId::kEnergetic, "energetic"},
    {ImpactLawId::kNewton, "newton"},
});

inline constexpr auto kSeveralImpactsNames = std::to_array<Named<SeveralImpactsId>>({
    {SeveralImpactsId::kPairwise, "pairwise"},
    {SeveralImpactsId::kSimultaneous, "simultaneous"},
});

inline constexpr auto kJointNames = std::to_array<Named<JointKind>>({
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
  return table.front().name;
}

}  // namespace carom
