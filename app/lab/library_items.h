#pragma once

#include <QPixmap>
#include <vector>

#include "widgets/run/experiment_list.h"
#include "widgets/theme/theme.h"

namespace carom {

// The built-in experiments for the list; of one that can't be read, why.
[[nodiscard]] std::vector<ExperimentItem> library_items();
// Their starts as small pictures, in the same order; `pixels` for one of the screen's.
[[nodiscard]] std::vector<QPixmap> library_pictures(const Theme& theme, double pixels);

}  // namespace carom
