#include "widgets/scene/drawing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "widgets/scene/drawing_before.h"
#include "widgets/scene/drawing_forces.h"
#include "widgets/scene/drawing_impacts.h"
#include "widgets/scene/drawing_joints.h"
#include "widgets/scene/drawing_jump.h"
#include "widgets/scene/drawing_others.h"
#include "widgets/scene/drawing_shapes.h"
#include "widgets/scene/scale_row.h"

namespace carom {
namespace {

constexpr double kArrowWidth = 2.0;           // px
constexpr double kLeastArrow = 6.0;           // px, shorter ones are left out
constexpr double kLongestKey = 80.0;          // px
constexpr double kRounding = 1e-9;            // of the view's shorter side a second: a slower speed is rounding
constexpr double kLongestShare = 0.22;        // of the view's shorter side, for a peak's arrow
constexpr double kLongestInCrowd = 1.5;       // of the mean distance of bodies that fill a square view
constexpr double kLeastNamedRadius = 6.0;     // px
constexpr double kLeastOrientedRadius = 4.0;  // px
constexpr double kNameDrop = 3.0;             // px below the body
constexpr double kHandles = 18.0;             // px, further below a selected body: room for its handles
constexpr double kPointRadius = 2.0;          // px, of the dot that shows a body too small to be seen
constexpr double kThinWall = 3.0;             // px

// m: how far down a shape without a half-plane reaches from its centre of mass.
double lowest(const Shape& shape, double angle) {
  const Outline outline = outline_of(shape);
  double low = 0.0;
  for (const Vec2& v : outline.vertices) low = std::min(low, turned_by(angle, v).y() - outline.rounding);
  return low;
}

class Builder {
 public:
  Builder(const DrawingInput& input, Drawing& out) : in_(input), out_(out), seen_(input.camera.visible()) {
    if (in_.frame.bodies) bodies_ = *in_.frame.bodies;
  }

  void build() {
    out_.outline = 1.5 * in_.options.line_scale;
    out_.text_size = in_.options.text_size;
    out_.has_grid = in_.options.grid;
    if (out_.has_grid) place_grid(in_.camera, out_.grid);
    add_run_before(in_, seen_, out_);
    for (int i = 0; i < count(); ++i) add_body(i);
    add_springs(in_, seen_, out_);
    add_hand(in_, out_);
    add_drives(in_, seen_, out_);
    add_joints(in_, seen_, out_);
    add_other_runs(in_, seen_, out_);
    jumped_ = bodies_of_jump(in_);
    if (in_.options.names) add_names();
    if (in_.options.velocities) add_velocities();
    if (in_.options.forces) add_applied_forces(in_, seen_, out_);
    if (in_.options.contacts) {
      add_contact_forces(in_, seen_, out_);
      add_impacts(in_, seen_, out_);
    }
    add_jump(in_, out_);
  }

 private:
  // The frame's state and bodies should have one size; never read past the shorter one.
  [[nodiscard]] int count() const { return std::min(in_.frame.state.size(), static_cast<int>(bodies_.size())); }
  [[nodiscard]] bool fixed(int i) const { return bodies_[static_cast<std::size_t>(i)].fixed; }
  // Moved by impacts and forces: neither fixed nor driven.
  [[nodiscard]] bool free(int i) const { return !has_infinite_mass(bodies_[static_cast<std::size_t>(i)]); }

  void add_body(int i) {
    const Body& body = bodies_[static_cast<std::size_t>(i)];
    const Vec2 at = in_.frame.state.position(i);
    const double angle = in_.frame.state.q(2, i);
    if (!seen_.meets(at, bounding_radius(body.shape) + out_.outline / in_.camera.scale)) return;
    const QColor& fill = free(i) ? in_.theme.body_fill : in_.theme.wall_fill;
    const QColor& line = free(i) ? in_.theme.body_line : in_.theme.wall_line;
    const Counts before = counts();
    add_shape(body.shape, at, angle, free(i), fill, line);
    if (!body.fixed) name_items(i, before);
  }

  struct Counts {
    std::size_t boxes;
    std::size_t polygons;
    std::size_t discs;
  };
  [[nodiscard]] Counts counts() const { return {out_.boxes.size(), out_.polygons.size(), out_.discs.size()}; }
  // Those since then are of this body.
  void name_items(int body, const Counts& since) {
    for (std::size_t k = since.boxes; k < out_.boxes.size(); ++k) out_.boxes[k].body = body;
    for (std::size_t k = since.polygons; k < out_.polygons.size(); ++k) out_.polygons[k].body = body;
    for (std::size_t k = since.discs; k < out_.discs.size(); ++k) out_.discs[k].body = body;
  }

