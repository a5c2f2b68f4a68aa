#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>
#include <optional>
#include <utility>
#include <vector>

#include "physics/record/aim.h"
#include "physics/scene/scene.h"
#include "widgets/scene/bubble.h"
#include "widgets/scene/camera.h"
#include "widgets/scene/direction_arc.h"
#include "widgets/scene/handles.h"
#include "widgets/scene/obstacles.h"
#include "widgets/scene/overlap.h"
#include "widgets/theme/theme.h"

class QPainter;

namespace carom {

// What the tools show over the scene on the screen, never in saved pictures.
struct Overlay {
  struct Ghost {
    Body body;  // as it was when the drag began
    bool arrow = false;
  };
  // A polygon that is drawn corner by corner, in m.
  struct Corners {
    std::vector<Vec2> set;
    std::optional<Vec2> refused;
    std::optional<Vec2> next;  // at the mouse
    bool fault = false;        // of the next one
  };
  // A joint, spring or force that is drawn, or chosen.
  struct Link {
    Vec2 from = Vec2::Zero();  // m
    Vec2 to = Vec2::Zero();    // m
    bool arrow = false;
    bool chosen = false;
    bool fault = false;
    bool was = false;  // when the drag of its end began
  };
  std::vector<Body> selected;
  std::vector<Body> locked;
  std::vector<Body> lit;  // that an end is put on
  std::vector<Link> links;
  std::vector<Ghost> ghosts;
  std::vector<Handle> handles;
  std::vector<Handle> grips;   // the same, and those that a drag hides: texts stand clear of them
  std::optional<QRectF> band;  // px, of the selection
  std::optional<Body> drawn;   // a body that is being drawn
  Corners corners;
  double arrow_seconds = 0.0;             // m of arrow per m/s, for ghosts
  std::optional<DirectionArc> direction;  // of a velocity that is being pulled
  Bubble bubble;
  std::vector<std::pair<Vec2, Vec2>> guides;     // m, from a dragged body to what it snapped to
  std::vector<Overlap> overlaps;                 // their shared areas
  std::optional<std::pair<Vec2, Vec2>> blocked;  // m, the ends of a joint that allows nothing
  std::vector<Vec2> signs;                       // m, of overlaps that stay
  std::vector<std::pair<Vec2, Vec2>> refused;    // m, edges that a body can't have
  std::optional<Aim> aim;                        // to the first impact

  [[nodiscard]] bool empty() const {
    return selected.empty() && locked.empty() && lit.empty() && links.empty() && ghosts.empty() &&
           handles.empty() && !band && !drawn && corners.set.empty() && !corners.next &&
           bubble.value.isEmpty() && guides.empty() && overlaps.empty() && signs.empty() && refused.empty() &&
           !blocked && !aim;
  }
};

// Whether the mouse is on the sign of an overlap whose middle is there, in px.
[[nodiscard]] bool on_sign(const QPointF& middle, const QPointF& mouse);

// px: of the words at the first impact.
[[nodiscard]] QRectF text_place(const Aim& aim, const Camera& camera);

// What the bubble stands clear of: the handles, arrows and ghosts of what is selected or dragged, and the way
// to the first impact.
[[nodiscard]] Obstacles obstacles_of(const Overlay& overlay, const Camera& camera);

// px: the handles, and the signs of overlaps, which names stand clear of.
[[nodiscard]] Obstacles obstacles_of_names(const Overlay& overlay, const Camera& camera);

void paint_tools(QPainter& painter, const Overlay& overlay, const Camera& camera, const Theme& theme);

}  // namespace carom
