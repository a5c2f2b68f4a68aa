#include "physics/run/simulation.h"

#include <algorithm>
#include <utility>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/model/bodies_by_name.h"
#include "physics/run/simulation_parts.h"
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
    : compiled_(std::move(compiled)),
      parts_(
          std::make_unique<SimulationParts>(SimulationParts{World({compiled_, &compiled_->model}, method)})) {
  choose_strategies();
}

Simulation::Simulation(const Simulation& other)
    : compiled_(other.compiled_),
      parts_(std::make_unique<SimulationParts>(*other.parts_)),
      lost_(other.lost_),
      edits_(other.edits_),
      edits_applied_(other.edits_applied_) {}

Simulation::Simulation(Simulation&& other) noexcept = default;

Simulation& Simulation::operator=(const Simulation& other) { return *this = Simulation(other); }

Simulation& Simulation::operator=(Simulation&& other) noexcept = default;

Simulation::~Simulation() = default;

void Simulation::interrupt_on(std::stop_token stop) { parts_->world.work.stop_on(std::move(stop)); }
const std::shared_ptr<const Model>& Simulation::model() const { return parts_->world.model; }
double Simulation::time() const { return parts_->world.clock.time; }
std::int64_t Simulation::steps() const { return parts_->world.clock.steps; }
std::int64_t Simulation::impact_count() const { return parts_->world.sums.impact_count; }
const ImpactCounts& Simulation::impact_counts() const { return parts_->world.sums.impact_counts; }
std::int64_t Simulation::evaluations() const { return parts_->world.trajectories.evaluations(); }
std::int64_t Simulation::rejected_steps() const { return parts_->world.trajectories.rejected_steps(); }
const State& Simulation::state() const { return parts_->world.state; }
const MassProperties& Simulation::mass() const { return parts_->world.mass(); }
const Geometry& Simulation::shapes() const { return parts_->world.shapes(); }
const WeldedBodies& Simulation::welded() const { return parts_->world.trajectories.welded(); }
bool Simulation::is_taut(JointIndex joint) const { return parts_->world.trajectories.is_taut(joint); }
double Simulation::length(JointIndex joint) const { return parts_->world.trajectories.length(joint); }
const ForceField& Simulation::field() const { return parts_->world.field(); }
const Method& Simulation::method() const { return parts_->world.method; }
Totals Simulation::totals() const { return parts_->world.totals(); }
Ledger Simulation::ledger() const { return parts_->world.ledger(); }
const std::vector<ImpactRecord>& Simulation::last_impacts() const { return parts_->world.log.records; }
const std::vector<Jump>& Simulation::last_jumps() const { return parts_->world.log.jumps; }
void Simulation::watch_impacts(bool on) { parts_->world.log.records_jumps = on; }

Eigen::Matrix3Xd Simulation::accelerations(const State& state, double time, BodyIndex of) const {
  Trajectories& trajectories = parts_->world.trajectories;
  Eigen::Matrix3Xd by = Eigen::Matrix3Xd::Zero(3, state.size());
  for (const IslandIndex k : trajectories.islands()) {
    if (of == kNoBody || trajectories.island_of(of) == k)
      trajectories.accelerations(k, state, time - trajectories.epoch(), by);
  }
  return by;
}

// Chooses the strategies of the method, without any memory.
void Simulation::choose_strategies() {
  if (parts_->world.method.impacts == ImpactsId::kLocated) {
    parts_->impacts.emplace<EventDrivenImpacts>().reset(parts_->world.bodies());
  } else {
    parts_->impacts.emplace<StepEndImpacts>();
  }
  parts_->resting.reset();
  if (contacts_last(parts_->world.method, needs())) {
    parts_->resting.emplace();
  } else if (needs().has(Part::kRestingContacts) && has_laws_of_rest(parts_->world.model->surfaces)) {
    parts_->world.note(&Notices::laws_of_rest_unused_since, time());
  }
}

