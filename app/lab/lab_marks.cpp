#include "app/lab/drawer.h"
#include "app/lab/lab_window.h"
#include "app/lab/marked_interval.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/run/before_after_panel.h"

// The marks A and B in the window, and what happened between them.
namespace carom {

void LabWindow::connect_marks() {
  marked_ = new MarkedInterval;
  marked_->setParent(this);
  connect(marked_, &MarkedInterval::found, this, &LabWindow::show_frame);
  connect(plots_, &PlotPanel::marksChanged, this, &LabWindow::show_frame);
}

void LabWindow::mark_shown_moment(bool second) {
  if (frame() != nullptr) plots_->set_mark(session_.runs().shown_time(), second);
}

void LabWindow::show_before_after() {
  const LabRuns& runs = session_.runs();
  const Frame& newest = *runs.newest().front();
  const ReadingMarks marks = plots_->marks();
  std::shared_ptr<const RunInterval> interval;
  if (before_after_->choice() == BeforeAfterPanel::Choice::kMarked && marks.a && marks.b)
    interval = marked_->between(newest, *marks.a, *marks.b);
  before_after_->update_from({.shown = *runs.frame(),
                              .newest = newest,
                              .recorder = *runs.recorders().front(),
                              .start = session_.history().bodies(),
                              .picked = runs.picked(),
                              .mark_a = marks.a,
                              .mark_b = marks.b,
                              .marked = interval});
}

}  // namespace carom
