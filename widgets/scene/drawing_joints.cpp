#include "widgets/scene/drawing_joints.h"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>
#include <variant>

#include "physics/math/vectors.h"

namespace carom {
namespace {

constexpr double kRodWidth = 3.2;     // px
constexpr double kStringWidth = 1.4;  // px
constexpr double kEndDot = 5.0;       // px, where a rod or a string is fastened to a body
constexpr double kPlaneDot = 8.0;     // px, and to the plane
constexpr double kRing = 9.0;         // px, a pin's
constexpr double kHole = 5.0;         // px
constexpr int kPieces = 24;           // of a slack string
constexpr double kBondWidth = 1.2;    // px, of each line of a weld across a gap
constexpr double kBondGap = 4.0;      // px, between the two
constexpr double kApart = 1.0;        // px, of a gap that is seen

using Curve = std::array<Vec2, kPieces + 1>;

// The parabola between two ends with the sag `sag` below the middle of its chord, along `down`.
Curve parabola(const JointState& joint, const Vec2& down, double sag) {
  Curve curve;
  for (int i = 0; i <= kPieces; ++i) {
    const double share = static_cast<double>(i) / kPieces;
    curve[static_cast<std::size_t>(i)] =
        joint.from + share * (joint.to - joint.from) + 4.0 * share * (1.0 - share) * sag * down;
  }
  return curve;
}

double length_of(const Curve& curve) {
  double length = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) length += (curve[i] - curve[i - 1]).norm();
  return length;
}

// Its arc is as long as the string: close to the shape of a light one.
Curve slack(const JointState& joint, const Vec2& down) {
  constexpr int kHalvings = 30;
  double low = 0.0;
  double high = joint.length;  // a string folded back on itself would be too long
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (length_of(parabola(joint, down, middle)) < joint.length ? low : high) = middle;
  }
  return parabola(joint, down, low);
}

class JointPen {
 public:
  JointPen(const DrawingInput& in, Drawing& out) : in_(in), out_(out) {}

  void rod(const JointState& joint) {
    line(joint.from, joint.to, kRodWidth, kFirm);
    ends(joint);
  }
  void string(const JointState& joint) {
    if (joint.taut) {
      line(joint.from, joint.to, kStringWidth, kFirm);
    } else {
      const bool heavy = in_.frame.forces && !in_.frame.forces->gravity.isZero(0.0);
      const Curve curve =
          slack(joint, heavy ? Vec2(in_.frame.forces->gravity.normalized()) : Vec2(-Vec2::UnitY()));
      for (std::size_t i = 1; i < curve.size(); ++i) line(curve[i - 1], curve[i], kStringWidth, kLoose);
    }
    ends(joint);
  }
  void pin(const JointState& joint) {
    dot(joint.to, kRing, in_.theme.text);
    dot(joint.to, kHole, in_.theme.scene_ground);
    if (joint.in_plane) dot(joint.to, kHole / 2, in_.theme.text);
  }
  void weld(const JointState& joint) { dot(joint.to, joint.in_plane ? kPlaneDot : kEndDot, in_.theme.text); }

  // A double line from a body to its weld.
  void bond(const Vec2& from, const Vec2& to) {
    if (from == to) return;
    const double half = 0.5 * kBondGap * in_.options.line_scale / in_.camera.scale;
    const Vec2 aside = half * crossed((to - from).normalized());
    for (const Vec2& shift : {aside, Vec2(-aside)}) line(from + shift, to + shift, kBondWidth, kFirm);
  }

 private:
  static constexpr double kFirm = 0.3;  // of the way to the ground's colour
  static constexpr double kLoose = 0.5;

