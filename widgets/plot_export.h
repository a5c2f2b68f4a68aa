#pragma once

#include <QPixmap>
#include <QString>

namespace carom {

class RunPlot;

// A plot as it stands, with title, unit and legend, on white: by the file's suffix (see save_picture), or as
// pixels for the clipboard. The size is that of the plot on the screen.
[[nodiscard]] bool save_plot_picture(RunPlot& plot, const QString& path, QString* error);
[[nodiscard]] QPixmap plot_picture(RunPlot& plot);

}  // namespace carom
