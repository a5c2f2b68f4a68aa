#include "physics/worker/stop_record.h"

#include <utility>

namespace carom {

StopRecord::StopRecord(Stops stops, const RunSetup& setup, const Simulation& run,
                       const std::stop_token& interrupt)
    : stops_(std::move(stops)), watch_(*stops_) {
  if (!stops_->empty() && run.steps() > 0) replay_.emplace(setup, interrupt);
}

void StopRecord::before_step(const Simulation& run) {
  if (!behind()) watch_.begins(run);
}

void StopRecord::after_step(const Simulation& run) {
  if (behind()) return;
  last_ = watch_.moments(run);
  fresh_.insert(fresh_.end(), last_.begin(), last_.end());
}

void StopRecord::take_edits(const std::vector<RunEdit>& edits) {
  watch_.forget_copies();
  if (replay_) replay_->set_edits(edits);
}

void StopRecord::go_back(double time) {
  watch_.go_back(time);
  last_.clear();
  std::erase_if(fresh_, [time](const MetStop& met) { return met.time > time; });
}

void StopRecord::catch_up(const Simulation& run, std::chrono::steady_clock::duration duration) {
  using Clock = std::chrono::steady_clock;
  if (!replay_) return;
  const auto begin = Clock::now();
  const auto is_there = [&] { return replay_->simulation().steps() >= run.steps(); };
  bool any = false;  // take at least one step, however short the time
  replay_->go_through([](const RunEdit&) {},
                      [&](const Simulation& past) {
                        const bool goes_on =
                            !is_there() && (!std::exchange(any, true) || Clock::now() - begin < duration);
                        if (goes_on) watch_.begins(past);
                        return goes_on;
                      },
                      [&](const Simulation& past) {
                        const std::vector<MetStop> met = watch_.moments(past);
                        fresh_.insert(fresh_.end(), met.begin(), met.end());
                      });
  if (!is_there()) return;
  replay_.reset();
  watch_.forget_copies();
}

void StopRecord::take(Frame& frame) {
  frame.stops = stops_;
  frame.met = std::exchange(fresh_, {});
}

}  // namespace carom