  void line(const Vec2& from, const Vec2& to, double width, double pale) {
    out_.segments.push_back(
        {from, to, blend(in_.theme.text, in_.theme.scene_ground, pale), width * in_.options.line_scale});
  }
  void dot(const Vec2& at, double size, const QColor& color) {
    out_.segments.push_back({at, at, color, size * in_.options.line_scale});
  }
  void ends(const JointState& joint) {
    dot(joint.from, joint.in_plane ? kPlaneDot : kEndDot, in_.theme.text);
    dot(joint.to, kEndDot, in_.theme.text);
  }

  const DrawingInput& in_;
  Drawing& out_;
};

// Welds of bodies that don't reach their common point are lines, from centre to centre. Those that impacts make
// touch.
class Bonds {
 public:
  explicit Bonds(const DrawingInput& in) : in_(in) {
    const auto welded = [](const JointState& joint) { return joint.kind == JointKind::kWeld; };
    const Frame& frame = in.frame;
    if (!frame.bodies || std::none_of(frame.joints.begin(), frame.joints.end(), welded)) return;
    scene_ = frame.scene ? frame.scene.get() : frame.setup ? &frame.setup->scene : nullptr;
    const auto count = std::min(frame.bodies->size(), static_cast<std::size_t>(frame.state.size()));
    for (std::size_t i = 0; i < count; ++i) index_.emplace((*frame.bodies)[i].name, static_cast<int>(i));
  }

  void draw(const WorldRect& seen, JointPen& pen) const {
    if (scene_ == nullptr) return;
    for (const Joint& joint : scene_->joints) {
      const auto first = index_.find(joint.body);
      const auto second = index_.find(joint.to);
      if (joint.kind != JointKind::kWeld || first == index_.end() || second == index_.end()) continue;
      const Vec2 place =
          in_.frame.state.position(first->second) + turned_by(in_.frame.state.q(2, first->second), joint.point);
      if (reaches(first->second, place) && reaches(second->second, place)) continue;
      for (const int body : {first->second, second->second}) {
        const Vec2 centre = centre_of(body, place);
        if (seen.meets(0.5 * (centre + place), (centre - place).norm())) pen.bond(centre, place);
      }
    }
  }

 private:
  [[nodiscard]] const Body& body_of(int i) const { return (*in_.frame.bodies)[static_cast<std::size_t>(i)]; }
  [[nodiscard]] bool reaches(int i, const Vec2& place) const {
    const Vec2 own = turned_by(-in_.frame.state.q(2, i), place - in_.frame.state.position(i));
    return signed_distance(body_of(i).shape, own) * in_.camera.scale <= kApart;
  }
  // Of a wall, which may be endless, the nearest point of its line.
  [[nodiscard]] Vec2 centre_of(int i, const Vec2& place) const {
    Vec2 centre = in_.frame.state.position(i);
    if (!std::holds_alternative<Wall>(body_of(i).shape)) return centre;
    const Vec2 along = turned_by(in_.frame.state.q(2, i), Vec2::UnitX());
    return centre + along.dot(place - centre) * along;
  }

  const DrawingInput& in_;
  const Scene* scene_ = nullptr;
  std::unordered_map<std::string, int> index_;
};

}  // namespace

void add_joints(const DrawingInput& in, const WorldRect& seen, Drawing& out) {
  JointPen pen(in, out);
  Bonds(in).draw(seen, pen);
  // The dots of joints come last, over the bars.
  for (const bool joints : {false, true}) {
    for (const JointState& joint : in.frame.joints) {
      const bool line = joint.kind == JointKind::kRod || joint.kind == JointKind::kString;
      const double room = kRing * in.options.line_scale / in.camera.scale;
      if (line == joints || !seen.meets(0.5 * (joint.from + joint.to), (line ? joint.length : 0.0) + room))
        continue;
      if (joint.kind == JointKind::kRod) pen.rod(joint);
      if (joint.kind == JointKind::kString) pen.string(joint);
      if (joint.kind == JointKind::kPin) pen.pin(joint);
      if (joint.kind == JointKind::kWeld) pen.weld(joint);
    }
  }
}

}  // namespace carom
