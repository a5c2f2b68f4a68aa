#include "physics/collision/broad_phase.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

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
  skin_ = kSkin / kCell * cell;
  fixed_ = fixed;
  skins_.resize(bounds.size());
  const int n = static_cast<int>(bounds.size());
  for (BodyIndex i{0}; i < n; ++i) put(i, bounds[i]);
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

void BroadPhase::put(BodyIndex body, const Bounds& bounds) {
  const double skin = fixed_[body] == 0 ? skin_ : 0.0;
  skins_[body] = {bounds.low - skin, bounds.high + skin};
  grid_.put(body, skins_[body]);
}

// False if they would be too many.
bool BroadPhase::find_candidates_of_moved(const std::vector<Bounds>& bounds) {
  has_moved_.assign(bounds.size(), 0);
  for (const BodyIndex i : moved_) {
    has_moved_[i] = 1;
    put(i, bounds[i]);
  }
  of_moved_.clear();
  const std::size_t most = most_pairs(bounds.size());
  for (const BodyIndex a : moved_) {
    if (of_moved_.size() > most) return false;
    grid_.each_near(a, [&](BodyIndex b) {
      const bool is_listed = has_moved_[b] != 0 && b < a;
      if (!is_listed && (fixed_[a] == 0 || fixed_[b] == 0)) of_moved_.emplace_back(std::minmax(a, b));
    });
  }
  std::sort(of_moved_.begin(), of_moved_.end());
  std::erase_if(candidates_,
                [&](const BodyPair& pair) { return (has_moved_[pair.first] | has_moved_[pair.second]) != 0; });
  all_.clear();
  std::merge(candidates_.begin(), candidates_.end(), of_moved_.begin(), of_moved_.end(),
             std::back_inserter(all_));
  candidates_.swap(all_);
  return candidates_.size() <= most;
}

const std::vector<BodyPair>& BroadPhase::pairs(const std::vector<Bounds>& bounds,
                                               const std::vector<std::uint8_t>& fixed) {
  const bool are_same = bounds.size() == skins_.size() && fixed == fixed_;
  moved_.clear();
  for (BodyIndex i{0}; are_same && i < static_cast<int>(bounds.size()); ++i) {
    if (!skins_[i].contains(bounds[i])) moved_.push_back(i);
  }
  const bool are_kept = are_same && moved_.empty();
  const bool move_few = are_same && !cut_ && 2 * moved_.size() <= bounds.size();
  if (!are_kept && !(move_few && find_candidates_of_moved(bounds))) find_candidates(bounds, fixed);
  pairs_.clear();
  for (const auto& [a, b] : candidates_) {
    if (bounds[a].overlaps(bounds[b])) pairs_.emplace_back(a, b);
  }
  return pairs_;
}

}  // namespace carom
