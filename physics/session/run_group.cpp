#include "physics/session/run_group.h"

#include <algorithm>

namespace carom {
namespace {

constexpr double kRounding = 1e-9;  // of a step

}  // namespace

void RunGroup::load(const Preset& preset, const std::vector<Curve>& curves, ReferenceId reference) {
  preset_ = preset;
  std::vector<Method> methods = {preset.method};
  methods.insert(methods.end(), preset.compare.begin(), preset.compare.end());
  added_.clear();
  past_.clear();
  choose(methods, curves, reference);
}

void RunGroup::choose(const std::vector<Method>& methods, const std::vector<Curve>& curves,
                      ReferenceId reference) {
  methods_ = methods;
  curves_ = curves;
  reference_ = reference;
}

void RunGroup::begin(std::stop_token token) {
  token_ = std::move(token);
  ++starts_;
  interrupted_ = false;
  replay_until_.reset();
  runs_.clear();
  for (RunPlan& run : plans_from_the_start()) begin_run(std::move(run));
  changed_ = true;
}

void RunGroup::interrupt() {
  interrupted_ = true;
  changed_ = false;
  replay_until_.reset();
}

std::vector<RunGroup::RunPlan> RunGroup::plans_from_the_start() const {
  std::vector<RunPlan> plans;
  for (const Method& method : methods_) {
    plans.push_back({method, {}});
    for (const AddedBody& each : added_)
      plans.back().edits.push_back({each.edit, PendingEdit::kByTime, each.time, each.body});
  }
  return plans;
}

void RunGroup::begin_run(RunPlan plan) {
  Preset alone = preset_;
  alone.method = plan.start;
  runs_.push_back({LiveRun(setup_of(alone), curves_, reference_, token_), ++ids_, {}, std::move(plan.edits)});
  apply_due_edits(runs_.back());
  changed_ = true;
}

void RunGroup::add_run(const Method& method) {
  if (methods_.size() > kMostCompared) return;
  methods_.push_back(method);
  if (!interrupted_) begin_run(std::move(plans_from_the_start().back()));
}

void RunGroup::remove_run(std::size_t run) {
  if (run == 0 || run >= methods_.size()) return;
  methods_.erase(methods_.begin() + static_cast<std::ptrdiff_t>(run));
  if (interrupted_) return;
  runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(run));
  changed_ = true;
}

void RunGroup::set_method(std::size_t run, const Method& method, EditId edit) {
  if (run >= methods_.size()) return;
  methods_[run] = method;
  if (interrupted_) return;
  // A run that is behind gets it when it has caught up.
  if (may_step(runs_[run], displayed_time())) {
    add_pending(runs_[run], {edit, PendingEdit::kByTime, displayed_time(), method});
  } else {
    apply(runs_[run], edit, method);
  }
  changed_ = true;
}

// Bodies added before a restart may still be pending.
void RunGroup::add_body(const Body& body, EditId edit) {
  const double time = runs_.empty() ? 0.0 : displayed_time();
  const auto later = [](double t, const AddedBody& other) { return t < other.time; };
  added_.insert(std::upper_bound(added_.begin(), added_.end(), time, later), {edit, time, body});
  if (interrupted_) return;
  for (Run& run : runs_) {
    add_pending(run, {edit, PendingEdit::kByTime, time, body});
    apply_due_edits(run);
  }
  changed_ = true;
}

void RunGroup::add_pending(Run& run, const PendingEdit& edit) {
  const auto later = [](double t, const PendingEdit& other) { return t < other.time; };
  run.pending.insert(std::upper_bound(run.pending.begin(), run.pending.end(), edit.time, later), edit);
}

// Methods by time: at the run's step when the first run is at that time.
void RunGroup::apply_due_edits(Run& run) {
  while (!run.pending.empty()) {
    const PendingEdit next = run.pending.front();
    const Simulation& now = run.live.simulation();
    const bool is_method = std::holds_alternative<Method>(next.what);
    const double rounding = kRounding * now.method().step;
    const bool due = next.step != PendingEdit::kByTime ? next.step <= now.steps()
                     : is_method                       ? next.time + rounding < run.live.next()
                                                       : next.time <= now.time() + rounding;
    if (!due) return;
    run.pending.erase(run.pending.begin());
    apply(run, next.edit, next.what);
  }
}

void RunGroup::apply(Run& run, EditId edit, const std::variant<Method, Body>& what) {
  run.live.edit(what);
  if (run.live.log().edits.size() > run.edits.size()) run.edits.push_back(edit);
}

void RunGroup::record(const std::vector<Curve>& curves) {
  curves_ = curves;
  record_all();
}

void RunGroup::compare_with(ReferenceId reference) {
  reference_ = reference;
  record_all();
}

void RunGroup::record_all() {
  if (interrupted_) return;
  for (Run& run : runs_) run.live.record(curves_, reference_);
  changed_ = true;
}

