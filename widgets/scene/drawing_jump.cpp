#include "widgets/scene/drawing_jump.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

#include "physics/math/vectors.h"
#include "widgets/base/number_text.h"
#include "widgets/base/rounding.h"

namespace carom {
namespace {

constexpr std::size_t kMostJumping = 6;  // whose velocities find room
constexpr std::size_t kMostTold = 6;     // whose impulses find room
constexpr double kGap = 22.0;            // px, from the bodies to the first arrow
constexpr double kLevel = 20.0;          // px, between two arrows
constexpr double kWideLevel = 110.0;     // px, likewise, where texts stand between them
constexpr double kMostReach = 110.0;     // px, of a body from the contact
constexpr double kAxisEnd = 14.0;        // px, beyond the last arrow
constexpr double kLeastLength = 3.0;     // px, of an arrow
constexpr double kJumpWidth = 2.4;       // px, of the shafts
constexpr double kImpulseWidth = 3.0;    // px
constexpr double kAcross = 0.1;          // sine of the angle of an arrow with the line
constexpr double kNoLoss = 1e-12;        // of normal impulse times closing speed: rounding

// Impacts of the moment that share bodies.
struct Group {
  std::vector<BodyIndex> bodies;     // that move freely, of many the first few
  std::vector<std::size_t> impacts;  // of the moment's records
};

// Those that bodies which move freely connect, by an impact or by a joint, in the order of their impacts; as
// many as the drawing has room for.
std::vector<Group> groups_of(const DrawingInput& in) {
  if (in.jump == nullptr || !in.options.jumps || !in.frame.bodies) return {};
  const std::vector<Body>& all = *in.frame.bodies;
  if (in.jump->before().size() != static_cast<int>(all.size())) return {};  // of other bodies
  std::vector<BodyIndex> bodies = in.jump->bodies();
  std::erase_if(bodies, [&](BodyIndex i) { return has_infinite_mass(all[static_cast<std::size_t>(i)]); });
  std::vector<std::size_t> link(bodies.size());  // to another one of its group; the last one to itself
  std::iota(link.begin(), link.end(), std::size_t{0});
  const auto last = [&link](std::size_t k) {
    while (link[k] != k) k = link[k] = link[link[k]];
    return k;
  };
  const auto place = [&bodies](BodyIndex body) {
    const auto at = std::lower_bound(bodies.begin(), bodies.end(), body);
    return at != bodies.end() && *at == body ? std::optional(static_cast<std::size_t>(at - bodies.begin()))
                                             : std::nullopt;
  };
  const auto connect = [&](std::optional<std::size_t> a, std::optional<std::size_t> b) {
    if (a && b) link[last(*b)] = last(*a);
  };
  for (const ImpactRecord& impact : in.jump->records) connect(place(impact.a), place(impact.b));
  const auto named = [&](const std::string& name) -> std::optional<std::size_t> {
    const auto at = std::find_if(bodies.begin(), bodies.end(),
                                 [&](BodyIndex i) { return all[static_cast<std::size_t>(i)].name == name; });
    return at == bodies.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - bodies.begin()));
  };
  for (const Joint& joint : in.jump->joints) connect(named(joint.body), named(joint.to));

  std::vector<Group> groups;
  std::vector<std::optional<std::size_t>> group_of(bodies.size());  // of the last one of each
  for (std::size_t i = 0; i < in.jump->records.size(); ++i) {
    const ImpactRecord& impact = in.jump->records[i];
    std::optional<std::size_t> at = place(impact.a);
    if (!at) at = place(impact.b);
    if (!at) continue;
    std::optional<std::size_t>& group = group_of[last(*at)];
    if (!group) {
      group = groups.size();
      groups.emplace_back();
    }
    groups[*group].impacts.push_back(i);
  }
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (const auto group = group_of[last(k)]) groups[*group].bodies.push_back(bodies[k]);
  }
  std::size_t room = kMostJumping;
  for (Group& group : groups) {
    if (group.bodies.size() > room) group.bodies.resize(room);
    room -= group.bodies.size();
  }
  std::erase_if(groups, [](const Group& group) { return group.bodies.empty(); });
  return groups;
}

double speed_of(const State& state, BodyIndex body) { return state.velocity(body).norm(); }

double impulse_of(const ImpactRecord& impact) {
  return std::hypot(impact.normal_impulse, impact.tangential_impulse);
}

// What figures of the moment are rounding beside.
struct Largest {
  double speed = 0.0;    // m/s, of all bodies
  double impulse = 0.0;  // N s: of the run so far, or the momentum of its bodies
};

Largest largest_of(const DrawingInput& in) {
  const Scales& scales = in.frame.scales;
  Largest most{0.0, std::max(scales.impulse, scales.momentum)};
  const State& before = in.jump->before();
  const State& after = in.jump->after();
  for (BodyIndex i{0}; i < before.size(); ++i)
    most.speed = std::max({most.speed, speed_of(before, i), speed_of(after, i)});
  for (const ImpactRecord& impact : in.jump->records) most.impulse = std::max(most.impulse, impulse_of(impact));
  return most;
}

