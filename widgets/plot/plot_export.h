#pragma once

#include <QPixmap>
#include <QRectF>
#include <QString>

class QPainter;

namespace carom {

class RunPlot;

// Exports a plot as shown, with title, unit and legend, on white: to a file by its suffix (see save_picture),
// or as an image for the clipboard. The size is that of the plot on the screen.
[[nodiscard]] bool save_plot_picture(RunPlot& plot, const QString& path, QString* error);
[[nodiscard]] QPixmap plot_picture(RunPlot& plot);
// Paints the same into a rectangle of a page, with a painter scaled to px; text is aligned to its edges.
void paint_plot(RunPlot& plot, QPainter& painter, const QRectF& where);

}  // namespace carom
