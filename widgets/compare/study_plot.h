#pragma once

#include <QString>

#include "physics/study/study_table.h"
#include "widgets/theme/theme.h"

namespace carom {

class OutputFile;

// Draws a study as a picture of its own: error in position against wall time and against the step, both axes
// logarithmic, drawn by Qwt; beside them the fitted orders, which are the legend too: a colour for each
// integrator, a line and a marker for each choice of impacts. Below: the compared runs, and the horizon up to
// which the comparison is meaningful. Saved by the suffix of `path` (see save_picture). Needs an application,
// but no display.
[[nodiscard]] bool save_study_picture(const StudyTable& table, const Theme& theme, const QString& path,
                                      QString* error);
// Writes the same to an open file; the caller commits it. Throws SceneError.
void write_study_picture(OutputFile& file, const StudyTable& table, const Theme& theme);

}  // namespace carom
