#pragma once

#include <QFont>
#include <QRectF>
#include <cstddef>
#include <vector>

#include "widgets/scene/drawing.h"
#include "widgets/scene/obstacles.h"

namespace carom {

// Where the texts of a drawing stand, in px.

// The painter's font, as large as the drawing's texts.
[[nodiscard]] QFont sized_font(QFont font, double pixels, QFont::Weight weight);

// px, left free on both sides of a name.
inline constexpr double kNameGap = 2.0;

struct NamePlace {
  std::size_t label = 0;  // of the drawing
  QRectF rect;
};
// Below their bodies, lower where something is in the way; else within their bodies, above or beside them: a
// name on another body that moves would be unreadable, or taken for that one's. Without such a place, or where
// names would overlap, the later one is left out.
[[nodiscard]] std::vector<NamePlace> name_places(const Drawing& drawing, const Camera& camera,
                                                 const QFont& font, const Obstacles& obstacles);

// Of the texts of the picked impact, one each: beside their points, or near by, clear of the bodies, the arrows
// and one another, and within the view.
[[nodiscard]] QFont font_of(const Drawing::JumpText& text, const Drawing& drawing, const QFont& font);
[[nodiscard]] std::vector<QRectF> jump_places(const Drawing& drawing, const Camera& camera, const QFont& font,
                                              Obstacles obstacles);

}  // namespace carom
