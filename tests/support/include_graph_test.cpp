#include "tests/support/include_graph.h"

#include <gtest/gtest.h>

#include "tests/support/source_folder.h"

namespace carom {
namespace {

using Files = std::set<std::filesystem::path>;

TEST(IncludeGraph, FollowsIncludesThroughOtherFiles) {
  const test::IncludeGraph graph(test::source(""));
  // The sampler's header is included by the worker's, and that by the session's.
  const Files files = graph.affected({"physics/record/sampler.h"});
  EXPECT_TRUE(files.contains("physics/record/sampler.h"));
  EXPECT_TRUE(files.contains("physics/record/sampler.cpp"));
  EXPECT_TRUE(files.contains("app/lab/session.cpp"));
  EXPECT_FALSE(files.contains("physics/math/roots.h"));
  // A source file concerns itself alone.
  EXPECT_EQ(graph.affected({"physics/record/sampler.cpp"}), Files{"physics/record/sampler.cpp"});
  EXPECT_TRUE(graph.affected({}).empty());
}

TEST(IncludeGraph, FindsTheTestsOfAChange) {
  const test::IncludeGraph graph(test::source(""));
  // Of its folder, and of folders that include one of its files; not of those that stand before it.
  const Files of_step = graph.tests({"physics/step/apply_impact.cpp"});
  EXPECT_TRUE(of_step.contains("tests/physics/run/golden_test.cpp"));
  EXPECT_FALSE(of_step.contains("tests/physics/scene/shape_test.cpp"));
  const Files of_run = graph.tests({"physics/run/simulation.cpp"});
  EXPECT_TRUE(of_run.contains("tests/physics/run/golden_test.cpp"));
  EXPECT_TRUE(of_run.contains("tests/physics/check/presets_test.cpp"));
  const Files of_compare = graph.tests({"widgets/compare/compare_table.cpp"});
  EXPECT_TRUE(of_compare.contains("tests/widgets/compare/compare_panel_test.cpp"));
  EXPECT_FALSE(of_compare.contains("tests/physics/compare/compared_runs_test.cpp"));
  // A test concerns its folder, what tests share those that use it.
  EXPECT_TRUE(
      graph.tests({"tests/physics/scene/shape_test.cpp"}).contains("tests/physics/scene/shape_test.cpp"));
  const Files of_draws = graph.tests({"tests/support/draws.h"});
  EXPECT_TRUE(of_draws.contains("tests/physics/run/mixed_crowd_test.cpp"));
  EXPECT_FALSE(of_draws.contains("tests/physics/run/golden_test.cpp"));
  // A preset is read by many tests.
  const Files of_preset = graph.tests({"presets/piles/pile.json"});
  EXPECT_TRUE(of_preset.contains("tests/physics/run/golden_test.cpp"));
  EXPECT_TRUE(of_preset.contains("tests/app/cli/golden_outputs_test.cpp"));
  EXPECT_FALSE(of_preset.contains("tests/physics/scene/shape_test.cpp"));
}

}  // namespace
}  // namespace carom