void Simulation::count_pairs(const std::vector<std::pair<std::string, std::string>>& names) {
  const auto index = bodies_by_name(bodies());
  ImpactCounts& counts = parts_->world.sums.impact_counts;
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
  for (const Weld& weld : parts_->world.trajectories.welds()) {
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
  Trajectories& trajectories = parts_->world.trajectories;
  if (method.step != parts_->world.method.step) parts_->world.clock.divided_end = 0.0;
  parts_->world.method = method;
  // Trajectories that continue across steps are advanced here; the others were at the step's end.
  for (const IslandIndex k : trajectories.islands()) trajectories.advance_to(k, time() - trajectories.epoch());
  if (parts_->resting) parts_->resting->release(parts_->world);
  trajectories.set_method(method);
  trajectories.begin(time());
  choose_strategies();
}

// The hand that pulls already is at another place from now on.
void Simulation::move_hand(const Vec2& place) {
  Trajectories& trajectories = parts_->world.trajectories;
  trajectories.set_hand_place(place);
  auto* impacts = std::get_if<EventDrivenImpacts>(&parts_->impacts);
  if (impacts == nullptr || !choice_of(kIntegrators, parts_->world.method.integrator).adaptive) return;
  // Trajectories that continue across steps begin anew.
  for (const IslandIndex k : trajectories.islands()) trajectories.advance_to(k, time() - trajectories.epoch());
  trajectories.begin(time());
  const std::vector<WaitingPair> waiting = impacts->waiting();
  impacts->restore(parts_->world.bodies(), impacts->at_once(), waiting, std::nullopt);
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
  Notices notices = parts_->world.sums.notices;
  notices.tolerance_missed_since = parts_->world.trajectories.tolerance_missed_since();
  notices.joints_missed_since = parts_->world.trajectories.joints_missed_since();
  notices.switches_missed_since = parts_->world.trajectories.switches_missed_since();
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
  return parts_->resting ? parts_->resting->forces() : kNone;
}

void Simulation::apply_all_due() {
  while (due() != nullptr) apply_due();
}

// s: of the next step, if there are no edits.
double Simulation::undivided_step() const {
  const double left = step_towards(parts_->world.clock.divided_end, time(), method().step);
  return left > 0.0 ? left : method().step;
}

double Simulation::next_step() const {
  double step = undivided_step();
  for (std::size_t i = edits_applied_; i < edits_->size(); ++i) {
    const RunEdit& edit = (*edits_)[i];
    const auto* other = std::get_if<Method>(&edit.what);
    if (!is_due(edit)) return other == nullptr ? step_towards(edit.time, time(), step) : step;
    if (other != nullptr) step = other->step;
  }
  return step;
}

void Simulation::step() {
  apply_all_due();  // another method may have another step
  step(next_step());
}

void Simulation::step(double h) {
  parts_->world.log.clear();
  apply_all_due();
  if (lost_) return;
  if (h == next_step() && h < undivided_step()) parts_->world.clock.divided_end = time() + undivided_step();
  parts_->last_good.state = parts_->world.state;
  parts_->last_good.sums = parts_->world.sums;
  parts_->world.trajectories.begin_step();
  parts_->world.work.begin(parts_->world.bodies(), h);
  try {
    make_step(h);
  } catch (const LostMotion& lost) {
    give_up(lost);
  }
}

void Simulation::make_step(double h) {
  parts_->world.clock.begin_step(h);
  RestingContacts* resting = parts_->resting ? &*parts_->resting : nullptr;
  if (resting != nullptr) {
    resting->begin_step(parts_->world, h);
    // Without it, a step's parts are supported one by one.
    if (parts_->world.method.impacts == ImpactsId::kLocated) resting->support(parts_->world, h, true, false);
  }
  std::visit([&](auto& impacts) { impacts.step(parts_->world, resting, h); }, parts_->impacts);
  settle_contact_forces(parts_->world.trajectories, parts_->world.bodies());
  parts_->world.check_motions();
  parts_->world.clock.end_step();
  parts_->world.check_energy();
}

void Simulation::give_up(const LostMotion& lost) {
  lost_ = LostRun{lost.reason, lost.body, std::min(lost.time, parts_->world.clock.step_end)};
  parts_->world.state = parts_->last_good.state;
  parts_->world.sums = parts_->last_good.sums;
  parts_->world.trajectories.undo_step();
  parts_->world.log.clear();
  if (parts_->resting) parts_->resting->forget_forces();
}

}  // namespace carom
