#include <algorithm>

#include "app/lab/lab_window.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/scene/scene_view.h"

// The run before, pale in the plots and in the scene.
namespace carom {

void LabWindow::show_run_before() {
  const std::optional<RunBefore>& before = session_.runs().before();
  if (!before || frame() == nullptr) {
    view_->set_before(std::nullopt);
    return plots_->set_run_before(std::nullopt);
  }
  const double shift = start_time(preset().saved) - before->start;
  const double then = frame()->time - shift;  // s, by the clock of the run before
  // Up to a cut it is the present run itself.
  const bool same = before->from > before->start && then <= before->from;
  const auto stood = same ? std::nullopt : before->recorder->poses().at(then);
  view_->set_before(stood ? std::optional(PlacedBodies{before->bodies, *stood}) : std::nullopt);
  if (!view_->options().run_before) return plots_->set_run_before(std::nullopt);
  // What went on past the end of the experiment does not make the plots' time longer.
  const double reach = std::min(before->recorder->time() - before->start, preset().duration);
  plots_->set_run_before(PaleRun{*before, shift, start_time(preset().saved) + reach});
}

}  // namespace carom
