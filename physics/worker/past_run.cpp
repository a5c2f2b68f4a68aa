#include "physics/worker/past_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;

// Work between the key frames that are left on the way, doubled whenever there are too many.
constexpr std::chrono::milliseconds kFirstInterval{8};
constexpr std::size_t kMostLeft = 64;

// The latest key frame that fulfils `leads`.
template <class Leads>
std::shared_ptr<const KeyFrame> latest(const std::vector<std::shared_ptr<const KeyFrame>>& frames,
                                       const Leads& leads) {
  const auto found =
      std::find_if(frames.rbegin(), frames.rend(), [&](const auto& frame) { return leads(*frame); });
  return found == frames.rend() ? nullptr : *found;
}

bool leads_to(double time, double next, double step) { return next <= time + kSameMoment * step; }

}  // namespace

PastRun::PastRun(const LiveRun& run, std::uint64_t id, std::stop_token interrupt)
    : setup_(run.shared_setup()),
      id_(id),
      reference_(run.reference()),
      interrupt_(std::move(interrupt)),
      key_frames_(run.key_frames().all()) {}

void PastRun::stand_before(double time) {
  stand(
      [time](const RunState& state) {
        return leads_to(time, state.clock.time + state.method.step, state.method.step);
      },
      [time](const Simulation& run) { return !leads_to(time, run.time(), run.method().step); });
}

void PastRun::stand_before_step(std::int64_t steps) {
  stand([steps](const RunState& state) { return state.clock.steps < steps; },
        [steps](const Simulation& run) { return run.steps() > steps; });
}

// Where it is, unless that is beyond or there is a later moment that leads there.
template <class Leads, class Beyond>
void PastRun::stand(const Leads& leads, const Beyond& beyond) {
  part_.reset();
  jumps_ahead_.reset();
  const std::shared_ptr<const KeyFrame> own =
      latest(left_, [&](const KeyFrame& frame) { return leads(frame.state); });
  // The run may have left moments before it had its reference.
  const std::shared_ptr<const KeyFrame> of_run = latest(key_frames_, [&](const KeyFrame& frame) {
    const bool compares = reference_ == ReferenceId::kNone || frame.sampler.reference() == reference_;
    return compares && leads(frame.state);
  });
  const auto steps_of = [](const auto& frame) { return frame ? frame->state.clock.steps : -1; };
  const std::int64_t best = std::max(steps_of(own), steps_of(of_run));
  if (at_ && !beyond(at_->simulation) && at_->simulation.steps() >= best) return;
  if (own && steps_of(own) == best) return stand_at(*own);
  left_.clear();
  interval_ = kFirstInterval;
  of_run ? stand_at(*of_run) : stand_at_start();
}

void PastRun::stand_at(const KeyFrame& moment) {
  at_.emplace(Standing{Simulation(moment.compiled, moment.state), std::nullopt, moment.wall_time});
  at_->simulation.watch_impacts(true);
  at_->simulation.interrupt_on(interrupt_);
  at_->simulation.set_edits(setup_->edits);
  if (reference_ != ReferenceId::kNone) {
    at_->sampler = moment.sampler;
    at_->sampler->go_on(at_->simulation, {}, interrupt_);
  }
  worked_ = {};
  apply_due_edits();
}

void PastRun::stand_at_start() {
  at_.emplace(Standing{Simulation(*setup_), std::nullopt, 0.0});
  at_->simulation.watch_impacts(true);
  at_->simulation.interrupt_on(interrupt_);
  if (reference_ != ReferenceId::kNone) {
    at_->sampler.emplace(std::vector<Curve>{});
    at_->sampler->compare_with(ReferenceRun(*setup_, reference_));
    at_->sampler->interrupt_on(interrupt_);
    at_->sampler->begin(at_->simulation);
  }
  worked_ = {};
  apply_due_edits();
}

void PastRun::apply_due_edits() {
  Simulation& run = at_->simulation;
  while (const RunEdit* edit = run.due()) {
    run.apply_due();
    if (at_->sampler) at_->sampler->after_edit(run, *edit);
  }
}

bool PastRun::may_step(double time) const { return leads_to(time, next(), at_->simulation.method().step); }

double PastRun::next() const {
  const Simulation& run = at_->simulation;
  return run.lost() ? std::numeric_limits<double>::infinity() : run.time() + run.next_step();
}

void PastRun::step() {
  const auto begin = Clock::now();
  at_->simulation.step();
  if (at_->simulation.lost()) return;
  const auto worked = Clock::now() - begin;
  at_->wall_time += std::chrono::duration<double>(worked).count();
  if (at_->sampler) {
    at_->sampler->after_step(at_->simulation);
    (void)at_->sampler->take();  // the rows are known
  }
  leave_key_frame(worked);
  apply_due_edits();
}

void PastRun::make_part(double length, bool with_jumps_ahead) {
  if (length == 0.0) return;
  const double start = at_->simulation.time();
  double end = start + length;
  if (end - start < length) end = std::nextafter(end, std::numeric_limits<double>::infinity());
  if (with_jumps_ahead) look_ahead();
  part_ = at_;
  part_->simulation.step(end - start);
  if (part_->sampler && !part_->simulation.lost()) part_->sampler->after_step(part_->simulation);
}

void PastRun::look_ahead_for(double impact) {
  const double rounding = kSameMoment * at_->simulation.method().step;
  const auto met = jump_moments(at_->simulation);
  const bool is_met = std::any_of(met.begin(), met.end(), [&](const auto& moment) {
    return std::abs(moment->time() - impact) <= rounding;
  });
  if (!is_met) look_ahead();
}

void PastRun::look_ahead() {
  Simulation whole = at_->simulation;
  whole.step();
  jumps_ahead_ = jump_moments(whole);
}

void PastRun::leave_key_frame(Clock::duration worked) {
  worked_ += worked;
  const bool is_new = left_.empty() || left_.back()->state.clock.steps < at_->simulation.steps();
  if (worked_ < interval_ || !is_new) return;
  worked_ = {};
  left_.push_back(std::make_shared<const KeyFrame>(
      KeyFrame{at_->simulation.compiled(), at_->simulation.run_state(),
               at_->sampler ? *at_->sampler : Sampler(std::vector<Curve>{}), at_->wall_time, false}));
  if (left_.size() <= kMostLeft) return;
  interval_ *= 2;
  std::vector<std::shared_ptr<const KeyFrame>> rest;
  for (std::size_t i = 1; i < left_.size(); i += 2) rest.push_back(std::move(left_[i]));
  left_ = std::move(rest);
}

std::shared_ptr<Frame> PastRun::frame() const {
  auto frame = std::make_shared<Frame>();
  const Standing& standing = part_ ? *part_ : *at_;
  take_moment(standing.simulation, *frame);
  frame->run = id_;
  frame->jumps = jumps_ahead_ ? *jumps_ahead_ : jump_moments(at_->simulation);
  frame->rows_known_until = frame->time;
  frame->wall_time = standing.wall_time;
  if (standing.sampler) frame->error = standing.sampler->error();
  frame->setup = setup_;
  return frame;
}

}  // namespace carom