// The impacts of the moment with the largest impulses.
std::vector<std::size_t> told_impacts(const std::vector<Group>& groups, const JumpMoment& moment) {
  std::vector<std::size_t> all;
  for (const Group& group : groups) all.insert(all.end(), group.impacts.begin(), group.impacts.end());
  std::stable_sort(all.begin(), all.end(), [&](std::size_t a, std::size_t b) {
    return impulse_of(moment.records[a]) > impulse_of(moment.records[b]);
  });
  if (all.size() > kMostTold) all.resize(kMostTold);
  return all;
}

class Builder {
 public:
  Builder(const DrawingInput& in, const Group& group, const Largest& largest,
          const std::vector<std::size_t>& told, Drawing& out)
      : in_(in),
        out_(out),
        largest_(largest),
        told_(told),
        first_(in.jump->records[group.impacts.front()]),
        pixel_(1.0 / in.camera.scale),
        bodies_(group.bodies),
        impacts_(group.impacts),
        middle_(first_.point) {
    // Before stands above or at the left.
    side_ = crossed(first_.normal);
    if (side_.y() < 0.0 || (side_.y() == 0.0 && side_.x() > 0.0)) side_ = -side_;
    level_ = is_wide() ? kWideLevel : kLevel;
  }

  void build() {
    double least = kMostReach * pixel_;
    double most = -least;
    for (const BodyIndex body : bodies_) {
      const Vec2 from = in_.jump->before().position(body) - first_.point;
      const double half = bounding_radius(body_of(body).shape);
      least = std::min(least, along(from));
      most = std::max(most, along(from));
      up_ = std::max(up_, std::min(side_.dot(from) + half, kMostReach * pixel_));
      down_ = std::max(down_, std::min(half - side_.dot(from), kMostReach * pixel_));
    }
    // Through the bodies where all are on one side of the contact: on the other one is a wall.
    if (least > 0.0 || most < 0.0) middle_ += (least > 0.0 ? least : most) * first_.normal;
    for (std::size_t level = 0; level < bodies_.size(); ++level) {
      add_velocity(level, up_, in_.jump->before(), true);
      add_velocity(level, -down_, in_.jump->after(), false);
    }
    for (const std::size_t i : impacts_) add_impulse(i);
    add_axis();
  }

 private:
  [[nodiscard]] bool is_seen(const Vec2& arrow) const { return arrow.norm() >= kLeastLength * pixel_; }
  [[nodiscard]] Vec2 direction(const Vec2& arrow) const {
    return is_seen(arrow) ? Vec2(arrow.normalized()) : Vec2(Vec2::Zero());
  }
  // m, along the normal.
  [[nodiscard]] double along(const Vec2& from) const {
    return std::clamp(first_.normal.dot(from), -kMostReach * pixel_, kMostReach * pixel_);
  }
  // The arrows stand beside one another rather than over one another.
  [[nodiscard]] bool is_wide() const { return std::abs(side_.x()) > std::abs(side_.y()); }
  [[nodiscard]] const Body& body_of(BodyIndex body) const {
    return (*in_.frame.bodies)[static_cast<std::size_t>(body)];
  }
  [[nodiscard]] QString name(BodyIndex body) const { return QString::fromStdString(body_of(body).name); }
  // Readable as text too.
  [[nodiscard]] QColor ink(std::size_t series) const {
    return blend(in_.theme.series[series], in_.theme.text, 0.25);
  }

  void add_velocity(std::size_t level, double beside, const State& state, bool before) {
    constexpr std::array<std::size_t, kMostJumping> kColors = {0, 1, 2, 4, 5, 0};  // the impulse has the fourth
    const BodyIndex body = bodies_[level];
    const double out_by = (kGap + level_ * static_cast<double>(bodies_.size() - 1 - level)) * pixel_;
    const Vec2 from = in_.jump->before().position(body) - first_.point;
    const Vec2 at =
        first_.point + along(from) * first_.normal + (beside + std::copysign(out_by, beside)) * side_;
    const double speed = without_rounding(speed_of(state, body), largest_.speed);
    const Vec2 arrow = speed > 0.0 ? Vec2(state.velocity(body) * in_.arrows.seconds) : Vec2(Vec2::Zero());
    const QString text = name(body) + ' ' + figure(speed, 3) + QStringLiteral(" m/s");
    // Clear of the line and of what is beyond it: on the side of the body, past an arrow that leads there.
    const double leads = arrow.dot(first_.normal);
    const bool crosses = std::abs(leads) > kAcross * arrow.norm();
    const Vec2 text_side = std::copysign(1.0, along(from)) * first_.normal;
    const Vec2 text_at = crosses && leads * along(from) > 0.0 ? Vec2(at + arrow) : at;
    add({at, at + arrow, ink(kColors[level]), kJumpWidth, before}, text, text_at, text_side, !before);
  }

