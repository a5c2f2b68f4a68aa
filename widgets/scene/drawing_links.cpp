#include "widgets/scene/drawing_links.h"

#include <array>

namespace carom {
namespace {

constexpr double kRodWidth = 3.2;     // px
constexpr double kStringWidth = 1.4;  // px
constexpr double kEndDot = 5.0;       // px, where a rod or a string is fastened to a body
constexpr double kPlaneDot = 8.0;     // px, and to the plane
constexpr double kRing = 9.0;         // px, a pin's
constexpr double kHole = 5.0;         // px
constexpr int kPieces = 24;           // of a slack string

using Curve = std::array<Vec2, kPieces + 1>;

// The parabola between two ends that hangs `sag` below the middle of its chord, along `down`.
Curve parabola(const LinkState& link, const Vec2& down, double sag) {
  Curve curve;
  for (int i = 0; i <= kPieces; ++i) {
    const double share = static_cast<double>(i) / kPieces;
    curve[static_cast<std::size_t>(i)] =
        link.from + share * (link.to - link.from) + 4.0 * share * (1.0 - share) * sag * down;
  }
  return curve;
}

double length_of(const Curve& curve) {
  double length = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) length += (curve[i] - curve[i - 1]).norm();
  return length;
}

// As long as the string; what a light one would hang like.
Curve slack(const LinkState& link, const Vec2& down) {
  constexpr int kHalvings = 30;
  double low = 0.0;
  double high = link.length;  // there and back it would be too long
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (length_of(parabola(link, down, middle)) < link.length ? low : high) = middle;
  }
  return parabola(link, down, low);
}

class LinkPen {
 public:
  LinkPen(const DrawingInput& in, Drawing& out) : in_(in), out_(out) {}

  void rod(const LinkState& link) {
    line(link.from, link.to, kRodWidth, kFirm);
    ends(link);
  }
  void string(const LinkState& link) {
    if (link.taut) {
      line(link.from, link.to, kStringWidth, kFirm);
    } else {
      const bool heavy = in_.frame.forces && !in_.frame.forces->gravity.isZero(0.0);
      const Curve curve =
          slack(link, heavy ? Vec2(in_.frame.forces->gravity.normalized()) : Vec2(-Vec2::UnitY()));
      for (std::size_t i = 1; i < curve.size(); ++i) line(curve[i - 1], curve[i], kStringWidth, kLoose);
    }
    ends(link);
  }
  void pin(const LinkState& link) {
    dot(link.to, kRing, in_.theme.text);
    dot(link.to, kHole, in_.theme.scene_ground);
    if (link.in_plane) dot(link.to, kHole / 2, in_.theme.text);
  }
  void weld(const LinkState& link) { dot(link.to, link.in_plane ? kPlaneDot : kEndDot, in_.theme.text); }

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
  void ends(const LinkState& link) {
    dot(link.from, link.in_plane ? kPlaneDot : kEndDot, in_.theme.text);
    dot(link.to, kEndDot, in_.theme.text);
  }

  const DrawingInput& in_;
  Drawing& out_;
};

}  // namespace

void add_links(const DrawingInput& in, const WorldRect& seen, Drawing& out) {
  LinkPen pen(in, out);
  // Joints last: they lie over the bars that they join.
  for (const bool joints : {false, true}) {
    for (const LinkState& link : in.frame.links) {
      const bool line = link.kind == LinkKind::kRod || link.kind == LinkKind::kString;
      const double room = kRing * in.options.line_scale / in.camera.scale;
      if (line == joints || !seen.meets(0.5 * (link.from + link.to), (line ? link.length : 0.0) + room))
        continue;
      if (link.kind == LinkKind::kRod) pen.rod(link);
      if (link.kind == LinkKind::kString) pen.string(link);
      if (link.kind == LinkKind::kPin) pen.pin(link);
      if (link.kind == LinkKind::kWeld) pen.weld(link);
    }
  }
}

}  // namespace carom
