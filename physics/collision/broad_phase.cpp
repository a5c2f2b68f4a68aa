#include "physics/collision/broad_phase.h"

#include <algorithm>
#include <cstddef>

namespace carom {
namespace {

// Relative to the mean size of moving bodies.
constexpr double kCell = 1.2;
constexpr double kSkin = 0.04;

}  // namespace

void BroadPhase::find_candidates(const std::vector<Bounds>& bounds, const std::vector<std::uint8_t>& fixed) {
  double size = 0.0;
  int moving = 0;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    if (fixed[i] != 0) continue;
    size += (bounds[i].high - bounds[i].low).maxCoeff();
    ++moving;
  }
  const double cell = size > 0.0 ? kCell * size / moving : 1.0;
  if (bounds.size() != skins_.size() || !(cell < 2.0 * cell_ && cell > 0.5 * cell_)) {
    cell_ = cell;
    grid_.reset(static_cast<int>(bounds.size()), cell);
  }
  skins_ = bounds;
  const int n = static_cast<int>(bounds.size());
  for (BodyIndex i{0}; i < n; ++i) {
    if (fixed[i] == 0) {
      skins_[i].low -= kSkin / kCell * cell;
      skins_[i].high += kSkin / kCell * cell;
    }
    grid_.put(i, skins_[i]);
  }
  candidates_.clear();
  const std::size_t most = most_pairs(bounds.size());
  for (BodyIndex a{0}; a < n && candidates_.size() <= most; ++a) {
    near_.clear();
    grid_.each_near(a, [&](BodyIndex b) {
      if (b > a && (fixed[a] == 0 || fixed[b] == 0)) near_.push_back(b);
    });
    std::sort(near_.begin(), near_.end());
    for (const BodyIndex b : near_) candidates_.emplace_back(a, b);
  }
  cut_ = candidates_.size() > most;
  if (cut_) candidates_.resize(most);
}

const std::vector<BodyPair>& BroadPhase::pairs(const std::vector<Bounds>& bounds,
                                               const std::vector<std::uint8_t>& fixed) {
  bool kept = bounds.size() == skins_.size() && fixed == fixed_;
  for (std::size_t i = 0; kept && i < bounds.size(); ++i) kept = skins_[i].contains(bounds[i]);
  if (!kept) {
    find_candidates(bounds, fixed);
    fixed_ = fixed;
  }
  pairs_.clear();
  for (const auto& [a, b] : candidates_) {
    if (bounds[a].overlaps(bounds[b])) pairs_.emplace_back(a, b);
  }
  return pairs_;
}

}  // namespace carom
