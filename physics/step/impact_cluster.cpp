#include "physics/step/impact_cluster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "physics/math/sort_unique.h"
#include "physics/math/vectors.h"
#include "physics/step/apply_impact.h"
#include "physics/step/contact_sides.h"

namespace carom {
namespace {

// Of the fastest closing speed: slower ones take no part.
constexpr double kSlowest = 1e-3;
// Of the size, and of a normal: touches at one point of a surface.
constexpr double kOnePoint = 1e-6;
// Of the speeds: a closing speed.
constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();

}  // namespace

// 0 where it is rounding.
double ImpactCluster::closing_speed(const Touch& touch, const Motion& a, const Motion& b) {
  double scale = 0.0;
  const auto at_point = [&](const Motion& m) -> Vec2 {
    const Vec2 turning = m[5] * crossed(Vec2(touch.contact.point - m.head<2>()));
    scale += m.segment<2>(3).norm() + turning.norm();
    return m.segment<2>(3) + turning;
  };
  const Vec2 u = at_point(b) - at_point(a);
  const double closing = -u.dot(touch.contact.normal);
  return closing > kRounding * scale ? closing : 0.0;
}

void ImpactCluster::drop_slow() {
  const double fastest = closing_.empty() ? 0.0 : *std::max_element(closing_.begin(), closing_.end());
  std::size_t kept = 0;
  for (std::size_t k = 0; k < touches_.size(); ++k) {
    if (closing_[k] > kSlowest * fastest) touches_[kept++] = touches_[k];
  }
  touches_.resize(kept);
}

void ImpactCluster::drop_doubles(const World& world) {
  // A touch as the body that moves has it.
  struct Seen {
    BodyIndex moves;
    Vec2 out;  // of the body that does not
  };
  const auto seen = [&](const Touch& t) -> std::optional<Seen> {
    if (world.infinite_mass(t.a) == world.infinite_mass(t.b)) return std::nullopt;
    return world.infinite_mass(t.a) ? Seen{t.b, t.contact.normal} : Seen{t.a, -t.contact.normal};
  };
  const auto yields = [&](const Touch& t, const Touch& to) {
    const SurfaceLaw& law = world.material(t.contact, t.a, t.b);
    const SurfaceLaw& other = world.material(to.contact, to.a, to.b);
    return std::pair(law.restitution, -law.kinetic_friction) >
           std::pair(other.restitution, -other.kinetic_friction);
  };
  std::size_t kept = 0;
  for (const Touch& t : touches_) {
    const std::optional<Seen> now = seen(t);
    const auto end = touches_.begin() + static_cast<std::ptrdiff_t>(kept);
    const auto same = std::find_if(touches_.begin(), end, [&](const Touch& earlier) {
      const std::optional<Seen> before = now ? seen(earlier) : std::nullopt;
      return before && before->moves == now->moves && (before->out - now->out).norm() <= kOnePoint &&
             (earlier.contact.point - t.contact.point).norm() <= kOnePoint * world.shapes().size[now->moves];
    });
    if (same == end) {
      touches_[kept++] = t;
    } else if (yields(*same, t)) {
      *same = t;
    }
  }
  has_dropped_ = kept < touches_.size();
  touches_.resize(kept);
}

bool ImpactCluster::has_several(const World& world) const {
  if (touches_.empty()) return false;
  const Touch& first = touches_.front();
  const SurfaceLaw& law = world.material(first.contact, first.a, first.b);
  // Whatever meets bodies that move as one in one plane with one law slides alike at all of its points there,
  // so that one impact where their pressure acts is the same as several. Discs have no stretch of their own to
  // find it by (see pressed_contact).
  const auto parts_of = [&](const Touch& t) {
    return world.shapes().parts_or_first(t.contact.parts, t.a, t.b);
  };
  const auto has_stretch = [&](const Touch& t) {
    const ShapePair parts = parts_of(t);
    return !is_round(world.shapes().shapes, parts.a) && !is_round(world.shapes().shapes, parts.b);
  };
  const auto of_same_parts = [&](const Touch& t) {
    const ShapePair parts = parts_of(t);
    return parts.a == parts_of(first).a && parts.b == parts_of(first).b;
  };
  const auto on_one_face = [&](const Touch& t) {
    if (!has_stretch(t) || !has_stretch(first)) return false;
    const double sign = world.same_sides(t.a, t.b, first.a, first.b);
    const Vec2 along = t.contact.point - first.contact.point;
    return sign != 0.0 && (sign * t.contact.normal - first.contact.normal).norm() <= kOnePoint &&
           std::abs(along.dot(first.contact.normal)) <= kOnePoint * along.norm();
  };
  return std::any_of(touches_.begin() + 1, touches_.end(), [&](const Touch& t) {
    return !(of_same_parts(t) || on_one_face(t)) || world.material(t.contact, t.a, t.b) != law;
  });
}

bool ImpactCluster::has_law(const World& world) const {
  return std::none_of(touches_.begin(), touches_.end(), [&](const Touch& t) {
    const SurfaceLaw& material = world.material(t.contact, t.a, t.b);
    return material.sticks || material.tangential_restitution != 0.0;
  });
}

std::int64_t ImpactCluster::work(const World& world) const {
  std::int64_t unknowns = 0;
  for (const Touch& t : touches_)
    unknowns += world.material(t.contact, t.a, t.b).kinetic_friction > 0.0 ? 4 : 1;
  return unknowns * unknowns * unknowns;
}

const std::vector<BodyIndex>& ImpactCluster::find_bodies() {
  bodies_.clear();
  for (const Touch& t : touches_) bodies_.insert(bodies_.end(), {t.a, t.b});
  sort_unique(bodies_);
  return bodies_;
}

int ImpactCluster::column(BodyIndex body) const {
  return static_cast<int>(std::lower_bound(bodies_.begin(), bodies_.end(), body) - bodies_.begin());
}

// The contacts, their closing speeds, the velocities before, and how unit impulses change them where no joint
// acts.
void ImpactCluster::fill(World& world) {
  const auto n = static_cast<Eigen::Index>(bodies_.size());
  Eigen::VectorXd inverse_mass(n);
  Eigen::VectorXd inverse_inertia(n);
  before_.resize(3, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const BodyIndex i = bodies_[static_cast<std::size_t>(k)];
    before_.col(k) = world.trajectories.at_start(i).segment<3>(3);
    inverse_mass[k] = world.mass().inverse_mass[i];
    inverse_inertia[k] = world.mass().inverse_inertia[i];
  }
  contacts_.clear();
  closing_.clear();
  for (const Touch& t : touches_) {
    const SurfaceLaw& material = world.material(t.contact, t.a, t.b);
    contacts_.push_back({column(t.a), column(t.b), t.contact.normal,
                         t.contact.point - world.trajectories.at_start(t.a).head<2>(),
                         t.contact.point - world.trajectories.at_start(t.b).head<2>(),
                         t.rests ? 0.0 : material.restitution, material.kinetic_friction});
    closing_.push_back(-world.parting_speed(t.a, t.b, t.contact));
  }
  free_answers(inverse_mass, inverse_inertia, contacts_, free_);
}

// With the joints as they are: the answers, and impulses by them.
ClusterOutcome ImpactCluster::solve(World& world, ClusterRestitution restitution) {
  answers_ = free_;
  if (world.trajectories.is_jointed(bodies_)) {
    const auto n = static_cast<Eigen::Index>(bodies_.size());
    for (Eigen::Index first = 0; first < answers_.cols(); first += n)
      world.trajectories.project_changes(bodies_, answers_.middleCols(first, n));
  }
  after_ = before_;
  impacts_.assign(contacts_.size(), Impact{});
  const ClusterOutcome outcome =
      resolve_simultaneous(after_, answers_, contacts_, restitution, impacts_, scratch_);
  double largest = 0.0;
  for (const Impact& impact : impacts_) largest = std::max(largest, impact.normal);
  for (Impact& impact : impacts_) {
    if (impact.normal <= kRounding * largest) impact = {};  // what only touches takes no part
  }
  return outcome;
}

// Changes the motions by the impulses. False if a string would have to push: it is slack from then on.
bool ImpactCluster::apply(World& world) {
  Trajectories& trajectories = world.trajectories;
  if (trajectories.is_jointed(bodies_)) {
    const auto n = static_cast<Eigen::Index>(bodies_.size());
    after_.setZero();
    Eigen::Index first = 0;
    for (const Impact& impact : impacts_) {
      for (const double j : {impact.normal, impact.tangential}) {
        if (j != 0.0) after_ += j * free_.middleCols(first, n);
        first += n;
      }
    }
    return trajectories.apply_changes(bodies_, after_);
  }
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const auto v = after_.col(static_cast<Eigen::Index>(k));
    if (!world.infinite_mass(bodies_[k])) trajectories.set_velocity(bodies_[k], v.head<2>(), v[2]);
  }
  return true;
}

