#pragma once

#include <QRectF>

class QPainter;
class QwtPlot;

namespace carom {

// Paints a plot without ground and frame into `where`, in px of a painter that was scaled to px already, as
// those of save_picture() are. Qwt itself would scale once more, to the resolution of the device.
void render_plot(QwtPlot& plot, QPainter& painter, const QRectF& where);

}  // namespace carom
