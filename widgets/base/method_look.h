#pragma once

#include <QColor>
#include <QPen>
#include <qwt_symbol.h>

#include "physics/scene/method.h"
#include "widgets/theme/theme.h"

class QPainter;

namespace carom {

// The look of a study's methods: a colour for each integrator, a line and a marker for each choice of impacts.
[[nodiscard]] QColor color_of(IntegratorId id, const Theme& theme);
[[nodiscard]] QPen line_of(const QColor& color, ImpactsId impacts);
// `size` in px.
[[nodiscard]] QwtSymbol symbol_of(const QColor& color, ImpactsId impacts, const Theme& theme, int size);

// A sample of the line with its marker, `width` px wide.
void draw_sample(QPainter& painter, const QPointF& center, const QColor& color, ImpactsId impacts,
                 const Theme& theme, double width, int marker);

}  // namespace carom