bool ImpactCluster::resolve(World& world, double within, ClusterRestitution restitution) {
  static_cast<void>(find_bodies());
  fill(world);
  JumpsOfMoment jumps(world, within);
  const double now = world.trajectories.epoch() + within;
  const NoticeBodies first{touches_.front().a, touches_.front().b};
  // Each round but the last makes one string slack.
  do {
    const ClusterOutcome outcome = solve(world, restitution);
    if (!outcome.solved) {
      world.note(&Notices::cluster_unsolved_since, now, first);
      return false;
    }
    // Closing speeds may be so small that the solution rounds to nothing; pair by pair they still come to an
    // end. An impact that keeps the others from closing is that of a pair, with the pair's own law.
    const auto acting =
        std::count_if(impacts_.begin(), impacts_.end(), [](const Impact& i) { return i.normal > 0.0; });
    if (acting < (restitution == ClusterRestitution::kOwn ? 2 : 1)) return false;
    if (outcome.lowered) world.note(&Notices::restitution_lowered_since, now, first);
  } while (!apply(world));
  if (world.field().has_switching_springs()) {
    for (const BodyIndex i : bodies_) {
      if (!world.infinite_mass(i))
        world.sums.ledger.lost_to_dampers +=
            world.trajectories.recheck_switches(world.trajectories.island_of(i));
    }
  }
  record(world, within, jumps);
  return true;
}