  void add_shape(const Shape& shape, const Vec2& at, double angle, bool free, const QColor& fill,
                 const QColor& line) {
    if (const Disc* disc = std::get_if<Disc>(&shape)) {
      const bool oriented = free && disc->radius * in_.camera.scale >= kLeastOrientedRadius;
      out_.discs.push_back({at, disc->radius, angle, fill, line, oriented});
      if (disc->radius * in_.camera.scale < kPointRadius)
        out_.segments.push_back({at, at, line, 2.0 * kPointRadius * in_.options.line_scale});
    } else if (const Box* box = std::get_if<Box>(&shape)) {
      out_.boxes.push_back({at, Vec2(box->width, box->height) / 2, angle, fill, line});
    } else if (const Wall* wall = std::get_if<Wall>(&shape)) {
      add_wall(*wall, at, angle, fill, line);
    } else if (const Compound* compound = std::get_if<Compound>(&shape)) {
      const Vec2 centre = centre_of(*compound);
      for (const PlacedShape& placed : compound->shapes) {
        add_shape(shape_of(placed.shape), at + turned_by(angle, placed.position - centre), angle + placed.angle,
                  false, fill, line);
      }
    } else {
      add_polygon(shape, at, angle, fill, line, out_);
    }
  }

  // The part of a half-plane that fills the view.
  void add_wall(const Wall& wall, const Vec2& at, double angle, const QColor& fill, const QColor& line) {
    const Vec2 along(std::cos(angle), std::sin(angle));
    if (wall.length) {
      const Vec2 half = 0.5 * *wall.length * along;
      out_.lines.push_back({at - half, at + half, line, kThinWall * in_.options.line_scale});
      return;
    }
    const Vec2 middle = 0.5 * (seen_.lower + seen_.upper);
    const double radius = (seen_.upper - seen_.lower).norm();
    const Vec2 inwards(along.y(), -along.x());
    const double depth = inwards.dot(middle - at) + radius;  // of the farthest point in the view
    if (!(depth > 0.0)) return;
    const Vec2 surface = at + along.dot(middle - at) * along;
    out_.boxes.push_back({surface + 0.5 * depth * inwards, {radius, 0.5 * depth}, angle, fill, line});
  }

  [[nodiscard]] bool is_selected(int i) const {
    const std::string& name = bodies_[static_cast<std::size_t>(i)].name;
    return std::find(in_.selected.begin(), in_.selected.end(), name) != in_.selected.end();
  }
  // Whether its velocity and name stand with the picked impact.
  [[nodiscard]] bool in_jump(int i) const {
    return std::find(jumped_.begin(), jumped_.end(), i) != jumped_.end();
  }

  void add_names() {
    if (std::count_if(bodies_.begin(), bodies_.end(), [](const Body& b) { return !b.fixed; }) > kMostNames) {
      return;
    }
    // Fainter than text, but readable on walls.
    const QColor color = blend(in_.theme.text, in_.theme.scene_ground, 0.25);
    for (int i = 0; i < count(); ++i) {
      const Body& body = bodies_[static_cast<std::size_t>(i)];
      const Vec2 half = half_extent(body.shape, in_.frame.state.q(2, i));
      const Vec2 at = in_.frame.state.position(i);
      if (body.fixed || in_jump(i) || half.minCoeff() * in_.camera.scale < kLeastNamedRadius) continue;
      if (!seen_.meets(at, bounding_radius(body.shape))) continue;
      const double drop = kNameDrop + out_.outline / 2 + (is_selected(i) ? kHandles : 0.0);
      const double angle = in_.frame.state.q(2, i);
      const double low = lowest(body.shape, angle);
      const double high = -lowest(body.shape, angle + std::numbers::pi);
      out_.labels.push_back({at + Vec2(0.0, low), drop, QString::fromStdString(body.name), color, high - low,
                             Drawing::LabelItem::Named{i, at, half.x()}});
    }
  }

  void add_velocities() {
    bool moves = false;
    for (int i = 0; i < count(); ++i) {
      if (fixed(i)) continue;
      const Vec2 along = in_.frame.state.velocity(i) * in_.arrows.seconds;
      moves = moves || in_jump(i) || !along.isZero(0.0);
      // A selected body keeps its own arrow, to be pulled.
      if (!in_jump(i) || is_selected(i))
        add_arrow(in_, seen_, {in_.frame.state.position(i), along, in_.theme.series[0]}, out_);
    }
    if (!moves) return;
    const double scale = in_.options.line_scale;
    out_.velocity_key = arrow_key(kLongestKey * scale, in_.arrows.seconds * in_.camera.scale,
                                  kArrowWidth * scale, in_.theme.series[0]);
  }

