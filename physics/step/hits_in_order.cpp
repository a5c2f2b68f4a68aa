#include "physics/step/hits_in_order.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "physics/step/run_clock.h"

namespace carom {
namespace {

// The hits that bodies connect with the last one, taken out of the list.
void take_connected(const World& world, std::vector<Hit>& from, std::size_t begin, std::vector<Hit>& to) {
  to.assign(from.begin() + static_cast<std::ptrdiff_t>(begin), from.end());
  keep_connected(world, to.back().a, to.back().b, to);
  const auto taken = [&](const Hit& hit) {
    return std::any_of(to.begin(), to.end(), [&](const Hit& t) { return ends_of(t) == ends_of(hit); });
  };
  from.erase(std::remove_if(from.begin() + static_cast<std::ptrdiff_t>(begin), from.end(), taken), from.end());
}

constexpr auto is_later = [](const Hit& x, const Hit& y) {
  return x.moment != y.moment ? x.moment > y.moment : ends_of(x) > ends_of(y);
};

// The hits of one moment that bodies connect, at once; false: they are not several, or there is no way.
bool resolve(World& world, ImpactCluster& cluster, const std::vector<Hit>& together, double within, bool all) {
  cluster.clear();
  for (const Hit& hit : together) cluster.add(hit.a, hit.b, hit.contact);
  cluster.drop_doubles(world);
  if (!cluster.has_several(world) || together.size() > kMostTogether) return false;
  if (!cluster.has_law(world)) {
    world.note(&Notices::order_decided_since, world.trajectories.epoch() + within,
               {together.back().a, together.back().b});
    return false;
  }
  return cluster.resolve(world, within, all ? ClusterRestitution::kSmallest : ClusterRestitution::kOwn);
}

}  // namespace

void resolve_in_order(World& world, HitsInOrder& buffers, double h, double within,
                      const std::function<void(const Hit&)>& resolve_alone) {
  const bool all = takes_touches(world);
  const double same = all ? std::numeric_limits<double>::infinity() : kSameMoment * h;
  auto& [hits, together, cluster] = buffers;
  // The first to touch at the back, and of one moment in the order of the bodies: not in that of the list.
  std::sort(hits.begin(), hits.end(), is_later);
  while (!hits.empty()) {
    std::size_t begin = hits.size() - 1;
    while (begin > 0 && hits[begin - 1].moment - hits.back().moment <= same) --begin;
    // Most are alone.
    if (begin + 1 == hits.size()) {
      const Hit only = hits.back();
      hits.pop_back();
      resolve_alone(only);
      continue;
    }
    while (hits.size() > begin) {
      take_connected(world, hits, begin, together);
      if (resolve(world, cluster, together, within, all)) continue;
      const ImpactCluster::Touch* only = cluster.only_one_left();
      if (only == nullptr) only = cluster.acts_alone();
      if (only != nullptr) {
        resolve_alone({only->a, only->b, only->contact});
        continue;
      }
      std::sort(together.begin(), together.end(), [](const Hit& x, const Hit& y) { return is_later(y, x); });
      for (const Hit& hit : together) resolve_alone(hit);
    }
  }
}

}  // namespace carom
