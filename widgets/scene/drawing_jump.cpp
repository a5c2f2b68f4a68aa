#include "widgets/scene/drawing_jump.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "physics/math/vectors.h"
#include "widgets/base/number_text.h"
#include "widgets/base/rounding.h"

namespace carom {
namespace {

constexpr std::size_t kMostJumping = 6;  // whose velocities find room
constexpr double kGap = 22.0;            // px, from the bodies to the first arrow
constexpr double kLevel = 20.0;          // px, between two arrows
constexpr double kWideLevel = 110.0;     // px, likewise, where texts stand between them
constexpr double kMostReach = 110.0;     // px, of a body from the contact
constexpr double kAxisEnd = 14.0;        // px, beyond the last arrow
constexpr double kLeastLength = 3.0;     // px, of an arrow
constexpr double kJumpWidth = 2.4;       // px, of the shafts
constexpr double kImpulseWidth = 3.0;    // px
constexpr double kNoLoss = 1e-12;        // of normal impulse times closing speed: rounding

class Builder {
 public:
  Builder(const DrawingInput& in, const std::vector<BodyIndex>& bodies, Drawing& out)
      : in_(in), out_(out), first_(in.jump->records.front()), pixel_(1.0 / in.camera.scale), bodies_(bodies) {
    // Before stands above or at the left.
    side_ = crossed(first_.normal);
    if (side_.y() < 0.0 || (side_.y() == 0.0 && side_.x() > 0.0)) side_ = -side_;
    level_ = is_wide() ? kWideLevel : kLevel;
  }

  void build() {
    for (const BodyIndex body : bodies_) {
      const Vec2 from = in_.jump->before().position(body) - first_.point;
      const double half = bounding_radius(body_of(body).shape);
      up_ = std::max(up_, std::min(side_.dot(from) + half, kMostReach * pixel_));
      down_ = std::max(down_, std::min(half - side_.dot(from), kMostReach * pixel_));
    }
    for (std::size_t level = 0; level < bodies_.size(); ++level) {
      add_velocity(level, up_, in_.jump->before(), true);
      add_velocity(level, -down_, in_.jump->after(), false);
    }
    for (std::size_t i = 0; i < in_.jump->records.size(); ++i) add_impulse(i);
    add_axis();
  }

 private:
  [[nodiscard]] bool is_seen(const Vec2& arrow) const { return arrow.norm() >= kLeastLength * pixel_; }
  [[nodiscard]] Vec2 direction(const Vec2& arrow) const {
    return is_seen(arrow) ? Vec2(arrow.normalized()) : Vec2(Vec2::Zero());
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
    const double along = std::clamp(first_.normal.dot(from), -kMostReach * pixel_, kMostReach * pixel_);
    const Vec2 at = first_.point + along * first_.normal + (beside + std::copysign(out_by, beside)) * side_;
    const Vec2 arrow = state.velocity(body) * in_.arrows.seconds;
    const QString text = name(body) + ' ' +
                         figure(without_rounding(state.velocity(body).norm(), fastest()), 3) +
                         QStringLiteral(" m/s");
    // Behind the arrow; beside one of a row of columns.
    const Vec2 text_side = is_wide() ? Vec2(std::copysign(1.0, beside) * side_) : direction(-arrow);
    add({at, at + arrow, ink(kColors[level]), kJumpWidth, before}, text, at, text_side, !before);
  }

  // m/s, of the bodies that jump.
  [[nodiscard]] double fastest() const {
    double most = 0.0;
    for (const BodyIndex body : bodies_)
      most =
          std::max({most, in_.jump->before().velocity(body).norm(), in_.jump->after().velocity(body).norm()});
    return most;
  }

  // On each of the two, from the contact.
  void add_impulse(std::size_t i) {
    const ImpactRecord& impact = in_.jump->records[i];
    const Vec2 impulse =
        impact.normal_impulse * impact.normal + impact.tangential_impulse * crossed(impact.normal);
    const Vec2 arrow = impulse * in_.arrows.metres_per_impulse;
    const QColor color = ink(3);
    const bool a = !has_infinite_mass(body_of(impact.a));
    const bool b = !has_infinite_mass(body_of(impact.b));
    const QString who = a && b ? QStringLiteral("each") : name(a ? impact.a : impact.b);
    QString text = QString("%1 gets %2 N·s").arg(who, figure(impulse.norm(), 3));
    if (in_.jump->records.size() == 1) text += '\n' + loss_text(i);
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
    if (impact.closing_speed > 0.0)
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
    const Vec2 top = first_.point + (up_ + beyond) * side_;
    const Vec2 end = first_.point - (down_ + beyond) * side_;
    out_.jump.axis = {top, end};
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
  const ImpactRecord& first_;
  double pixel_;  // m
  const std::vector<BodyIndex>& bodies_;
  Vec2 side_ = Vec2::UnitY();
  double level_ = kLevel;  // px
  double up_ = 0.0;        // m, how far the bodies reach from the contact
  double down_ = 0.0;      // m, likewise, on the other side
};

}  // namespace

std::vector<BodyIndex> bodies_of_jump(const DrawingInput& in) {
  if (in.jump == nullptr || !in.options.jumps || !in.frame.bodies) return {};
  if (in.jump->before().size() != static_cast<int>(in.frame.bodies->size())) return {};  // of other bodies
  std::vector<BodyIndex> bodies = in.jump->bodies();
  std::erase_if(
      bodies, [&](BodyIndex i) { return has_infinite_mass((*in.frame.bodies)[static_cast<std::size_t>(i)]); });
  if (bodies.size() > kMostJumping) bodies.resize(kMostJumping);
  return bodies;
}

void add_jump(const DrawingInput& in, Drawing& out) {
  const std::vector<BodyIndex> bodies = bodies_of_jump(in);
  if (!bodies.empty()) Builder(in, bodies, out).build();
}

}  // namespace carom
