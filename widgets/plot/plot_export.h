#pragma once

#include <QPixmap>
#include <QRectF>
#include <QString>

class QPainter;

namespace carom {

class RunPlot;

// A plot as it stands, with title, unit and legend, on white: by the file's suffix (see save_picture), or as
// pixels for the clipboard. The size is that of the plot on the screen.
[[nodiscard]] bool save_plot_picture(RunPlot& plot, const QString& path, QString* error);
[[nodiscard]] QPixmap plot_picture(RunPlot& plot);
// The same into any place on a page, of a painter that is scaled to px; text stands at its edges.
void paint_plot(RunPlot& plot, QPainter& painter, const QRectF& where);

}  // namespace carom
