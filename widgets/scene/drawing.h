#pragma once

#include <QColor>
#include <QPointF>
#include <QString>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "physics/record/frame.h"
#include "widgets/scene/camera.h"
#include "widgets/scene/grid.h"
#include "widgets/theme/theme.h"

namespace carom {

// The scene as a list of plain shapes: in world metres, with colours, and widths in logical pixels. OpenGL and
// QPainter paint the same list. Painted in this order: grid, boxes, polygons, springs and thin walls, discs,
// joints and contact points, arrows, text.
struct Drawing {
  // Of shapes that are not those of a body that can move.
  static constexpr int kNoBody = -1;

  struct DiscItem {
    Vec2 center;
    double radius;
    double angle;  // rad, of the orientation line
    QColor fill;
    QColor line;
    bool oriented;  // draws the line from its centre to its rim
    int body = kNoBody;
  };
  struct BoxItem {
    Vec2 center;
    Vec2 half;  // m, half width and half height
    double angle;
    QColor fill;
    QColor line;
    int body = kNoBody;
  };
  // A convex polygon, its corners rounded.
  struct PolygonItem {
    int first;  // of its vertices in `vertices`, counter-clockwise
    int count;
    double rounding;  // m, added on all sides
    QColor fill;
    QColor line;
    int body = kNoBody;
  };
  // A straight line with round ends; a dot where its ends coincide.
  struct SegmentItem {
    Vec2 from;
    Vec2 to;
    QColor color;
    double width;  // px
  };
  struct ArrowItem {
    Vec2 from;
    Vec2 to;
    QColor color;
    double width;  // px, of the shaft
  };
  // Text centred under a point of the world, or the name of a body.
  struct LabelItem {
    // What has a name.
    struct Named {
      int body;
      Vec2 centre;
      double half_width;  // m
    };
    Vec2 anchor;
    double drop;  // px below the anchor
    QString text;
    QColor color;
    double rise = 0.0;  // m: with no place below the anchor it stands so far above, and `drop`
    std::optional<Named> named{};
  };
  // An arrow of the picked impact.
  struct JumpArrow {
    Vec2 from;
    Vec2 to;
    QColor color;
    double width;  // px, of the shaft
    bool hollow;   // before the impact
  };
  // Text beside a point of the world; lines are parted by line feeds.
  struct JumpText {
    Vec2 at;
    Vec2 side;  // of the point on which it stands: a unit vector, or zero for over it
    QString text;
    QColor color;
    bool strong;
  };
  // The picked impact, painted over all else.
  struct Jump {
    std::vector<std::pair<Vec2, Vec2>> axes;  // one for impacts that share bodies
    std::vector<JumpArrow> arrows;
    std::vector<JumpText> texts;
  };
  // An arrow for a round velocity or force; drawn beside the scale bar.
  struct ArrowKey {
    double amount = 0.0;  // m/s or N; 0: no key
    double length = 0.0;  // px
    double width = 0.0;   // px, of the shaft
    QColor color;
  };

  bool has_grid = false;
  Grid grid;
  std::vector<BoxItem> boxes;
  std::vector<Vec2> vertices;  // of the polygons, m, in the world
  std::vector<PolygonItem> polygons;
  std::vector<SegmentItem> lines;  // over the boxes, under the discs
  std::vector<DiscItem> discs;
  std::vector<SegmentItem> segments;
  std::vector<ArrowItem> arrows;
  std::vector<LabelItem> labels;
  Jump jump;
  std::vector<ImpactRecord> marks;  // impacts that are drawn, for the mouse
  ArrowKey velocity_key;
  ArrowKey force_key;
  double outline = 1.5;   // px, of bodies
  double text_size = 11;  // px

