#pragma once

#include <array>
#include <string_view>

#include "physics/preset/preset.h"
#include "physics/scene/named.h"

// The words of a preset file that stand for a choice, beside those of a scene.
namespace carom {

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

inline constexpr auto kPlotNames = std::to_array<std::string_view>(
    {"energy", "momentum", "impulse", "ledger", "drift", "momentum_drift", "error", "speeds", "impulses"});

inline constexpr auto kSceneToolNames = std::to_array<Named<SceneTool>>({
    {SceneTool::kSelect, "select"},
    {SceneTool::kDisc, "disc"},
    {SceneTool::kBox, "box"},
    {SceneTool::kPolygon, "polygon"},
    {SceneTool::kWall, "wall"},
    {SceneTool::kRod, "rod"},
    {SceneTool::kString, "string"},
    {SceneTool::kSpring, "spring"},
    {SceneTool::kPin, "pin"},
    {SceneTool::kWeld, "weld"},
    {SceneTool::kForce, "force"},
    {SceneTool::kDrive, "drive"},
});

}  // namespace carom
