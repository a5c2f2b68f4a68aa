#pragma once

#include <string>
#include <vector>

#include "physics/preset/preset.h"
#include "physics/scene/scene.h"

namespace carom {

// What a scene showed beside what it expects.
struct Outcome {
  double measured = 0.0;  // NaN if the moment never came
  double error = 0.0;     // measured - value
  bool good = false;      // |error| <= tolerance
  std::string unit;       // of all of them; empty for the unit of a sweep's place, which only its file knows
};

// For people: what an expectation is about, without its value: "maximum of speed of ball from 1 s, with mass of
// ball = 2".
[[nodiscard]] std::string text_of(const Expectation& expectation, const Preset& preset);

// All expectations of a scene, with their settings and sweeps: the runs that they need, each to be done once,
// in any order and on any thread, and what comes of them. Expectations with the same settings share a run.
class ExpectationCheck {
 public:
  // Throws SceneError, with the place of the expectation, if the scene does not allow a setting.
  explicit ExpectationCheck(const Preset& preset);

  [[nodiscard]] int runs() const { return static_cast<int>(runs_.size()); }
  // Different runs may go on at the same time.
  void run(int index);
  // In the order of the scene's expectations, when all runs are done. The numbers don't depend on who ran what.
  [[nodiscard]] std::vector<Outcome> outcomes() const;

 private:
  struct Run {
    std::vector<Setting> settings;
    std::vector<Expectation> expectations;
    std::vector<double> values;
  };
  // The number that one expectation has from one run.
  struct Source {
    int run;
    int index;
  };
  Preset preset_;
  std::vector<Run> runs_;
  std::vector<std::vector<Source>> sources_;  // of each expectation, one for each value of its sweep
};

// Runs and reduces all expectations of a scene, on as many threads (0: as many as the machine has cores).
[[nodiscard]] std::vector<Outcome> check_expectations(const Preset& preset, int threads = 0);

}  // namespace carom
