#include "physics/record/run_interval.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <variant>

namespace carom {
namespace {

// A run on its way through the interval.
class IntervalReplay {
 public:
  IntervalReplay(Replay replay, const std::function<bool()>& go_on)
      : replay_(std::move(replay)), go_on_(go_on) {}

  // To the last end of a step that is not after `time`; then there is a copy at that time.
  bool go_to(double time) {
    bool cancelled = false;
    replay_.go_through(
        [this](const RunEdit& edit) { edited_ |= std::holds_alternative<SceneEdits>(edit.what); },
        [&](const Simulation& s) {
          if (s.lost() || s.next_step(time) < s.next_step()) return false;
          cancelled = !go_on_();
          return !cancelled;
        },
        [this](const Simulation& s) { note(s); });
    if (cancelled) return false;
    at_.emplace(replay_.simulation());
    const double left = at_->next_step(time);
    if (left == 0.0) return true;
    at_->step(left);
    ahead_ = true;
    return true;
  }

  // What happened so far does not count; of the step that the copy has begun the impacts that it has met.
  void begin() {
    edited_ = false;
    met_ = std::exchange(ahead_, false) ? at_->last_impacts().size() : 0;
    touched_.assign(at_->bodies().size(), false);
  }
  void end() {
    if (std::exchange(ahead_, false)) note(*at_);
  }

  [[nodiscard]] const Simulation& at() const { return *at_; }
  [[nodiscard]] bool edited() const { return edited_; }
  [[nodiscard]] const std::vector<bool>& touched() const { return touched_; }

 private:
  void note(const Simulation& s) {
    touched_.resize(s.bodies().size(), false);
    const std::span<const ImpactRecord> impacts(s.last_impacts());
    for (const ImpactRecord& impact : impacts.subspan(std::min(std::exchange(met_, 0), impacts.size())))
      touch(impact.a, impact.b);
    for (const ContactForce& contact : s.contact_forces()) touch(contact.a, contact.b);
  }
  void touch(BodyIndex a, BodyIndex b) {
    touched_[static_cast<std::size_t>(a)] = true;
    touched_[static_cast<std::size_t>(b)] = true;
  }

  Replay replay_;
  const std::function<bool()>& go_on_;
  std::optional<Simulation> at_;
  bool ahead_ = false;   // the copy is within a step
  std::size_t met_ = 0;  // impacts of the next step that are from before
  std::vector<bool> touched_;
  bool edited_ = false;
};

}  // namespace

std::optional<RunInterval> run_interval(const RunSetup& setup,
                                        std::span<const std::shared_ptr<const KeyFrame>> key_frames,
                                        double from, double to, const std::function<bool()>& go_on) {
  const std::shared_ptr<const KeyFrame> moment = latest_before(key_frames, from, {});
  IntervalReplay replay(moment ? Replay(*moment, setup.edits) : Replay(setup), go_on);
  if (!replay.go_to(from)) return std::nullopt;
  RunInterval found;
  found.from = from;
  found.to = to;
  found.before = replay.at().state();
  replay.begin();
  if (!replay.go_to(to)) return std::nullopt;
  replay.end();
  found.compiled = replay.at().compiled();
  found.joints = replay.at().joints();
  found.after = replay.at().state();
  found.touched = replay.touched();
  found.edited = replay.edited();
  return found;
}

}  // namespace carom
