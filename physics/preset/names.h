#pragma once

#include <array>
#include <string_view>
#include <utility>

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
});

inline constexpr auto kPlotNames = std::to_array<std::string_view>(
    {"energy", "momentum", "impulse", "ledger", "drift", "momentum_drift"});

}  // namespace carom
