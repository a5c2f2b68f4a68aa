#include <QTabWidget>
#include <algorithm>

#include "app/lab/lab_window.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/plot/plot_panel.h"
#include "widgets/scene/scene_view.h"
#include "widgets/theme/method_names.h"

// Several methods side by side in the lab's window.
namespace carom {
namespace {

// Beyond so many moving bodies nobody asks for the reference's cost without saying so.
constexpr std::ptrdiff_t kMostCompanions = 200;

ReferenceId first_reference(const Scene& scene) {
  const std::vector<Body> bodies = all_bodies(scene);
  const auto moving =
      std::count_if(bodies.begin(), bodies.end(), [](const Body& b) { return !is_immovable(b); });
  return moving > kMostCompanions ? ReferenceId::kNone : usual_reference(scene);
}

}  // namespace

// In the place of the last one if there are as many as there may be.
void LabWindow::add_method(const Method& method) {
  const Scene scene = worker_->scene();
  if (scene.compare.size() < kMostCompared) {
    worker_->add_method(method);
  } else {
    worker_->set_method(method, kMostCompared);
  }
  if (reference_ == ReferenceId::kNone) choose_reference(first_reference(worker_->scene()));
  mark_changed(true);
  show_needs();
}

// Unless it is among the methods already.
void LabWindow::compare_with(const Method& method) {
  const Scene scene = worker_->scene();
  const bool there = scene.method == method ||
                     std::find(scene.compare.begin(), scene.compare.end(), method) != scene.compare.end();
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
  compare_->set_scene(worker_->scene(), reference);
}

// The scene from the start under the method of the reference, explicit Euler and RK4; or back to what was
// compared before. The exact run is the scene's own meanwhile: the others are seen beside what they should be,
// and a preset that is saved then stays as good as it was.
void LabWindow::compare_usual() {
  Scene scene = worker_->scene();
  if (before_usual_) {
    scene.method = before_usual_->method;
    scene.compare = before_usual_->others;
    reference_ = before_usual_->reference;
    before_usual_.reset();
  } else {
    before_usual_ = Compared{scene.method, scene.compare, reference_};
    reference_ = first_reference(scene);
    Method euler = scene.method;
    euler.integrator = IntegratorId::kExplicitEuler;
    Method rk4 = scene.method;
    rk4.integrator = IntegratorId::kRk4;
    scene.compare = {euler, rk4};
    scene.method = reference_for(scene, scene.method, usual_reference(scene));
    tabs_->setCurrentWidget(compare_);
    if (reference_ != ReferenceId::kNone) plots_->set_shown("error", true);
  }
  forget_wait();
  worker_->restart(scene.method, scene.compare, plots_->curves(), reference_);
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
