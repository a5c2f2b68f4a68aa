#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "physics/scene/scene.h"
#include "physics/scene/stop.h"

// The words that stand for the choices of a scene in files.
namespace carom {

template <class Id>
struct Named {
  Id id;
  std::string_view name;
};

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

inline constexpr auto kStopNames = std::to_array<Named<StopKind>>({
    {StopKind::kTime, "time"},
    {StopKind::kImpact, "impact"},
    {StopKind::kEveryImpact, "every-impact"},
    {StopKind::kPassing, "passing"},
    {StopKind::kRest, "rest"},
    {StopKind::kKineticEnergy, "kinetic-energy"},
});

inline constexpr auto kStopQuantityNames = std::to_array<Named<StopQuantity>>({
    {StopQuantity::kX, "x"},
    {StopQuantity::kY, "y"},
    {StopQuantity::kAngle, "angle"},
    {StopQuantity::kSpeed, "speed"},
});

inline constexpr auto kPassingWayNames = std::to_array<Named<PassingWay>>({
    {PassingWay::kEither, "either"},
    {PassingWay::kUpwards, "upwards"},
    {PassingWay::kDownwards, "downwards"},
});

// The word for `id`; the tables contain every id.
template <class Table, class Id>
[[nodiscard]] constexpr std::string_view name_of(const Table& table, Id id) {
  for (const auto& [known, name] : table) {
    if (known == id) return name;
  }
  return table.front().name;
}

// The words of a table of ids, or of words.
template <class Table>
[[nodiscard]] std::vector<std::string> words_of(const Table& table) {
  std::vector<std::string> words;
  for (const auto& row : table) {
    if constexpr (requires { row.name; }) {
      words.emplace_back(row.name);
    } else {
      words.emplace_back(row);
    }
  }
  return words;
}

template <class Table, class Id>
[[nodiscard]] std::size_t index_of(const Table& table, Id id) {
  std::size_t i = 0;
  while (i + 1 < table.size() && table[i].id != id) ++i;
  return i;
}

}  // namespace carom