RunGroup::RunPlan RunGroup::plan_of(const Run& run) {
  RunPlan plan{run.live.log().start.method, {}};
  for (std::size_t i = 0; i < run.edits.size(); ++i) {
    const Edit& edit = run.live.log().edits[i];
    plan.edits.push_back({run.edits[i], edit.step, edit.time, edit.what});
  }
  plan.edits.insert(plan.edits.end(), run.pending.begin(), run.pending.end());
  return plan;
}

// True if the run has had exactly these edits, so that it is the same bit by bit.
bool RunGroup::follows(const Run& run, const RunPlan& plan) {
  const std::vector<PendingEdit>& all = plan.edits;
  const auto same = [](EditId edit, const PendingEdit& pending) { return edit == pending.edit; };
  const auto same_pending = [](const PendingEdit& a, const PendingEdit& b) { return a.edit == b.edit; };
  const auto done = static_cast<std::ptrdiff_t>(std::min(run.edits.size(), all.size()));
  return run.live.log().start.method == plan.start &&
         std::equal(run.edits.begin(), run.edits.end(), all.begin(), all.begin() + done, same) &&
         std::equal(run.pending.begin(), run.pending.end(), all.begin() + done, all.end(), same_pending);
}

RunGroup::Plan RunGroup::plan() const {
  Plan all{starts_, methods_, added_, {}};
  for (const Run& run : runs_) all.runs.push_back(plan_of(run));
  return all;
}

void RunGroup::undo(EditId edit, ReferenceId reference) {
  const auto past = past_.find(edit);
  if (past == past_.end()) return;
  past->second.after = plan();
  restore(past->second.before, reference);
}

void RunGroup::redo(EditId edit, ReferenceId reference) {
  const auto past = past_.find(edit);
  if (past != past_.end()) restore(past->second.after, reference);
}

// Unchanged runs continue as they are; interrupted runs change at the next begin().
void RunGroup::restore(const Plan& plan, ReferenceId reference) {
  const bool other_reference = std::exchange(reference_, reference) != reference;
  methods_ = plan.methods;
  added_ = plan.added;
  if (interrupted_) return;
  const double time = displayed_time();
  std::vector<Run> old = std::exchange(runs_, {});
  for (RunPlan& each : plan.starts == starts_ ? std::vector<RunPlan>(plan.runs) : plans_from_the_start()) {
    const auto same = std::find_if(old.begin(), old.end(), [&](const Run& run) { return follows(run, each); });
    if (same == old.end()) {
      begin_run(std::move(each));
    } else {
      runs_.push_back(std::move(*same));
      old.erase(same);
    }
  }
  if (first().time() < time) replay_until_ = time;
  changed_ = true;
  if (other_reference) record_all();
}

// s, of the first run: its time, or the time to which it is being replayed.
double RunGroup::displayed_time() const { return replay_until_.value_or(first().time()); }

RunGroup::Run& RunGroup::farthest_behind() {
  return *std::min_element(runs_.begin(), runs_.end(),
                           [](const Run& a, const Run& b) { return a.live.next() < b.live.next(); });
}

// True if the run's next step ends not after `time`.
bool RunGroup::may_step(const Run& run, double time) {
  return run.live.next() <= time + kRounding * run.live.simulation().method().step;
}

void RunGroup::step(Run& run) {
  run.live.step();
  changed_ = true;
}

void RunGroup::step_first() { step(runs_.front()); }

bool RunGroup::lags() const {
  const double time = first().time();
  return std::any_of(runs_.begin(), runs_.end(), [time](const Run& run) { return may_step(run, time); });
}

bool RunGroup::some_behind() const {
  return std::any_of(runs_.begin(), runs_.end(), [](const Run& run) { return run.live.behind(); });
}

bool RunGroup::catch_up(Clock::duration duration) {
  const auto run = std::find_if(runs_.begin(), runs_.end(), [](const Run& r) { return r.live.behind(); });
  if (run == runs_.end()) return false;
  run->live.catch_up(duration);
  changed_ = true;
  return true;
}

std::vector<std::shared_ptr<Frame>> RunGroup::take_frames() {
  std::vector<std::shared_ptr<Frame>> frames;
  for (Run& run : runs_) {
    frames.push_back(run.live.take_frame());
    frames.back()->run = run.id;
    frames.back()->replay_until = replay_until_;
  }
  changed_ = false;
  return frames;
}

std::shared_ptr<Frame> RunGroup::empty_frame() {
  auto frame = std::make_shared<Frame>();
  frame->run = ++ids_;
  frame->bodies = std::make_shared<const std::vector<Body>>();
  frame->forces = std::make_shared<const Forces>();
  frame->log = std::make_shared<const RunLog>(RunLog{setup_of(preset_), {}});
  return frame;
}

}  // namespace carom
