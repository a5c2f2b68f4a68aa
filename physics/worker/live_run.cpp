#include "physics/worker/live_run.h"

#include <algorithm>
#include <utility>

#include "physics/record/replay.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

LiveRun::LiveRun(const RunSetup& setup, const std::vector<Curve>& curves, ReferenceId reference,
                 std::stop_token interrupt)
    : interrupt_(std::move(interrupt)),
      setup_(std::make_shared<const RunSetup>(setup)),
      simulation_(setup),
      curves_(curves),
      reference_(reference),
      sampler_(begin_sampler(simulation_, curves, {})) {
  simulation_.watch_impacts(true);
  simulation_.interrupt_on(interrupt_);
  apply_due_edits();
}

Sampler LiveRun::begin_sampler(const Simulation& simulation, const std::vector<Curve>& curves,
                               const std::vector<Curve>& later) const {
  Sampler sampler(curves, later);
  if (reference_ != ReferenceId::kNone) sampler.compare_with(ReferenceRun(*setup_, reference_));
  sampler.interrupt_on(interrupt_);
  sampler.begin(simulation);
  return sampler;
}

void LiveRun::step() {
  if (lost()) return;
  const auto begin = Clock::now();
  if (stops_) stops_->before_step(simulation_);
  simulation_.step();
  if (lost()) return;
  wall_time_ += std::chrono::duration<double>(Clock::now() - begin).count();
  sampler_.after_step(simulation_);
  if (stops_) stops_->after_step(simulation_);
  impacts_.insert(impacts_.end(), simulation_.last_impacts().begin(), simulation_.last_impacts().end());
  if (!simulation_.last_impacts().empty()) last_jumps_ = last_jump_moment(simulation_);
  apply_due_edits();
}

void LiveRun::edit(const RunEdit& edit) {
  RunSetup longer = *setup_;  // frames share the previous one
  auto before = longer.edits.begin() + static_cast<std::ptrdiff_t>(simulation_.edits_applied());
  if (!simulation_.is_due(edit)) before = std::upper_bound(before, longer.edits.end(), edit, is_earlier);
  longer.edits.insert(before, edit);
  setup_ = std::make_shared<const RunSetup>(std::move(longer));
  give_edits();
  apply_due_edits();
}

bool LiveRun::take_edits(const std::vector<RunEdit>& edits) {
  const std::vector<RunEdit>& old = setup_->edits;
  const auto [mine, theirs] = std::mismatch(old.begin(), old.end(), edits.begin(), edits.end(), is_same);
  const auto same = static_cast<std::size_t>(mine - old.begin());
  const bool of_its_past =
      same < simulation_.edits_applied() ||
      (theirs != edits.end() && was_due_before(*theirs, simulation_.time(), simulation_.method().step));
  std::shared_ptr<const KeyFrame> moment;
  if (of_its_past) {
    if (catch_up_) return false;
    moment = key_frames_.go_back(edits, same, curves_);
    if (moment == nullptr) return false;
  }
  take_setup(edits, moment.get());
  return true;
}

bool LiveRun::go_back(double time, const std::vector<RunEdit>& edits) {
  if (catch_up_) return false;
  const std::vector<RunEdit>& old = setup_->edits;
  const auto mine = std::mismatch(old.begin(), old.end(), edits.begin(), edits.end(), is_same).first;
  const auto same = static_cast<std::size_t>(mine - old.begin());
  const std::shared_ptr<const KeyFrame> moment = key_frames_.go_back(edits, same, curves_, time);
  if (moment == nullptr) return false;
  take_setup(edits, moment.get());
  return true;
}

void LiveRun::take_setup(const std::vector<RunEdit>& edits, const KeyFrame* back_to) {
  RunSetup other = *setup_;
  other.edits = edits;
  setup_ = std::make_shared<const RunSetup>(std::move(other));
  if (back_to != nullptr) go_back_to(*back_to);
  give_edits();
  apply_due_edits();
}

void LiveRun::give_edits() {
  simulation_.set_edits(setup_->edits);
  if (catch_up_) catch_up_->replay.set_edits(setup_->edits);
  if (stops_) stops_->take_edits(setup_->edits);
}

void LiveRun::watch(const StopRecord::Stops& stops) {
  if (stops_ ? stops == stops_->stops() : stops == nullptr) return;
  stops_.reset();
  if (stops) watch_anew(stops);
}

void LiveRun::watch_anew(const StopRecord::Stops& stops) {
  stops_.emplace(stops, *setup_, simulation_, interrupt_);
}

