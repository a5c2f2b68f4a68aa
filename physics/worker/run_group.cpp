#include "physics/worker/run_group.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "physics/preset/start_fingerprint.h"

namespace carom {

void RunGroup::load(const Preset& preset, const std::vector<Curve>& curves, ReferenceId reference) {
  preset_ = preset;
  curves_ = curves;
  reference_ = reference;
}

void RunGroup::begin(std::stop_token token) {
  token_ = std::move(token);
  start_ = ++starts_;
  interrupted_ = false;
  interrupted_at_ = start_time(preset_.saved);
  replay_until_.reset();
  cut_.reset();
  past_.clear();
  runs_.clear();
  for (MethodAndEdits& run : runs_of(preset_)) begin_run(std::move(run));
  watch_first();
  changed_ = true;
}

void RunGroup::interrupt() {
  if (!interrupted_ && !runs_.empty()) interrupted_at_ = displayed_time();
  interrupted_ = true;
  changed_ = false;
  replay_until_.reset();
  past_.clear();
}

void RunGroup::keep_runs(EditId edit, Frames untaken, bool taken_back) {
  const double time = interrupted_ ? interrupted_at_ : displayed_time();
  if (!kept_.contains(edit)) {
    // Edits that are taken back can't be made again after a new one.
    if (!taken_back) std::erase_if(kept_, [](const auto& each) { return each.second.returned; });
    kept_[edit] = {.preset = preset_, .begun = runs_begun(), .time = time};
    if (runs_.empty()) kept_[edit].begun.runs = runs_of(preset_);  // they could not begin
    if (cut_) {
      const RunEdit divides{cut_->time, cut_->edit, SceneEdits{}};  // where they are on their way to
      for (MethodAndEdits& run : kept_[edit].begun.runs) {
        const auto place = std::upper_bound(run.edits.begin(), run.edits.end(), divides, is_earlier);
        run.edits.insert(place, divides);
      }
    }
  }
  const auto made = kept_.find(edit);
  Kept& kept = made->second;
  kept.returned = taken_back;
  if (!interrupted_ && !cut_ && kept.begun.start == start_ && kept.time == time) {
    kept.runs = std::exchange(runs_, {});
    kept.untaken = std::move(untaken);
  }
  if (std::distance(kept_.begin(), made) >= kMostKept) std::prev(made, kMostKept)->second.drop_runs();
  interrupt();
}

RunGroup::Frames RunGroup::return_to(EditId edit, const std::vector<Curve>& curves, ReferenceId reference,
                                     std::stop_token token) {
  Kept& kept = kept_.at(edit);
  kept.returned = true;
  load(kept.preset, curves, reference);
  token_ = std::move(token);
  ++starts_;
  start_ = kept.begun.start;
  interrupted_ = false;
  cut_.reset();
  past_.clear();
  runs_ = std::exchange(kept.runs, {});
  for (Run& run : runs_) run.live.interrupt_on(token_);
  if (runs_.empty()) {
    for (const MethodAndEdits& run : kept.begun.runs) begin_run(run);
  }
  watch_first();
  replay_to(kept.time);
  record_all();
  Frames untaken = std::exchange(kept.untaken, {});
  for (const auto& frame : untaken) {
    for (Rows& rows : frame->rows) keep_curves(rows, curves);
  }
  return untaken;
}

RunGroup::Frames RunGroup::cut(EditId edit, double time, const std::vector<RunEdit>& later,
                               std::stop_token token) {
  const Kept& kept = kept_.at(edit);
  preset_ = kept.preset;
  token_ = std::move(token);
  ++starts_;
  start_ = kept.begun.start;
  interrupted_ = false;
  past_.clear();
  runs_.clear();
  for (std::size_t i = 0; i < kept.begun.runs.size(); ++i) {
    MethodAndEdits wanted = kept.begun.runs[i];
    std::erase_if(wanted.edits, [time](const RunEdit& each) { return each.time > time; });
    std::copy_if(later.begin(), later.end(), std::back_inserter(wanted.edits),
                 [time](const RunEdit& each) { return each.time > time; });
    if (i < kept.runs.size()) {
      Run copy = kept.runs[i];
      copy.live.interrupt_on(token_);
      if (copy.live.go_back(time, wanted.edits)) {
        runs_.push_back(std::move(copy));
        continue;
      }
    }
    begin_run(std::move(wanted));
  }
  watch_first();
  replay_to(time);
  cut_ = replay_until_ ? std::optional(Cut{edit, time}) : std::nullopt;
  Frames untaken;
  for (const auto& frame : kept.untaken) untaken.push_back(std::make_shared<Frame>(*frame));
  return untaken;
}

void RunGroup::seek_past(const PastMoment& moment) {
  if (interrupted_ || runs_.empty()) return;
  std::vector<PastRuns::Original> originals;
  for (const Run& run : runs_) originals.push_back({run.live, run.id});
  past_.seek(moment, originals, token_);
}

void RunGroup::replay_to(double time) {
  replay_until_.reset();
  if (first().time() < time) replay_until_ = time;
  changed_ = true;
}

std::vector<RunGroup::MethodAndEdits> RunGroup::runs_of(const Preset& preset) {
  std::vector<MethodAndEdits> all = {{preset.method, preset.edits}};
  for (const Method& method : preset.compare) all.push_back({method, preset.edits});
  return all;
}

void RunGroup::begin_run(MethodAndEdits wanted) {
  RunSetup setup = setup_of(preset_);
  setup.method = wanted.start;
  setup.edits = std::move(wanted.edits);
  runs_.push_back({LiveRun(setup, curves_, reference_, token_), ++ids_});
  changed_ = true;
}

// It has the edits of the scene that the first run has had.
void RunGroup::add_run(const Method& method) {
  if (interrupted_ || runs_.size() > kMostCompared) return;
  MethodAndEdits wanted{method, first().setup().edits};
  std::erase_if(wanted.edits, [](const RunEdit& edit) { return std::holds_alternative<Method>(edit.what); });
  begin_run(std::move(wanted));
}

void RunGroup::remove_run(std::size_t run) {
  if (interrupted_ || run == 0 || run >= runs_.size()) return;
  runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(run));
  changed_ = true;
}

