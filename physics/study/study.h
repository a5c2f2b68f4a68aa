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

// Options of a study. Empty lists mean everything that the scene allows.
struct StudyOptions {
  std::vector<IntegratorId> integrators;
  std::vector<ImpactsId> impacts;
  std::vector<double> steps;       // s; default: default_steps()
  std::vector<double> tolerances;  // of the adaptive integrator; default: 1e-3 to 1e-12
  std::optional<double> until;     // s, the compared time; default: see plan_time()
  int repeats = 5;                 // of the timing
  int threads = 0;                 // 0: one for each core
};

inline constexpr int kDefaultSteps = 10;
// s, falling: kDefaultSteps, halved from 16 times the scene's step.
[[nodiscard]] std::vector<double> default_steps(const Preset& preset);

// The complete rows of a study: every integrator under every impacts choice at every step. The adaptive
// integrator has tolerances in place of steps (its results, and so impacts at the step's end, come at the
// scene's own step); exact flight has one row, with impacts at their own time. With resting contacts all have
// steps (see error_parameter()), the adaptive integrator at the scene's own tolerance. Throws SceneError if a
// requested integrator can't run the scene.
[[nodiscard]] std::vector<Method> plan_methods(const Preset& preset, const StudyOptions& options);

// The time to compare at, in s: the one in the last quarter before `end` that is farthest from any impact
// (off the middle between two, where a bouncing ball turns round), rounded to four digits; `end` itself if
// its distance is at least half of that.
[[nodiscard]] double plan_time(const std::vector<TimedImpact>& impacts, double end);

// Callbacks of a running study. Calls come from any thread, one at a time; each may be empty.
struct StudyCallbacks {
  // How many runs of the present stage are done.
  std::function<void(std::string_view stage, int done, int of)> progress;
  // A row whose accuracy is known; then again after each of its timed runs, with the times so far. The last
  // call for a row has the values of the table.
  std::function<void(const StudyFacts& facts, const StudyRow& row)> row;
  // Checked at every step of every run: run_study() then throws Cancelled, after all its threads have ended.
  std::stop_token stop;
};

// Runs a study: neighbours, reference, then the accuracy of every row on all cores. The
// timing follows with nothing else of the study running, one run after another: the first repeat of every
// row, the second of every row, and so on, so that a machine that changes its speed shows in the spread.
// Everything but the times is independent of the number of threads. A row continues beyond the compared time
// by a tenth, to find the partners of late impacts; the timed runs end at that time.
[[nodiscard]] StudyTable run_study(const Preset& preset, const std::string& name, const StudyOptions& options,
                                   const StudyCallbacks& callbacks = {});

// State of a study while it runs and after it has ended.
struct StudySoFar {
  enum class Phase { kRunning, kDone, kCancelled, kRefused };
  Phase phase = Phase::kRunning;
  std::string stage;    // the present stage
  int done = 0;         // its runs that are done
  int of = 0;           // its runs in all
  StudyTable table;     // the rows whose accuracy is known, by index; their times come later
  std::string refusal;  // in one line: why the study is impossible
  int changes = 0;      // number of changes to all this so far
};

// run_study() on its own thread, with its own copies. May be read from any thread.
class BackgroundStudy {
 public:
  BackgroundStudy(Preset preset, std::string name, StudyOptions options);
  // Cancels the study, which takes a step of the simulation on each core.
  ~BackgroundStudy() = default;
  BackgroundStudy(const BackgroundStudy&) = delete;
  BackgroundStudy& operator=(const BackgroundStudy&) = delete;

  // Returns at once; so_far() shows when the study has stopped. Its results up to then remain.
  void stop() { thread_.request_stop(); }
  [[nodiscard]] StudySoFar so_far() const;

 private:
  void run(const Preset& preset, const std::string& name, const StudyOptions& options,
           const std::stop_token& stop);
  void take(const StudyFacts& facts, const StudyRow& row);

  mutable std::mutex mutex_;
  StudySoFar so_far_;
  std::jthread thread_;  // the last member: it ends before the others are destroyed
};

}  // namespace carom
