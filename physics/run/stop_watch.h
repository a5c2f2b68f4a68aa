#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "physics/run/met_stop.h"
#include "physics/run/simulation.h"
#include "physics/run/step_again.h"
#include "physics/scene/stop.h"
#include "physics/step/run_clock.h"

namespace carom {

// Steps a run until one of several moments comes (physics/scene/stop.h), or tells the moments in the steps of a
// run that goes on as it would without it.
//
// A moment is found on the run's own motion: the step in which it lies is made again with other lengths, so
// that the state there is one of the run, as exact as its method. That of an impact is just after it; under
// impacts at the step's end it is the step's end.
//
// What passes or falls is looked at at the ends of steps and on both sides of the impacts whose jumps are
// recorded (see ImpactLog), and where it turns back once in between. What begins at its value has not come
// there. Impacts are counted from where the watch begins, those that are logged.
//
// All is at rest when no body that forces move is faster than kRestSpeed (physics/step/pair_motion.h), at its
// centre and rim together, and stays so for kRestLasts. A run that begins at rest has not come to rest.
class StopWatch {
 public:
  static constexpr double kRestLasts = 0.1;  // s: a body that turns back is faster by then

  StopWatch(const std::vector<Stop>& stops, Simulation& run);
  // For runs whose impacts are watched (Simulation::watch_impacts()).
  explicit StopWatch(const std::vector<Stop>& stops);

  // Steps until `end` (s) or the first of the moments, and calls after_step() after each step, as
  // Simulation::advance_to(). The index of the stop that came; nothing at the end and for a lost run.
  template <class AfterStep>
  std::optional<std::size_t> advance_to(Simulation& run, double end, const AfterStep& after_step) {
    while (!run.lost()) {
      while (run.due() != nullptr) run.apply_due();
      const double h = run.next_step(end);
      if (h == 0.0) return std::nullopt;
      const std::optional<std::size_t> stop = step(run, h);
      if (!run.lost()) after_step();
      if (stop) return stop;
    }
    return std::nullopt;
  }

  // Call before a step of next_step() s, with the edits that are due applied; and after it for all moments in
  // this step, in their order. The state of one is that of a step of MetStop::part from its start.
  void begins(const Simulation& run);
  [[nodiscard]] std::vector<MetStop> moments(const Simulation& run);
  // After the run was given other edits.
  void forget_copies() { again_.forget(); }
  // After the run went back to this moment (s).
  void go_back(double time);

 private:
  struct Watched {
    Stop stop;
    // Indices of the bodies that it names; -1: none, or not there yet.
    BodyIndex body = kNoBody;
    BodyIndex with = kNoBody;
    std::vector<double> impacts{};  // s, of those of its kind so far, as many as it asks for
  };
  // What passes a value at one moment of a step.
  struct Look {
    double after = 0.0;  // s since the step's start
    double value = 0.0;
    double rate = 0.0;  // a second; of a speed that of its square, which turns smoothly where it is zero
  };
  // A stop in the step under way.
  struct Coming {
    std::size_t stop = 0;
    double after = 0.0;        // s since the step's start
    double sign = 0.0;         // 1: its value rises there; -1: it falls
    std::int64_t impacts = 0;  // so many of its kind have happened then
  };

  std::optional<std::size_t> step(Simulation& run, double h);
  void find_bodies(const Simulation& run);
  void begin(const Simulation& run, double h);
  [[nodiscard]] double clipped(const Simulation& run, double h) const;
  // Those of all stops in their order; of one stop.
  [[nodiscard]] std::vector<Coming> coming_in(const Simulation& run);
  void add_coming(std::size_t index, const Simulation& run, std::vector<Coming>& coming);
  void add_impacts(std::size_t index, const Simulation& run, std::vector<Coming>& coming) const;
  void add_passings(std::size_t index, const Simulation& run, std::vector<Coming>& coming);
  [[nodiscard]] bool lies_within(const Coming& coming) const {
    return coming.after < (1.0 - kSameMoment) * length_;
  }
  // The rate of `b`, of this state of the run, is taken only where the value may have turned.
  [[nodiscard]] std::optional<Look> turn_between(const Watched& watched, const Look& a, const Look& b,
                                                 const Simulation& run, const State& state);
  [[nodiscard]] double moment_between(const Watched& watched, const Look& a, const Look& b);
  [[nodiscard]] Look look_at(const Watched& watched, double after);
  [[nodiscard]] std::optional<double> rest_in(const Simulation& run);
  // Whether it has come in a run that has made a part of the step.
  [[nodiscard]] bool has_come(const Coming& coming, const Simulation& run) const;
  // The length of the step that leads to it, s, and the run there.
  [[nodiscard]] std::pair<double, Simulation> step_to(const Coming& coming);
  [[nodiscard]] static bool is_there(const Watched& watched) {  // a value that it looks at
    return watched.stop.kind == StopKind::kKineticEnergy ||
           (watched.stop.kind == StopKind::kPassing && watched.body >= 0);
  }
  [[nodiscard]] static bool is_of(const Watched& watched, const ImpactRecord& impact,
                                  const MassProperties& mass);
  [[nodiscard]] static std::int64_t impacts_of(const Watched& watched, const Simulation& run);
  static void count_impacts(Watched& watched, const Simulation& run);
  // In a state of the run in the step under way.
  [[nodiscard]] Look look(const Watched& watched, const Simulation& run, const State& state,
                          double after) const;

  std::vector<Watched> watched_;
  std::shared_ptr<const Model> model_;  // of the indices
  StepAgain again_;
  double start_ = 0.0;       // s, of the step under way
  double length_ = 0.0;      // s, its own
  std::vector<Look> looks_;  // of each stop at its start
  bool rests_ = false;       // all, at its start
};

}  // namespace carom
