#include <QTabWidget>
#include <algorithm>

#include "app/lab/lab_window.h"
#include "physics/preset/preset.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/scene/scene_view.h"
#include "widgets/theme/method_names.h"

// Several methods side by side in the lab's window.
namespace carom {
namespace {

// Beyond so many moving bodies nobody asks for the reference's cost without saying so.
constexpr std::ptrdiff_t kMostCompanions = 200;

ReferenceId first_reference(const Preset& preset) {
  const std::vector<Body> bodies = all_bodies(preset.scene);
  const auto moving =
      std::count_if(bodies.begin(), bodies.end(), [](const Body& b) { return !is_immovable(b); });
  return moving > kMostCompanions ? ReferenceId::kNone : usual_reference(setup_of(preset));
}

}  // namespace

// In the place of the last one if there are as many as there may be.
void LabWindow::add_method(const Method& method) {
  const Preset preset = worker_->preset();
  if (preset.compare.size() < kMostCompared) {
    worker_->add_method(method);
  } else {
    worker_->set_method(method, kMostCompared);
  }
  if (reference_ == ReferenceId::kNone) choose_reference(first_reference(worker_->preset()));
  mark_changed(true);
  show_needs();
}

// Unless it is among the methods already.
void LabWindow::compare_with(const Method& method) {
  const Preset preset = worker_->preset();
  const bool there = preset.method == method ||
                     std::find(preset.compare.begin(), preset.compare.end(), method) != preset.compare.end();
  if (!there) add_method(method);
}

void LabWindow::remove_method(std::size_t run) {
  worker_->remove_method(run);
  mark_changed(true);
  show_needs();
}

void LabWindow::choose_reference(ReferenceId reference) {
  reference_ = reference;
  worker_->set_reference(reference);
  compare_->set_scene(worker_->preset(), reference);
}

// The scene from the start under the method of the reference, explicit Euler and RK4; or back to what was
// compared before. The exact run is the scene's own meanwhile: the others are seen beside what they should be,
// and a preset that is saved then stays as good as it was.
void LabWindow::compare_usual() {
  Preset preset = worker_->preset();
  if (before_usual_) {
    preset.method = before_usual_->method;
    preset.compare = before_usual_->others;
    reference_ = before_usual_->reference;
    before_usual_.reset();
  } else {
    before_usual_ = Compared{preset.method, preset.compare, reference_};
    reference_ = first_reference(preset);
    Method euler = preset.method;
    euler.integrator = IntegratorId::kExplicitEuler;
    Method rk4 = preset.method;
    rk4.integrator = IntegratorId::kRk4;
    preset.compare = {euler, rk4};
    preset.method = reference_for(setup_of(preset), preset.method, usual_reference(setup_of(preset)));
    tabs_->setCurrentWidget(compare_);
    if (reference_ != ReferenceId::kNone) plots_->set_shown("error", true);
  }
  forget_wait();
  worker_->restart(preset.method, preset.compare, plots_->curves(), reference_);
  mark_changed(true);
  show_method();
  show_needs();
}

void LabWindow::show_compared() {
  std::vector<Method> methods;
  for (const auto& frame : frames_) methods.push_back(frame->method);
  const std::vector<QString> names = names_of(methods);
  std::vector<PlottedRun> plotted;
  for (std::size_t i = 0; i < frames_.size(); ++i) plotted.push_back({recorders_[i], names[i]});
  plots_->update_from(plotted);
  view_->set_frame(frame_, {frames_.begin() + 1, frames_.end()});
}

}  // namespace carom
