#include "widgets/scene/drawing_forces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "widgets/scene/scale_row.h"

namespace carom {
namespace {

constexpr double kSpringWidth = 1.6;         // px
constexpr double kIdleWidth = 0.9;           // px
constexpr double kAmplitude = 6.0;           // px, of a zigzag
constexpr int kTurns = 14;                   // of a zigzag, each to one side
constexpr double kLead = 0.08;               // straight share of a zigzag's length, at each end
constexpr double kLeastZigzag = 12.0;        // px; a shorter one is a line
constexpr double kPlate = 9.0;               // px, half of a bumper's plate
constexpr double kPlateWidth = 3.0;          // px
constexpr double kAnchorDot = 6.0;           // px
constexpr double kHatch = 7.0;               // px between hatch lines
constexpr double kHatchWidth = 1.0;          // px
constexpr double kLeastMotionArrow = 15.0;   // px, each half of a double arrow
constexpr double kMotionWidth = 2.0;         // px
constexpr double kForceWidth = 2.4;          // px
constexpr double kLeastForceArrow = 10.0;    // px
constexpr double kContactWidth = 2.0;        // px
constexpr double kLeastContactArrow = 6.0;   // px
constexpr double kContactDot = 5.0;          // px
constexpr double kLongestKey = 60.0;         // px
constexpr double kLabelRoom = 22.0;          // px, of a label above a point
constexpr double kLeastTorqueRadius = 14.0;  // px

Vec2 turned(const Vec2& v) { return {-v.y(), v.x()}; }

// Indices of bodies by their names.
class Names {
 public:
  explicit Names(const Frame& frame) {
    const int count = std::min(frame.state.size(), static_cast<int>(frame.bodies->size()));
    for (int i = 0; i < count; ++i) index_.emplace((*frame.bodies)[static_cast<std::size_t>(i)].name, i);
  }
  // -1 if there is none.
  [[nodiscard]] int operator[](const std::string& name) const {
    const auto found = index_.find(name);
    return found == index_.end() ? -1 : found->second;
  }

 private:
  std::unordered_map<std::string_view, int> index_;
};

const Body& body_of(const DrawingInput& in, int i) { return (*in.frame.bodies)[static_cast<std::size_t>(i)]; }

// m from a point of a body, in its own axes, to where the unit vector `along` leaves the body.
double rim(const DrawingInput& in, int i, const Vec2& point, const Vec2& along) {
  const Vec2 own = Eigen::Rotation2Dd(-in.frame.state.q(2, i)) * along;
  const auto inside = chord(outline_of(body_of(in, i).shape), point, own);
  return inside ? std::max(inside->second, 0.0) : 0.0;
}

// m: where a point of a body is; a point of the plane if there is no body.
Vec2 place_of(const DrawingInput& in, int body, const Vec2& point) {
  if (body < 0 || point.isZero(0.0)) return body < 0 ? point : in.frame.state.position(body);
  return in.frame.state.position(body) + turned_by(in.frame.state.q(2, body), point);
}

// Lines of one style, in world metres.
class Pen {
 public:
  Pen(std::vector<Drawing::SegmentItem>& to, const QColor& color, double width)
      : to_(to), color_(color), width_(width) {}
  void line(const Vec2& from, const Vec2& to) { to_.push_back({from, to, color_, width_}); }
  void dot(const Vec2& at, double size) { to_.push_back({at, at, color_, size}); }
  void plate(const Vec2& at, const Vec2& across, double width) {
    to_.push_back({at - across, at + across, color_, width});
  }
  void zigzag(const Vec2& from, const Vec2& to, const Vec2& amplitude) {
    const Vec2 lead = kLead * (to - from);
    const Vec2 step = (to - from - 2 * lead) / kTurns;
    Vec2 last = from;
    for (int i = 0; i <= kTurns + 1; ++i) {
      Vec2 next = from + lead;
      if (i > 0) next += (i - 0.5) * step + (i % 2 == 0 ? -1.0 : 1.0) * amplitude;
      if (i > kTurns) next = to - lead;
      line(last, next);
      last = next;
    }
    line(last, to);
  }

