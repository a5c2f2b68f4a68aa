#pragma once

#include <QPixmap>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/record/frame.h"
#include "widgets/run/experiment_list.h"
#include "widgets/theme/theme.h"

namespace carom {

// The built-in experiments for the list; for an unreadable one, the reason.
[[nodiscard]] std::vector<ExperimentItem> library_items();
// Its first moment. Throws SceneError.
[[nodiscard]] Frame start_frame(const Preset& preset);
// Small pictures of their initial states, in the same order; `pixels` is the ratio of image to screen pixels.
[[nodiscard]] std::vector<QPixmap> library_pictures(const Theme& theme, double pixels);

}  // namespace carom
