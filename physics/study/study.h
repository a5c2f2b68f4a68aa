#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "physics/compare/comparison.h"
#include "physics/preset/preset.h"
#include "physics/study/study_table.h"

namespace carom {

// What a study is asked to do. Empty lists stand for what the scene allows.
struct StudyOptions {
  std::vector<IntegratorId> integrators;
  std::vector<ImpactsId> impacts;
  std::vector<double> steps;  // s; default: kDefaultSteps, from 16 times the scene's own, each half the last
  std::vector<double> tolerances;  // of the adaptive integrator; default: 1e-3 to 1e-12
  std::optional<double> until;     // s, the compared time; default: see plan_time()
  int repeats = 5;                 // of the timing
  int threads = 0;                 // 0: one a core
  int shard = 1;                   // this part of
  int shards = 1;                  // so many
};

inline constexpr int kDefaultSteps = 10;

// The rows of a study, whole: every integrator under every impacts choice at every step. For the adaptive
// integrator tolerances take the place of the steps (its results, and so impacts at the step's end, come at the
// scene's own step); exact flight has one row, with impacts at their own time. Where contacts last, all have
// steps (see error_knob()), the adaptive integrator at the scene's own tolerance.
// Throws SceneError where an integrator that is asked for by name can't run the scene.
[[nodiscard]] std::vector<Method> plan_methods(const Preset& preset, const StudyOptions& options);

// The moment to compare at, in s. In the last quarter before `end` it is the one that has the most room
// to the impacts (off the middle between two, where a bouncing ball turns round), rounded to four digits; `end`
// itself if that has at least half the room.
[[nodiscard]] double plan_time(const std::vector<TimedImpact>& impacts, double end);

// How a study is followed while it runs. Calls come from any thread, one at a time, and may be left out.
struct StudyWatch {
  // Of the stage under way, how many of its runs are done.
  std::function<void(std::string_view stage, int done, int of)> progress;
  // A row whose accuracy is known; then again after each of its timed runs, with the times so far. What comes
  // last for a row stands in the table.
  std::function<void(const StudyFacts& facts, const StudyRow& row)> row;
  // Asked at every step of every run: the study then throws Stopped, and no thread of it is left.
  std::stop_token stop;
};

// Carries out a study or one shard of it: neighbours, reference, then the accuracy of every row on all
// cores, then, with nothing else of the study running, their times, one run after another: the first
// repeat of every row, the second of every row, and so on, so that a machine that changes its pace shows in
// the spread. All but the times is the same whatever the number of threads. A row goes on past the compared
// time by a tenth, to find the partners of late impacts; the timed runs end there.
[[nodiscard]] StudyTable run_study(const Preset& preset, const std::string& name, const StudyOptions& options,
                                   const StudyWatch& watch = {});

// What is known of a study while it runs, and when it has ended.
struct StudySoFar {
  enum class Phase { kRunning, kDone, kCancelled, kRefused };
  Phase phase = Phase::kRunning;
  std::string stage;    // that is under way: of its runs
  int done = 0;         // so many are done
  int of = 0;           // of so many
  StudyTable table;     // the rows whose accuracy is known, by index; their times come later
  std::string refusal;  // in one line: why there can be no study
  int changes = 0;      // of all this, so far
};

// run_study() on a thread of its own. It works on copies and can be looked at from any thread.
class BackgroundStudy {
 public:
  BackgroundStudy(Preset preset, std::string name, StudyOptions options);
  // Stops it, which takes a step of the simulation on each core.
  ~BackgroundStudy() = default;
  BackgroundStudy(const BackgroundStudy&) = delete;
  BackgroundStudy& operator=(const BackgroundStudy&) = delete;

  // Returns at once; so_far() says when it has stopped. What it has found by then remains.
  void stop() { thread_.request_stop(); }
  [[nodiscard]] StudySoFar so_far() const;

 private:
  void run(const Preset& preset, const std::string& name, const StudyOptions& options,
           const std::stop_token& stop);
  void take(const StudyFacts& facts, const StudyRow& row);

  mutable std::mutex mutex_;
  StudySoFar so_far_;
  std::jthread thread_;  // the last member: it ends before the others go
};

}  // namespace carom
