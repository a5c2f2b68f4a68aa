#pragma once

#include <string>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

namespace carom {

// Measured and expected figure of one expectation.
struct Outcome {
  double measured = 0.0;  // NaN if the moment never came
  double error = 0.0;     // measured - value
  bool good = false;      // |error| <= tolerance
  bool known = true;      // false: a contact force, of a method that has impulses only
  std::string unit;       // of the figures; empty for the unit of a sweep's place, which only its file knows
};

// What an expectation is about, without its value, for people: "maximum of speed of ball from 1 s, with mass
// of ball = 2".
[[nodiscard]] std::string text_of(const Expectation& expectation, const Preset& preset);

// All expectations of a scene, with their settings and sweeps. Construct, call run() once for each index
// below the number of runs, in any order and on any threads, then read outcomes(). Expectations with the same
// settings share a run.
class ExpectationCheck {
 public:
  // Throws SceneError, with the place of the expectation, if the scene does not allow a setting.
  explicit ExpectationCheck(const Preset& preset);

  [[nodiscard]] int runs() const { return static_cast<int>(runs_.size()); }
  // Thread-safe for different runs.
  void run(int index);
  // In the order of the scene's expectations; all runs must be done. The numbers don't depend on the threads.
  [[nodiscard]] std::vector<Outcome> outcomes() const;

 private:
  struct Run {
    std::vector<Setting> settings;
    std::vector<Expectation> expectations;
    std::vector<double> values;
    bool knows_contact_forces = true;
  };
  // The contribution of one run to one expectation.
  struct Source {
    int run;
    int index;
  };
  Preset preset_;
  std::vector<Run> runs_;
  std::vector<std::vector<Source>> sources_;  // of each expectation, one for each value of its sweep
};

// Runs and reduces all expectations of a scene on `threads` threads (0: one for each core).
[[nodiscard]] std::vector<Outcome> check_expectations(const Preset& preset, int threads = 0);

}  // namespace carom
