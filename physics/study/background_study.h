#pragma once

#include <mutex>
#include <string>
#include <thread>

#include "physics/preset/preset.h"
#include "physics/study/study.h"

namespace carom {

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
