#include <algorithm>

#include "physics/math/cancelled.h"
#include "physics/preset/preset.h"
#include "physics/study/study.h"

namespace carom {

BackgroundStudy::BackgroundStudy(Preset preset, std::string name, StudyOptions options)
    : thread_([this, preset = std::move(preset), name = std::move(name), options = std::move(options)](
                  const std::stop_token& stop) { run(preset, name, options, stop); }) {}

StudySoFar BackgroundStudy::so_far() const {
  const std::lock_guard lock(mutex_);
  return so_far_;
}

void BackgroundStudy::run(const Preset& preset, const std::string& name, const StudyOptions& options,
                          const std::stop_token& stop) {
  StudyCallbacks callbacks;
  callbacks.stop = stop;
  callbacks.progress = [this](std::string_view stage, int done, int of) {
    const std::lock_guard lock(mutex_);
    so_far_.stage = stage;
    so_far_.done = done;
    so_far_.of = of;
    ++so_far_.changes;
  };
  callbacks.row = [this](const StudyFacts& facts, const StudyRow& row) { take(facts, row); };
  const auto end = [this](StudySoFar::Phase phase, const std::string& refusal) {
    const std::lock_guard lock(mutex_);
    so_far_.phase = phase;
    so_far_.refusal = refusal;
    ++so_far_.changes;
  };
  try {
    (void)run_study(preset, name, options, callbacks);
    end(StudySoFar::Phase::kDone, {});
  } catch (const Cancelled&) {
    end(StudySoFar::Phase::kCancelled, {});
  } catch (const std::exception& error) {
    end(StudySoFar::Phase::kRefused, error.what());
  }
}

void BackgroundStudy::take(const StudyFacts& facts, const StudyRow& row) {
  const std::lock_guard lock(mutex_);
  StudyTable& table = so_far_.table;
  if (table.rows.empty()) table.facts = facts;
  const auto place = std::lower_bound(table.rows.begin(), table.rows.end(), row.index,
                                      [](const StudyRow& other, int index) { return other.index < index; });
  if (place != table.rows.end() && place->index == row.index) {
    *place = row;
  } else {
    table.rows.insert(place, row);
  }
  ++so_far_.changes;
}

}  // namespace carom
