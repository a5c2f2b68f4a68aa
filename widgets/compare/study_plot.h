#pragma once

#include <QString>

#include "physics/study/study_table.h"
#include "widgets/theme/theme.h"

namespace carom {

class OutputFile;

// Draws a study as a picture of its own: error in position against wall time and against the step, both axes
// logarithmic, drawn by Qwt; beside them the fitted orders, which are the legend too: a colour for each
// integrator, a line and a marker for each choice of impacts. Below: what was compared with what, and up to
// when it means anything. Saved by the suffix of `path` (see save_picture). Needs an application, but no
// display.
[[nodiscard]] bool save_study_picture(const StudyTable& table, const Theme& theme, const QString& path,
                                      QString* error);
// The same into a file that is open already, for its owner to commit. Throws SceneError.
void write_study_picture(OutputFile& file, const StudyTable& table, const Theme& theme);

}  // namespace carom
