#pragma once

#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "app/lab/lab_runs.h"
#include "tests/support/scenes.h"

namespace carom {

// What a run has come to, and by which impacts.
struct SeenRun {
  std::int64_t steps;
  State state;
  std::vector<ImpactRecord> impacts;
};

inline std::vector<SeenRun> seen_runs(const LabRuns& runs) {
  std::vector<SeenRun> seen;
  for (std::size_t i = 0; i < runs.frames().size(); ++i) {
    const Frame& frame = *runs.frames()[i];
    const Ring<ImpactRecord>& impacts = runs.recorders()[i]->impacts();
    seen.push_back({frame.steps, frame.state, {}});
    for (std::size_t k = 0; k < impacts.size(); ++k) seen.back().impacts.push_back(impacts[k]);
  }
  return seen;
}

inline void expect_same(const SeenRun& a, const SeenRun& b) {
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_TRUE(test::same_bytes(a.state, b.state));
  ASSERT_EQ(a.impacts.size(), b.impacts.size());
  for (std::size_t i = 0; i < a.impacts.size(); ++i) {
    const ImpactRecord& x = a.impacts[i];
    const ImpactRecord& y = b.impacts[i];
    ASSERT_EQ(x.time, y.time) << "impact " << i;
    ASSERT_EQ(x.a, y.a) << "impact " << i;
    ASSERT_EQ(x.b, y.b) << "impact " << i;
    ASSERT_EQ(x.normal_impulse, y.normal_impulse) << "impact " << i;
    ASSERT_EQ(x.tangential_impulse, y.tangential_impulse) << "impact " << i;
  }
}

inline void expect_same(const std::vector<SeenRun>& a, const std::vector<SeenRun>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    SCOPED_TRACE("run " + std::to_string(i));
    expect_same(a[i], b[i]);
  }
}

}  // namespace carom