void RunGroup::set_method(std::size_t run, const Method& method, EditId edit) {
  if (interrupted_ || run >= runs_.size()) return;
  runs_[run].live.edit({displayed_time(), edit, method});
  changed_ = true;
}

void RunGroup::edit_scene(const SceneEdits& edits, EditId edit) {
  if (interrupted_ || runs_.empty()) return;
  const double time = displayed_time();
  for (Run& run : runs_) run.live.edit({time, edit, edits});
  replay_to(time);
}

void RunGroup::record(const std::vector<Curve>& curves) {
  curves_ = curves;
  record_all();
}

void RunGroup::compare_with(ReferenceId reference) {
  reference_ = reference;
  record_all();
}

void RunGroup::watch_stops(const std::vector<Stop>& stops) {
  preset_.stops = stops;
  if (interrupted_) return;
  watch_first();
  changed_ = true;
}

void RunGroup::watch_first() {
  if (stops_ == nullptr || *stops_ != preset_.stops)
    stops_ = std::make_shared<const std::vector<Stop>>(preset_.stops);
  for (Run& run : runs_) run.live.watch(&run == &runs_.front() ? stops_ : nullptr);
}

void RunGroup::record_all() {
  if (interrupted_) return;
  for (Run& run : runs_) run.live.record(curves_, reference_);
  changed_ = true;
}

RunGroup::MethodAndEdits RunGroup::method_and_edits(const Run& run) {
  return {run.live.setup().method, run.live.setup().edits};
}