const ImpactCluster::Touch* ImpactCluster::acts_alone() const {
  const auto acts = [](const Impact& impact) { return impact.normal > 0.0; };
  const auto first = std::find_if(impacts_.begin(), impacts_.end(), acts);
  if (first == impacts_.end() || std::any_of(first + 1, impacts_.end(), acts)) return nullptr;
  return &touches_[static_cast<std::size_t>(first - impacts_.begin())];
}

// Of the impacts of one moment, only the sum of their losses is certain not to be negative, but for rounding:
// each gets its part of that, of friction where friction took energy and of restitution where the normal
// impulse did.
void ImpactCluster::share_losses() {
  Impact all;
  double braked = 0.0;
  double rubbed = 0.0;
  for (const Impact& impact : impacts_) {
    all.lost_to_restitution += impact.lost_to_restitution;
    all.lost_to_friction += impact.lost_to_friction;
    braked += std::max(0.0, impact.lost_to_restitution);
    rubbed += std::max(0.0, impact.lost_to_friction);
  }
  if (all.lost_to_restitution >= 0.0 && all.lost_to_friction >= 0.0 && braked == all.lost_to_restitution &&
      rubbed == all.lost_to_friction)
    return;
  const double lost = all.lost_to_restitution + all.lost_to_friction;
  const double to_friction = std::clamp(all.lost_to_friction, 0.0, std::max(0.0, lost));
  double left = lost - to_friction;
  const auto part = [](double of, double share, double whole) {
    return whole > 0.0 ? of * (std::max(0.0, share) / whole) : 0.0;
  };
  for (Impact& impact : impacts_) {
    impact.lost_to_restitution = part(lost - to_friction, impact.lost_to_restitution, braked);
    impact.lost_to_friction = part(to_friction, impact.lost_to_friction, rubbed);
    left -= impact.lost_to_restitution;
  }
  // What is left is rounding.
  const auto acts = [](const Impact& impact) { return impact.normal > 0.0; };
  const auto first = std::find_if(impacts_.begin(), impacts_.end(), acts);
  if (first != impacts_.end()) first->lost_to_restitution += left;
}

void ImpactCluster::record(World& world, double within, JumpsOfMoment& jumps) {
  share_losses();
  for (std::size_t k = 0; k < touches_.size(); ++k) {
    const auto& [a, b, contact, rests] = touches_[k];
    if (!(impacts_[k].normal > 0.0)) continue;
    record_impact(world, a, b, contact, impacts_[k], closing_[k], within);
    record_impulse(world, a, b, contact, impacts_[k]);
    jumps.add(world);
  }
}

}  // namespace carom
