#include "physics/run/simulation.h"

#include <algorithm>
#include <utility>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/model/bodies_by_name.h"
#include "physics/scene/validate.h"

namespace carom {
namespace {

// At the end of a step: the accelerations by contacts stay what they are there.
void settle_contact_forces(Trajectories& trajectories, int bodies) {
  if (!trajectories.field().contact_changes()) return;
  for (BodyIndex i{0}; i < bodies; ++i) {
    if (!trajectories.is_bent(i)) continue;
    const Eigen::Vector3d rate = trajectories.field().contact_rate(i);
    trajectories.set_contact_acceleration(
        i, trajectories.field().contact_acceleration(i) + trajectories.start(i) * rate);
  }
  trajectories.end_contact_rates();
}

}  // namespace

Simulation::Simulation(const RunSetup& setup, const Needs& needs)
    : Simulation(compile(setup.scene, needs, start_time(setup.saved)), setup.method) {
  if (setup.saved) go_on_from(*setup.saved);
  count_pairs(setup.counted_pairs);
  set_edits(setup.edits);
}

Simulation::Simulation(std::shared_ptr<const CompiledScene> compiled, const Method& method)
    : compiled_(std::move(compiled)), world_({compiled_, &compiled_->model}, method) {
  choose_strategies();
}

// Chooses the strategies of the method, without any memory.
void Simulation::choose_strategies() {
  if (world_.method.impacts == ImpactsId::kLocated) {
    impacts_.emplace<EventDrivenImpacts>().reset(world_.bodies());
  } else {
    impacts_.emplace<StepEndImpacts>();
  }
  resting_.reset();
  if (contacts_last(world_.method, needs())) {
    resting_.emplace();
  } else if (needs().has(Part::kRestingContacts) && has_laws_of_rest(world_.model->surfaces)) {
    world_.note(&Notices::laws_of_rest_unused_since, time());
  }
}

void Simulation::count_pairs(const std::vector<std::pair<std::string, std::string>>& names) {
  const auto index = bodies_by_name(bodies());
  ImpactCounts& counts = world_.sums.impact_counts;
  const ImpactCounts saved = counts;
  counts.pairs.clear();
  const std::int64_t before = impact_count() == 0 ? 0 : ImpactCounts::kNotKnown;
  for (const auto& [first, second] : names) {
    const auto a = index.find(first);
    const auto b = index.find(second);
    if (a == index.end() || b == index.end()) continue;
    const ImpactCounts::Pair* known = saved.find(a->second, b->second);
    counts.watch(a->second, b->second, known != nullptr ? known->count : before);
  }
}

std::vector<Joint> Simulation::joints() const {
  std::vector<Joint> joints = compiled_->scene.joints;
  for (const Weld& weld : world_.trajectories.welds()) {
    Joint& joint = joints.emplace_back();
    joint.kind = JointKind::kWeld;
    joint.body = bodies()[static_cast<std::size_t>(weld.body)].name;
    joint.point = weld.point;
    joint.to = bodies()[static_cast<std::size_t>(weld.other)].name;
    joint.anchor = weld.anchor;
    joint.angle = weld.angle;
  }
  return joints;
}

void Simulation::set_method(const Method& method) {
  if (lost_) return;
  Trajectories& trajectories = world_.trajectories;
  world_.method = method;
  // Trajectories that continue across steps are advanced here; the others were at the step's end.
  for (int k = 0; k < trajectories.islands(); ++k) trajectories.advance_to(k, time() - trajectories.epoch());
  if (resting_) resting_->release(world_);
  trajectories.set_method(method);
  trajectories.begin(time());
  choose_strategies();
}

// The hand that pulls already is at another place from now on.
void Simulation::move_hand(const Vec2& place) {
  Trajectories& trajectories = world_.trajectories;
  trajectories.set_hand_place(place);
  auto* impacts = std::get_if<EventDrivenImpacts>(&impacts_);
  if (impacts == nullptr || !choice_of(kIntegrators, world_.method.integrator).adaptive) return;
  // Trajectories that continue across steps begin anew.
  for (int k = 0; k < trajectories.islands(); ++k) trajectories.advance_to(k, time() - trajectories.epoch());
  trajectories.begin(time());
  const std::vector<WaitingPair> waiting = impacts->waiting();
  impacts->restore(world_.bodies(), impacts->at_once(), waiting, std::nullopt);
}

void Simulation::set_edits(std::vector<RunEdit> edits) {
  edits_ = std::make_shared<const std::vector<RunEdit>>(std::move(edits));
}

const RunEdit* Simulation::due() const {
  if (lost_ || edits_applied_ >= edits_->size()) return nullptr;
  const RunEdit& next = (*edits_)[edits_applied_];
  return is_due(next) ? &next : nullptr;
}

void Simulation::apply_due() {
  const RunEdit* edit = due();
  if (edit == nullptr) return;
  ++edits_applied_;
  if (const auto* method = std::get_if<Method>(&edit->what)) {
    set_method(*method);
  } else {
    apply(std::get<SceneEdits>(edit->what));
  }
}

Notices Simulation::notices() const {
  Notices notices = world_.sums.notices;
  notices.tolerance_missed_since = world_.trajectories.tolerance_missed_since();
  notices.joints_missed_since = world_.trajectories.joints_missed_since();
  notices.switches_missed_since = world_.trajectories.switches_missed_since();
  return notices;
}

Notices::BodyName Simulation::body_name() const {
  return [this](BodyIndex body) { return shortened(bodies()[static_cast<std::size_t>(body)].name); };
}

std::string Simulation::status() const {
  std::string notices = notices_text();
  if (!lost_) return notices;
  const std::string lost = lost_->text(bodies(), time());
  return notices == "ok" ? lost : lost + "; " + notices;
}

const std::vector<ContactForce>& Simulation::contact_forces() const {
  static const std::vector<ContactForce> kNone;
  return resting_ ? resting_->forces() : kNone;
}

void Simulation::apply_all_due() {
  while (due() != nullptr) apply_due();
}

void Simulation::step() {
  apply_all_due();  // another method may have another step
  step(world_.method.step);
}

void Simulation::step(double h) {
  world_.log.clear();
  apply_all_due();
  if (lost_) return;
  last_good_.state = world_.state;
  last_good_.sums = world_.sums;
  world_.trajectories.begin_step();
  world_.work.begin(world_.bodies(), h);
  try {
    make_step(h);
  } catch (const LostMotion& lost) {
    give_up(lost);
  }
}

void Simulation::make_step(double h) {
  world_.clock.begin_step(h);
  RestingContacts* resting = resting_ ? &*resting_ : nullptr;
  if (resting != nullptr) {
    resting->begin_step(world_, h);
    // Without it, a step's parts are supported one by one.
    if (world_.method.impacts == ImpactsId::kLocated) resting->support(world_, h, true);
  }
  std::visit([&](auto& impacts) { impacts.step(world_, resting, h); }, impacts_);
  settle_contact_forces(world_.trajectories, world_.bodies());
  world_.check_motions();
  world_.clock.end_step();
  world_.check_energy();
}

void Simulation::give_up(const LostMotion& lost) {
  lost_ = LostRun{lost.reason, lost.body, std::min(lost.time, world_.clock.step_end)};
  world_.state = last_good_.state;
  world_.sums = last_good_.sums;
  world_.trajectories.undo_step();
  world_.log.clear();
  if (resting_) resting_->forget_forces();
}

}  // namespace carom