 private:
  std::vector<Drawing::SegmentItem>& to_;
  QColor color_;
  double width_;
};

void add_spring(const DrawingInput& in, const Spring& spring, int body, int other, Drawing& out) {
  const Vec2 end = place_of(in, body, spring.point);
  const Vec2 start = place_of(in, other, spring.anchor);
  const double length = (end - start).norm();
  const bool short_only = spring.acts == SpringActs::kPush || spring.acts == SpringActs::kWhileShort;
  const bool idle = (short_only && length >= spring.rest_length) ||
                    (spring.acts == SpringActs::kPull && length <= spring.rest_length);
  const double thick = in.options.line_scale;
  const QColor color = blend(in.theme.text, in.theme.scene_ground, idle ? 0.6 : 0.25);
  Pen pen(out.lines, color, (idle ? kIdleWidth : kSpringWidth) * thick);
  if (other < 0) pen.dot(start, kAnchorDot * thick);
  Pen on_body(out.segments, color, kSpringWidth * thick);
  if (!spring.point.isZero(0.0)) on_body.dot(end, kAnchorDot * thick);
  if (other >= 0 && !spring.anchor.isZero(0.0)) on_body.dot(start, kAnchorDot * thick);
  if (!(length > 0.0)) return;

  const double pixel = 1.0 / in.camera.scale;
  const Vec2 along = (end - start) / length;
  const Vec2 from =
      other >= 0 ? Vec2(start + along * std::min(rim(in, other, spring.anchor, along), length)) : start;
  // A bumper ends where the body's rim is when it starts to push.
  const double reach =
      (short_only ? std::min(length, spring.rest_length) : length) - rim(in, body, spring.point, -along);
  const Vec2 to = start + along * std::max(reach, (from - start).norm());
  const double visible = (to - from).norm();
  if (spring.acts == SpringActs::kPull || visible < kLeastZigzag * thick * pixel) {
    pen.line(from, to);
  } else {
    pen.zigzag(from, to, turned(along) * (kAmplitude * thick * pixel));
  }
  if (short_only) pen.plate(to, turned(along) * (kPlate * thick * pixel), kPlateWidth * thick);
}

// Where the line from + s along passes through the parts of a shape: intervals of s in m, without those between
// parts that touch.
std::vector<std::pair<double, double>> chords(std::span<const ConvexPart> parts, const Vec2& from,
                                              const Vec2& along) {
  constexpr double kTouch = 1e-9;  // of the length
  std::vector<std::pair<double, double>> all;
  for (const ConvexPart& part : parts) {
    if (const auto inside = chord(part.outline, from - part.position, along)) all.push_back(*inside);
  }
  std::sort(all.begin(), all.end());
  std::vector<std::pair<double, double>> merged;
  for (const auto& [low, high] : all) {
    if (merged.empty() || low > merged.back().second + kTouch * (high - low)) {
      merged.emplace_back(low, high);
    } else {
      merged.back().second = std::max(merged.back().second, high);
    }
  }
  return merged;
}

// Lines at 45 degrees to the body's own axes, which move with it; only those that `seen` can show.
void hatch(const DrawingInput& in, int i, const WorldRect& seen, Drawing& out) {
  const Eigen::Rotation2Dd turn(in.frame.state.q(2, i));
  const Vec2 center = in.frame.state.position(i);
  const double pixel = 1.0 / in.camera.scale;
  const double inset = out.outline * pixel;
  const double spacing = kHatch * in.options.line_scale * pixel;
  const double seen_radius = (seen.upper - seen.lower).norm() / 2;
  const Vec2 seen_at = turn.inverse() * ((seen.lower + seen.upper) / 2 - center);
  const Vec2 along = Vec2(1.0, 1.0) / std::numbers::sqrt2;
  const Vec2 across = turned(along);
  const Shape& shape = body_of(in, i).shape;
  const std::vector<ConvexPart> parts = convex_parts(shape);
  const double extent = bounding_radius(shape);
  const double lowest = std::max(-extent, seen_at.dot(across) - seen_radius);
  const double highest = std::min(extent, seen_at.dot(across) + seen_radius);
  const bool disc = std::holds_alternative<Disc>(shape);
  Pen pen(disc ? out.segments : out.lines, in.theme.wall_line, kHatchWidth * in.options.line_scale);
  for (double k = std::ceil(lowest / spacing); k * spacing <= highest; ++k) {
    const double d = k * spacing;
    for (const auto& [first, last] : chords(parts, d * across, along)) {
      const double low = std::max(first + inset, seen_at.dot(along) - seen_radius);
      const double high = std::min(last - inset, seen_at.dot(along) + seen_radius);
      if (low < high)
        pen.line(center + turn * (d * across + low * along), center + turn * (d * across + high * along));
    }
  }
}

void add_drive(const DrawingInput& in, int i, const Drive& drive, Drawing& out) {
  const double pixel = 1.0 / in.camera.scale;
  const double least = kLeastMotionArrow * in.options.line_scale * pixel;
  const double width = kMotionWidth * in.options.line_scale;
  const QColor color = blend(in.theme.text, in.theme.wall_fill, 0.1);
  const Vec2 at = in.frame.state.position(i);
  const double amplitude = drive.amplitude.norm();
  if (amplitude > 0.0) {
    const Vec2 reach = drive.amplitude * std::max(1.0, least / amplitude);
    const Vec2 middle = at - drive.amplitude * std::sin(drive.angular_frequency * in.frame.time + drive.phase);
    for (const Vec2& end : {Vec2(middle + reach), Vec2(middle - reach)}) {
      out.arrows.push_back({middle, end, color, width});
    }
  } else if (const double speed = drive.velocity.norm(); speed > 0.0 && !in.options.velocities) {
    const Vec2 reach = drive.velocity * (least / speed);
    out.arrows.push_back({at - reach, at + reach, color, width});
  }
}

void add_label(const DrawingInput& in, const Vec2& at, const QString& text, const QColor& color, Drawing& out) {
  constexpr double kDrop = 4.0;  // px
  if (in.options.names) out.labels.push_back({at, kDrop, text, color});
}

void add_torque(const DrawingInput& in, int i, double torque, const QColor& color, Drawing& out) {
  constexpr double kFrom = 0.15 * std::numbers::pi;  // rad, of the arc, counter-clockwise from the right
  constexpr double kTo = 0.85 * std::numbers::pi;
  constexpr int kPieces = 24;
  const double pixel = 1.0 / in.camera.scale;
  const double width = kForceWidth * in.options.line_scale;
  const Vec2 at = in.frame.state.position(i);
  const double radius =
      std::max(bounding_radius(body_of(in, i).shape) + 8.0 * pixel, kLeastTorqueRadius * pixel);
  const auto point = [&](int k) {
    const double share = static_cast<double>(torque > 0.0 ? k : kPieces - k) / kPieces;
    const double angle = kFrom + (kTo - kFrom) * share;
    return Vec2(at + radius * Vec2(std::cos(angle), std::sin(angle)));
  };
  Pen pen(out.segments, color, width);
  for (int k = 0; k < kPieces; ++k) pen.line(point(k), point(k + 1));
  const Vec2 tangent = (point(kPieces) - point(kPieces - 1)).normalized();
  out.arrows.push_back(
      {point(kPieces), point(kPieces) + tangent * (9.0 * in.options.line_scale * pixel), color, width});
  add_label(in, at + Vec2(0.0, radius + kLabelRoom * pixel), number_text(torque, 3) + QStringLiteral(" N·m"),
            color, out);
}

}  // namespace

double share_at(const AppliedForce& force, double time) {
  if (time < force.start || (force.end && time >= *force.end)) return 0.0;
  return force.rise > 0.0 ? std::min(1.0, (time - force.start) / force.rise) : 1.0;
}

void add_hand(const DrawingInput& in, Drawing& out) {
  if (!in.frame.hand) return;
  const HandState& hand = *in.frame.hand;
  const double thick = in.options.line_scale;
  const double pixel = 1.0 / in.camera.scale;
  Pen pen(out.segments, in.theme.accent, kSpringWidth * thick);
  pen.dot(hand.grip, kAnchorDot * thick);
  pen.dot(hand.place, kAnchorDot * thick);
  const Vec2 line = hand.place - hand.grip;
  if (line.norm() < kLeastZigzag * thick * pixel) {
    pen.line(hand.grip, hand.place);
  } else {
    pen.zigzag(hand.grip, hand.place, turned(line.normalized()) * (kAmplitude * thick * pixel));
  }
  const Vec2 above = hand.place + Vec2(0.0, kLabelRoom * pixel);
  constexpr double kDrop = 4.0;  // px
  out.labels.push_back({above, kDrop, number_text(hand.force.norm(), 3) + QStringLiteral(" N"), in.theme.text});
}

void add_springs(const DrawingInput& in, const WorldRect& seen, Drawing& out) {
  if (!in.frame.bodies || !in.frame.forces || in.frame.forces->springs.empty()) return;
  const Names names(in.frame);
  for (const Spring& spring : in.frame.forces->springs) {
    const int body = names[spring.body];
    const int other = spring.to.empty() ? -1 : names[spring.to];
    if (body < 0 || (other < 0 && !spring.to.empty())) continue;
    const Vec2 a = place_of(in, body, spring.point);
    const Vec2 b = place_of(in, other, spring.anchor);
    const double slack = (kAmplitude + kPlate) * in.options.line_scale / in.camera.scale;
    if (seen.meets((a + b) / 2, (a - b).norm() / 2 + slack)) add_spring(in, spring, body, other, out);
  }
}

void add_drives(const DrawingInput& in, const WorldRect& seen, Drawing& out) {
  if (!in.frame.bodies) return;
  const int count = std::min(in.frame.state.size(), static_cast<int>(in.frame.bodies->size()));
  for (int i = 0; i < count; ++i) {
    const Body& body = body_of(in, i);
    if (!body.drive || !seen.meets(in.frame.state.position(i), bounding_radius(body.shape))) continue;
    hatch(in, i, seen, out);
    add_drive(in, i, *body.drive, out);
  }
}

void add_applied_forces(const DrawingInput& in, const WorldRect& seen, Drawing& out) {
  if (!in.frame.bodies || !in.frame.forces || in.frame.forces->applied.empty()) return;
  const Names names(in.frame);
  const QColor& color = in.theme.series[2];
  for (const AppliedForce& applied : in.frame.forces->applied) {
    const int i = names[applied.body];
    const double share = share_at(applied, in.frame.time);
    if (i < 0 || !(share > 0.0)) continue;
    const Vec2 at = place_of(in, i, applied.point);
    const Vec2 force = share * applied.force;
    const Vec2 arrow = force * in.arrows.metres_per_newton;
    const double reach = arrow.norm() + applied.point.norm() + 2 * bounding_radius(body_of(in, i).shape);
    if (!seen.meets(at, reach)) continue;
    if (arrow.norm() * in.camera.scale >= kLeastForceArrow) {
      out.arrows.push_back({at, at + arrow, color, kForceWidth * in.options.line_scale});
      // On the side away from the shaft.
      const Vec2 label = at + arrow + Vec2(0.0, arrow.y() > 0.0 ? kLabelRoom / in.camera.scale : 0.0);
      add_label(in, label, number_text(force.norm(), 3) + QStringLiteral(" N"), color, out);
    }
    if (applied.torque != 0.0) add_torque(in, i, share * applied.torque, color, out);
  }
}

Vec2 force_on_b(const ContactForce& contact) {
  return contact.normal_force * contact.normal + contact.tangential_force * turned(contact.normal);
}

void add_contact_forces(const DrawingInput& in, const WorldRect& seen, Drawing& out) {
  if (!in.frame.bodies) return;
  const QColor& color = in.theme.series[1];
  const int count = std::min(in.frame.state.size(), static_cast<int>(in.frame.bodies->size()));
  const double scale = in.options.line_scale;
  const std::size_t before = out.arrows.size();
  for (const ContactForce& contact : in.frame.contacts) {
    if (contact.a < 0 || contact.b < 0 || contact.a >= count || contact.b >= count) continue;
    const double side = has_infinite_mass(body_of(in, contact.b)) ? -1.0 : 1.0;
    const Vec2 arrow = side * in.arrows.metres_per_newton * force_on_b(contact);
    if (!(arrow.norm() * in.camera.scale >= kLeastContactArrow) || !seen.meets(contact.point, arrow.norm())) {
      continue;
    }
    out.segments.push_back({contact.point, contact.point, color, kContactDot * scale});
    out.arrows.push_back({contact.point, contact.point + arrow, color, kContactWidth * scale});
  }
  if (out.arrows.size() == before) return;
  const double a_newton = in.arrows.metres_per_newton * in.camera.scale;  // px
  out.force_key = arrow_key(kLongestKey * scale, a_newton, kContactWidth * scale, color);
}

}  // namespace carom
