#pragma once

#include <QPixmap>
#include <vector>

#include "widgets/run/experiment_list.h"
#include "widgets/theme/theme.h"

namespace carom {

// The built-in experiments for the list; for an unreadable one, the reason.
[[nodiscard]] std::vector<ExperimentItem> library_items();
// Small pictures of their initial states, in the same order; `pixels` is the ratio of image to screen pixels.
[[nodiscard]] std::vector<QPixmap> library_pictures(const Theme& theme, double pixels);

}  // namespace carom