  void clear();  // keeps the capacities
  [[nodiscard]] std::span<const Vec2> corners(const PolygonItem& polygon) const {
    return {vertices.data() + polygon.first, static_cast<std::size_t>(polygon.count)};
  }
};

struct DrawingOptions {
  bool grid = true;
  bool velocities = true;
  bool forces = true;    // applied ones
  bool contacts = true;  // impulses of impacts, forces of resting contacts
  bool names = true;
  bool jumps = true;        // velocities and impulse of the picked impact
  bool run_before = true;   // its bodies, pale
  double line_scale = 1.0;  // dimensionless: 2 in projector mode
  double text_size = 11.0;  // px

  bool operator==(const DrawingOptions&) const = default;
};

// Scales of the arrows.
struct ArrowScale {
  double seconds = 0.1;             // m of arrow per m/s
  double metres_per_impulse = 0.1;  // m of arrow per N s
  double metres_per_newton = 0.1;
};

// By which the user has lengthened arrows, dimensionless.
struct ArrowTimes {
  double velocity = 1.0;
  double force = 1.0;
};
[[nodiscard]] ArrowScale operator*(ArrowScale scale, const ArrowTimes& times);

// The largest speed, impulse and force shown so far; they set the length of the arrows. Forces of resting
// contacts peak during a landing, so only their recent maximum counts.
struct Peaks {
  double speed = 0.0;                  // m/s
  double impulse = 0.0;                // N s
  double force = 0.0;                  // N, applied
  double contact_force = 0.0;          // N, falls by e in kContactMemory
  double largest_contact_force = 0.0;  // N, ever: far below it is rounding
  int moving = 0;                      // bodies; with many, arrows are shorter
  double time = 0.0;                   // s, of the last observed frame

  static constexpr double kContactMemory = 0.1;  // s
  static constexpr double kLeastShare = 1e-3;    // of the largest contact force: lower bound of the recent one

  // Updates the peaks from the frame, and the expected speed from its energy.
  void observe(const Frame& frame);
};

// Round scales that make the arrows of the peaks readable in a view whose shorter side is `side` m.
[[nodiscard]] ArrowScale arrow_scale(const Peaks& peaks, double side);

// Simulated seconds for which an impact is shown, while it fades.
inline constexpr double kImpactShown = 0.25;
// Names are hidden with more moving bodies than this.
inline constexpr int kMostNames = 40;

// Other runs of the same scene, beside the one drawn in full.
using OtherRuns = std::vector<std::shared_ptr<const Frame>>;

// Where the bodies of another run stood, such as of the run before.
struct PlacedBodies {
  std::shared_ptr<const std::vector<Body>> bodies;
  Eigen::Matrix3Xd q;  // m, m, rad: x, y and angle of each
};

struct DrawingInput {
  const Frame& frame;
  std::span<const ImpactRecord> impacts;  // the recent ones
  const Camera& camera;
  const DrawingOptions& options;
  const Theme& theme;
  ArrowScale arrows;
  std::span<const std::shared_ptr<const Frame>> others =
      {};                                      // drawn as outlines, in the colours of the runs after the first
  const JumpMoment* jump = nullptr;            // the picked impact, if its moment is shown
  std::span<const std::string> selected = {};  // bodies with handles
  const PlacedBodies* before = nullptr;        // of the run before, at the same time since its start
};

// An arrow from a point of the world.
struct NewArrow {
  Vec2 from;
  Vec2 along;  // m
  QColor color;
};
// Adds it if it is in view and not too short; false: it is left out.
bool add_arrow(const DrawingInput& input, const WorldRect& seen, const NewArrow& arrow, Drawing& out);

// Builds the list of what the camera sees, reusing the memory of `reuse`.
[[nodiscard]] Drawing make_drawing(const DrawingInput& input, Drawing reuse = {});

// Bounds of all bodies of the frame and of the anchors of springs and joints.
[[nodiscard]] WorldRect bounds(const Frame& frame);
// Of the bodies of these names alone, but for half-planes.
[[nodiscard]] WorldRect bounds(const Frame& frame, const std::vector<std::string>& names);

}  // namespace carom