void LiveRun::go_back_to(const KeyFrame& moment) {
  simulation_ = Simulation(moment.compiled, moment.state);
  simulation_.watch_impacts(true);
  simulation_.interrupt_on(interrupt_);
  rows_.push_back(sampler_.take());
  const double time = simulation_.time();
  std::erase_if(impacts_, [time](const ImpactRecord& impact) { return impact.time > time; });
  if (looks_for_stops()) {
    watch_anew(std::make_shared<const std::vector<Stop>>(*stops_->stops()));
  } else if (stops_) {
    stops_->go_back(time);
  }
  if (last_jumps_ && last_jumps_->time() > time) last_jumps_.reset();
  back_to_ = std::min(time, back_to_.value_or(time));
  sampler_ = moment.sampler;
  sampler_.go_on(simulation_, curves_, interrupt_);
  wall_time_ = moment.wall_time;
}

void LiveRun::apply_due_edits() {
  key_frames_.take(simulation_, sampler_, wall_time_);
  while (const RunEdit* edit = simulation_.due()) {
    simulation_.apply_due();
    sampler_.after_edit(simulation_, *edit);
  }
}

void LiveRun::record(const std::vector<Curve>& curves, ReferenceId reference) {
  reference_ = reference;
  curves_ = curves;
  const bool anew = sampler_.reference() != reference;
  std::vector<Curve> missing;
  std::vector<Curve> known;  // curves that the run continues to record meanwhile
  for (const Curve& curve : curves) {
    const std::vector<Curve>& read = sampler_.curves();
    const bool is_error = curve.y.observable->is_error() || (curve.x && curve.x->observable->is_error());
    const bool is_known = std::find(read.begin(), read.end(), curve) != read.end() && !(anew && is_error);
    (is_known ? known : missing).push_back(curve);
  }
  catch_up_.reset();
  rows_.push_back(sampler_.take());
  sampler_.set_curves(known);
  if (missing.empty() && !anew) return;
  if (anew) key_frames_ = {};
  Replay replay(*setup_, interrupt_);
  Sampler past = begin_sampler(replay.simulation(), missing, curves);
  catch_up_.emplace(CatchUp{std::move(replay), std::move(past)});
}

void LiveRun::interrupt_on(const std::stop_token& interrupt) {
  interrupt_ = interrupt;
  simulation_.interrupt_on(interrupt);
  sampler_.interrupt_on(interrupt);
  if (looks_for_stops()) {
    watch_anew(std::make_shared<const std::vector<Stop>>(*stops_->stops()));
  } else if (stops_) {
    stops_->take_edits(setup_->edits);  // its copies have the token of before
  }
}

void LiveRun::catch_up(Clock::duration duration) {
  if (!catch_up_ && stops_) stops_->catch_up(simulation_, duration);
  if (!catch_up_) return;
  const auto begin = Clock::now();
  Replay& replay = catch_up_->replay;
  Sampler& past = catch_up_->sampler;
  const auto is_there = [&] { return replay.simulation().steps() == simulation_.steps(); };
  bool any = false;  // take at least one step, however short the time
  replay.go_through([&](const RunEdit& edit) { past.after_edit(replay.simulation(), edit); },
                    [&](const Simulation&) {
                      return !is_there() && (!std::exchange(any, true) || Clock::now() - begin < duration);
                    },
                    [&](const Simulation& simulation) {
                      if (!simulation.lost()) past.after_step(simulation);
                    });
  if (!is_there()) return;
  rows_.push_back(sampler_.take());
  rows_.push_back(past.take());
  sampler_ = std::move(past);
  sampler_.set_curves(curves_);
  catch_up_.reset();
}

std::shared_ptr<Frame> LiveRun::take_frame() {
  auto frame = std::make_shared<Frame>();
  take_moment(simulation_, *frame);
  rows_.push_back(sampler_.take());
  if (catch_up_) rows_.push_back(catch_up_->sampler.take());
  frame->rows = std::exchange(rows_, {});
  frame->rows_known_until = catch_up_ ? catch_up_->replay.simulation().time() : frame->time;
  frame->impacts = std::exchange(impacts_, {});
  if (last_jumps_) frame->jumps = {last_jumps_};
  frame->back_to = std::exchange(back_to_, std::nullopt);
  if (stops_) stops_->take(*frame);
  frame->scales = sampler_.scales();
  frame->wall_time = wall_time_;
  if (!catch_up_) frame->error = sampler_.error();
  frame->setup = setup_;
  frame->key_frames = key_frames_.all();
  return frame;
}

}  // namespace carom