  const DrawingInput& in_;
  Drawing& out_;
  WorldRect seen_;
  std::span<const Body> bodies_;
  std::vector<BodyIndex> jumped_;
};

}  // namespace

void Drawing::clear() {
  has_grid = false;
  boxes.clear();
  vertices.clear();
  polygons.clear();
  discs.clear();
  lines.clear();
  segments.clear();
  arrows.clear();
  labels.clear();
  marks.clear();
  jump = {};
  velocity_key = {};
  force_key = {};
}

void Peaks::observe(const Frame& frame) {
  if (!frame.bodies) return;
  double mass = 0.0;
  moving = 0;
  const int count = std::min(frame.state.size(), static_cast<int>(frame.bodies->size()));
  for (int i = 0; i < count; ++i) {
    const Body& body = (*frame.bodies)[static_cast<std::size_t>(i)];
    if (body.fixed) continue;
    ++moving;
    if (!body.drive) mass += mass_of(body);
    speed = std::max(speed, frame.state.velocity(i).norm());
  }
  const double energy = frame.totals.energy();
  if (mass > 0.0 && energy > 0.0) speed = std::max(speed, std::sqrt(2.0 * energy / mass));
  for (const ImpactRecord& impact : frame.impacts) impulse = std::max(impulse, impact.normal_impulse);
  contact_force *= frame.time < time ? 0.0 : std::exp((time - frame.time) / kContactMemory);
  time = frame.time;
  for (const ContactForce& contact : frame.contacts) {
    contact_force = std::max(contact_force, force_on_b(contact).norm());
  }
  largest_contact_force = std::max(largest_contact_force, contact_force);
  contact_force = std::max(contact_force, kLeastShare * largest_contact_force);
  if (!frame.forces) return;
  for (const AppliedForce& applied : frame.forces->applied) force = std::max(force, applied.force.norm());
}

ArrowScale arrow_scale(const Peaks& peaks, double side) {
  ArrowScale scale;
  const double longest = side * std::min(kLongestShare, kLongestInCrowd / std::sqrt(std::max(1, peaks.moving)));
  if (peaks.speed > kRounding * side) scale.seconds = step_not_above(longest / peaks.speed);
  if (peaks.impulse > 0.0) scale.metres_per_impulse = step_not_above(longest / peaks.impulse);
  const double force = std::max(peaks.force, peaks.contact_force);
  if (force > 0.0) scale.metres_per_newton = step_not_above(longest / force);
  return scale;
}

ArrowScale operator*(ArrowScale scale, const ArrowTimes& times) {
  scale.seconds *= times.velocity;
  scale.metres_per_newton *= times.force;
  return scale;
}

bool add_arrow(const DrawingInput& in, const WorldRect& seen, const NewArrow& arrow, Drawing& out) {
  const double length = arrow.along.norm();
  if (!(length * in.camera.scale >= kLeastArrow) || !seen.meets(arrow.from, length)) return false;
  out.arrows.push_back(
      {arrow.from, arrow.from + arrow.along, arrow.color, kArrowWidth * in.options.line_scale});
  return true;
}

Drawing make_drawing(const DrawingInput& input, Drawing reuse) {
  reuse.clear();
  Builder(input, reuse).build();
  return reuse;
}

namespace {

// Of the bodies that count.
WorldRect bounds_of_bodies(const Frame& frame, const auto& counts) {
  WorldRect rect;
  if (!frame.bodies) return rect;
  const int count = std::min(frame.state.size(), static_cast<int>(frame.bodies->size()));
  for (int i = 0; i < count; ++i) {
    const Body& body = (*frame.bodies)[static_cast<std::size_t>(i)];
    if (!counts(body) || !frame.state.q.col(i).allFinite()) continue;
    const Vec2 half = half_extent(body.shape, frame.state.q(2, i));
    // A half-plane counts by its position.
    rect.include(frame.state.position(i), half.allFinite() ? half : Vec2(Vec2::Zero()));
  }
  return rect;
}

}  // namespace

WorldRect bounds(const Frame& frame, const std::vector<std::string>& names) {
  return bounds_of_bodies(frame, [&names](const Body& body) {
    return !is_half_plane(body.shape) && std::find(names.begin(), names.end(), body.name) != names.end();
  });
}

WorldRect bounds(const Frame& frame) {
  WorldRect rect = bounds_of_bodies(frame, [](const Body&) { return true; });
  if (frame.forces) {
    for (const Spring& spring : frame.forces->springs) {
      if (spring.to.empty()) rect.include(spring.anchor, Vec2::Zero());
    }
  }
  for (const JointState& joint : frame.joints) {
    if (joint.in_plane) rect.include(joint.from, Vec2::Zero());
  }
  return rect;
}

}  // namespace carom
