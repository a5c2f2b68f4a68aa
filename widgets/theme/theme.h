#pragma once

#include <QColor>
#include <QIcon>
#include <QPen>
#include <QString>
#include <array>

class QApplication;

namespace carom {

// The colours of the window, one value for each role; light and dark are two values of this type.
struct Theme {
  bool dark = false;
  QColor window, panel, border;
  QColor text, muted;
  QColor accent, accent_ground;
  QColor danger;  // of what can't be, on panel and window
  QColor scene_ground, grid, strong_grid;
  QColor body_fill, body_line;
  QColor wall_fill, wall_line;
  std::array<QColor, 6>
      series;  // methods and curves, in order, safe for the colour-blind; each also has its dash
};

[[nodiscard]] const Theme& light_theme();
[[nodiscard]] const Theme& dark_theme();

// The dash of the curve or outline number `index`: colour is never the only distinction.
[[nodiscard]] Qt::PenStyle series_dash(int index);

// Interpolates by `share` from one colour to the other.
[[nodiscard]] QColor blend(const QColor& from, const QColor& to, double share);

// Palette, font and style sheet of the whole program.
void apply_theme(QApplication& application, const Theme& theme);

// One of the icons of widgets/icons, drawn in the given colour (the disabled state fainter). Null if there is
// none.
[[nodiscard]] QIcon themed_icon(const QString& name, const QColor& color);

}  // namespace carom