RunGroup::RunsBegun RunGroup::runs_begun() const {
  RunsBegun all{start_, {}};
  for (const Run& run : runs_) all.runs.push_back(method_and_edits(run));
  return all;
}

RunGroup::OtherSide RunGroup::other_side() {
  OtherSide side{start_, fingerprint_of_start(preset_), {}};
  for (const Run& run : runs_) {
    const RunSetup& setup = run.live.setup();
    side.runs.push_back({setup.method, run.id, edit_lists_[run.id].list_of(setup.edits)});
  }
  return side;
}

// Unchanged runs continue as they are.
void RunGroup::undo_or_redo(EditId edit, const Preset& start, ReferenceId reference) {
  const auto found = other_sides_.find(edit);
  if (found == other_sides_.end()) return;
  const OtherSide wanted = std::exchange(found->second, other_side());
  const bool other_reference = std::exchange(reference_, reference) != reference;
  const std::uint64_t scene = fingerprint_of_start(preset_);
  const bool begun_since = wanted.start != start_ || wanted.scene != scene;
  const bool other_start = begun_since && scene != fingerprint_of_start(start);
  if (begun_since) preset_ = start;
  if (interrupted_) return;
  const double time = displayed_time();
  std::vector<Run> old = std::exchange(runs_, {});
  if (other_start) old.clear();
  if (begun_since) {
    for (MethodAndEdits& each : runs_of(start)) take_run(std::move(each), old);
  } else {
    for (const OtherSide::Begun& each : wanted.runs)
      take_run({each.method, edit_lists_[each.run].edits_of(each.edits)}, old);
  }
  watch_first();
  replay_to(time);
  if (other_reference) record_all();
}

// Adds the wanted run: the one of these that has it, or one that can go back to where it parted from it, or
// a new one.
void RunGroup::take_run(MethodAndEdits wanted, std::vector<Run>& old) {
  const auto take = [&](auto run) {
    runs_.push_back(std::move(*run));
    old.erase(run);
  };
  const auto begins_so = [&](const Run& run) { return run.live.setup().method == wanted.start; };
  const auto same = std::find_if(old.begin(), old.end(), [&](const Run& run) {
    const std::vector<RunEdit>& edits = run.live.setup().edits;
    return begins_so(run) &&
           std::equal(edits.begin(), edits.end(), wanted.edits.begin(), wanted.edits.end(), is_same);
  });
  if (same != old.end()) return take(same);
  for (auto run = old.begin(); run != old.end(); ++run) {
    if (begins_so(*run) && run->live.take_edits(wanted.edits)) return take(run);
  }
  begin_run(std::move(wanted));
}

// s, of the first run: its time, or the time to which it is being replayed.
double RunGroup::displayed_time() const { return replay_until_.value_or(first().time()); }

bool RunGroup::end_reached_replay() {
  const std::optional<Cut> cut = std::exchange(cut_, std::nullopt);
  const double rounding = kSameMoment * first().simulation().method().step;
  if (!cut || first().lost() || first().time() + rounding >= cut->time) {
    end_replay();
    return true;
  }
  for (Run& run : runs_) run.live.edit({cut->time, cut->edit, SceneEdits{}});
  return false;
}

// The one that is farthest behind the first run, or the first run if none can step without passing it.
RunGroup::Run& RunGroup::next_to_step() {
  Run& first = runs_.front();
  Run& other = *std::min_element(runs_.begin(), runs_.end(),
                                 [](const Run& a, const Run& b) { return a.live.next() < b.live.next(); });
  return may_step(other, first.live.time()) ? other : first;
}

// True if the run's next step ends not after `time`.
bool RunGroup::may_step(const Run& run, double time) {
  return run.live.next() <= time + kSameMoment * run.live.simulation().method().step;
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
  frame->setup = std::make_shared<const RunSetup>(setup_of(preset_));
  return frame;
}

}  // namespace carom