  // On each of the two, from the contact.
  void add_impulse(std::size_t i) {
    const ImpactRecord& impact = in_.jump->records[i];
    const double size = without_rounding(impulse_of(impact), largest_.impulse);
    Vec2 arrow = Vec2::Zero();
    if (size > 0.0) {
      arrow = in_.arrows.metres_per_impulse *
              (impact.normal_impulse * impact.normal + impact.tangential_impulse * crossed(impact.normal));
    }
    const QColor color = ink(3);
    const bool a = !has_infinite_mass(body_of(impact.a));
    const bool b = !has_infinite_mass(body_of(impact.b));
    const QString who = a && b ? QStringLiteral("each") : name(a ? impact.a : impact.b);
    QString text;
    if (std::find(told_.begin(), told_.end(), i) != told_.end()) {
      text = QString("%1 gets %2 N·s").arg(who, figure(size, 3));
      if (impacts_.size() == 1) text += '\n' + loss_text(i);
    }
    const Vec2 tip = b ? arrow : Vec2(-arrow);
    if (a && b)
      add({impact.point, impact.point - arrow, color, kImpulseWidth, false}, {}, Vec2::Zero(), Vec2::Zero(),
          true);
    add({impact.point, impact.point + tip, color, kImpulseWidth, false}, text, impact.point + tip,
        direction(tip), true);
    out_.segments.push_back({impact.point, impact.point, color, 3.0 * kImpulseWidth * in_.options.line_scale});
  }

  [[nodiscard]] QString loss_text(std::size_t i) const {
    const ImpactRecord& impact = in_.jump->records[i];
    const double lost = lost_energy(impact);
    const double rounding = kNoLoss * std::abs(impact.normal_impulse * impact.closing_speed);
    QString text = QString("lost %1 J").arg(figure(std::abs(lost) > rounding ? lost : 0.0, 3));
    const double parting = opening(impact, in_.jump->jumps[i].after);
    if (without_rounding(impact.closing_speed, largest_.speed) > 0.0)
      text += QString(", e = %1").arg(figure(without_rounding(parting / impact.closing_speed, 1.0), 3));
    return text;
  }

  // m/s: at which the contact's points part along its normal.
  static double opening(const ImpactRecord& impact, const State& state) {
    const auto velocity = [&](BodyIndex body) {
      const Vec2 arm = impact.point - state.position(body);
      return Vec2(state.velocity(body) + state.v.col(body)[2] * crossed(arm));
    };
    return impact.normal.dot(velocity(impact.b) - velocity(impact.a));
  }

  void add_axis() {
    const double beyond = (kGap + level_ * static_cast<double>(bodies_.size() - 1) + kAxisEnd) * pixel_;
    const Vec2 top = middle_ + (up_ + beyond) * side_;
    const Vec2 end = middle_ - (down_ + beyond) * side_;
    out_.jump.axes.emplace_back(top, end);
    out_.jump.texts.push_back({top, side_, QStringLiteral("just before"), in_.theme.muted, false});
    out_.jump.texts.push_back({end, -side_, QStringLiteral("just after"), in_.theme.text, true});
  }

  void add(const Drawing::JumpArrow& arrow, const QString& text, const Vec2& at, const Vec2& side,
           bool strong) {
    if (is_seen(arrow.to - arrow.from)) out_.jump.arrows.push_back(arrow);
    if (!text.isEmpty()) out_.jump.texts.push_back({at, side, text, arrow.color, strong});
  }

  const DrawingInput& in_;
  Drawing& out_;
  const Largest& largest_;
  const std::vector<std::size_t>& told_;  // impacts of the moment
  const ImpactRecord& first_;
  double pixel_;  // m
  const std::vector<BodyIndex>& bodies_;
  const std::vector<std::size_t>& impacts_;
  Vec2 middle_;  // m, of the line before and after which the velocities stand
  Vec2 side_ = Vec2::UnitY();
  double level_ = kLevel;  // px
  double up_ = 0.0;        // m, how far the bodies reach from the contact
  double down_ = 0.0;      // m, likewise, on the other side
};

}  // namespace

std::vector<BodyIndex> bodies_of_jump(const DrawingInput& in) {
  std::vector<BodyIndex> bodies;
  for (const Group& group : groups_of(in))
    bodies.insert(bodies.end(), group.bodies.begin(), group.bodies.end());
  return bodies;
}

void add_jump(const DrawingInput& in, Drawing& out) {
  const std::vector<Group> groups = groups_of(in);
  if (groups.empty()) return;
  const Largest largest = largest_of(in);
  const std::vector<std::size_t> told = told_impacts(groups, *in.jump);
  for (const Group& group : groups) Builder(in, group, largest, told, out).build();
}

}  // namespace carom
