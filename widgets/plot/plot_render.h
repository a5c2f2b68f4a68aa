#pragma once

#include <QRectF>

class QPainter;
class QwtPlot;

namespace carom {

// Paints a plot without background and frame into `where`, in px, with a painter already scaled to px, as in
// save_picture(). Qwt itself would scale again, to the resolution of the device.
void render_plot(QwtPlot& plot, QPainter& painter, const QRectF& where);

}  // namespace carom
