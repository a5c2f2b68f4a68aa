#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "physics/impact/simultaneous_impact.h"
#include "physics/step/jumps_of_moment.h"
#include "physics/step/neighbours.h"
#include "physics/step/world.h"

namespace carom {

// Contacts that are resolved at once, at most: the law's work grows with the cube of their number.
inline constexpr std::size_t kMostTogether = 32;

// Whether what touches takes part in an impact, even if it does not close.
[[nodiscard]] inline bool takes_touches(const World& world) {
  return world.model->several_impacts == SeveralImpactsId::kSimultaneous;
}

// Whether impacts under this law take all of the closing speed and nothing else.
[[nodiscard]] inline bool is_of_clay(const SurfaceLaw& law) {
  return law.restitution == 0.0 && law.tangential_restitution == 0.0 && law.kinetic_friction == 0.0 &&
         !law.sticks;
}

// Keeps, of items with ends a and b, those that bodies which move, and joints, connect with the pair of a and
// b; if there are more than kMostTogether, one more of them.
template <class Item>
void keep_connected(const World& world, BodyIndex a, BodyIndex b, std::vector<Item>& items) {
  std::size_t kept = 0;
  const auto reaches = [&](BodyIndex body) {
    const auto moves = [&](BodyIndex other) { return world.move_each_other(other, body); };
    const auto has_it = [&](const Item& item) {
      const auto [c, d] = ends_of(item);
      return moves(c) || moves(d);
    };
    if (world.infinite_mass(body)) return false;
    return moves(a) || moves(b) ||
           std::any_of(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(kept), has_it);
  };
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t k = kept; k < items.size() && kept <= kMostTogether; ++k) {
      const auto [c, d] = ends_of(items[k]);
      if (!reaches(c) && !reaches(d)) continue;
      std::swap(items[kept++], items[k]);
      grows = true;
    }
  }
  items.resize(kept);
}

// Contacts of several bodies that are resolved at one moment. Buffers are kept from one cluster to the next.
class ImpactCluster {
 public:
  struct Touch {
    BodyIndex a;
    BodyIndex b;
    Contact contact;
    bool rests = false;  // both stay in touch: without restitution
    friend BodyPair ends_of(const Touch& touch) { return {touch.a, touch.b}; }
  };

  void clear() {
    touches_.clear();
    impacts_.clear();
    has_dropped_ = false;
  }
  // Bodies a < b.
  void add(BodyIndex a, BodyIndex b, const Contact& contact) { touches_.push_back({a, b, contact}); }
  [[nodiscard]] std::span<const Touch> touches() const { return touches_; }
  [[nodiscard]] std::span<Touch> touches() { return touches_; }
  // Keeps the touches for which takes(contact, a, b) is true and that bodies which move connect with a or b.
  template <class Takes>
  void keep_connected_of(const World& world, BodyIndex a, BodyIndex b, const Takes& takes) {
    std::erase_if(touches_, [&](const Touch& t) { return !takes(t.contact, t.a, t.b); });
    keep_connected(world, a, b, touches_);
    drop_doubles(world);
  }
  // Keeps the touches that close, and none that closes much slower than others: it is another impact's, or
  // rounding. With velocities `motion(body)`.
  template <class MotionOf>
  void keep_closing(const MotionOf& motion) {
    closing_.clear();
    for (const Touch& t : touches_) closing_.push_back(closing_speed(t, motion(t.a), motion(t.b)));
    drop_slow();
  }
  // The same, of those that bodies which move connect with a or b.
  template <class MotionOf>
  void keep_closing(const World& world, BodyIndex a, BodyIndex b, const MotionOf& motion) {
    keep_closing(motion);
    keep_connected(world, a, b, touches_);
    drop_doubles(world);
  }
  // Of several touches of a body with static and kinematic ones at one point and along one normal, keeps one:
  // there these have one surface. Where its two sides differ it is the less elastic one, of two as elastic the
  // rougher one, whatever the order of the bodies.
  void drop_doubles(const World& world);
  // The one touch that is left of several that were one; else null.
  [[nodiscard]] const Touch* only_one_left() const {
    return has_dropped_ && touches_.size() == 1 ? &touches_.front() : nullptr;
  }
  // Whether the touches are more than one impact can stand for: not all on one face with one law.
  [[nodiscard]] bool has_several(const World& world) const;
  // Whether the law of simultaneous impacts knows all properties of their surfaces.
  [[nodiscard]] bool has_law(const World& world) const;
  // About how much the law has to do: the cube of its number of unknowns.
  [[nodiscard]] std::int64_t work(const World& world) const;
  // Those that the touches have, in rising order.
  [[nodiscard]] const std::vector<BodyIndex>& find_bodies();

  // Resolves all touches at the start of the trajectories, `within` s after the epoch: changes velocities,
  // records the impacts and keeps the ledger. False if no impulses satisfy the law, which is noted, if they
  // round to nothing, or if one impact alone keeps the others from closing; then no velocity has changed.
  [[nodiscard]] bool resolve(World& world, double within, ClusterRestitution restitution);
  // After resolve() was false: the touch whose impact alone keeps the others from closing; null if none does.
  [[nodiscard]] const Touch* acts_alone() const;
  // By touch, after resolve(); those without an impulse did not take part.
  [[nodiscard]] std::span<const Impact> impacts() const { return impacts_; }

 private:
  [[nodiscard]] static double closing_speed(const Touch& touch, const Motion& a, const Motion& b);
  void drop_slow();
  [[nodiscard]] int column(BodyIndex body) const;
  void fill(World& world);
  [[nodiscard]] ClusterOutcome solve(World& world, ClusterRestitution restitution);
  [[nodiscard]] bool apply(World& world);
  void share_losses();
  void record(World& world, double within, JumpsOfMoment& jumps);

  std::vector<Touch> touches_;
  bool has_dropped_ = false;     // doubles
  std::vector<double> closing_;  // m/s, by touch
  std::vector<BodyIndex> bodies_;
  std::vector<ClusterContact> contacts_;
  std::vector<Impact> impacts_;
  // By body: before, after; by contact, direction and body: see free_answers().
  Eigen::Matrix3Xd before_, after_, free_, answers_;
  ClusterScratch scratch_;
};

}  // namespace carom
