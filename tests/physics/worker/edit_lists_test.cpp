#include "physics/worker/edit_lists.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace carom {
namespace {

RunEdit edit(double time, std::uint64_t id) {
  Method method;
  method.step = 0.001 * static_cast<double>(id + 1);
  return {time, id, method};
}

bool are_same(const std::vector<RunEdit>& a, const std::vector<RunEdit>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const RunEdit& one, const RunEdit& other) {
    return is_same(one, other) && std::get<Method>(one.what).step == std::get<Method>(other.what).step;
  });
}

TEST(EditLists, GiveBackWhatTheyTook) {
  EditLists lists;
  std::vector<std::vector<RunEdit>> all = {{}};
  for (std::uint64_t k = 1; k <= 20; ++k) {
    all.push_back(all.back());
    all.back().push_back(edit(0.1 * static_cast<double>(k), k));
  }
  // One that parts from the others in the middle, and two edits of one drag at one time.
  all.push_back({edit(0.1, 1), edit(0.2, 2), edit(0.25, 30), edit(0.25, 30), edit(0.3, 3)});
  std::vector<EditLists::List> names;
  for (const auto& edits : all) names.push_back(lists.list_of(edits));
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(are_same(lists.edits_of(names[i]), all[i])) << i;
    EXPECT_EQ(lists.list_of(all[i]), names[i]) << i;
  }
  EXPECT_EQ(names.front(), EditLists::kEmpty);
}

// A disc of a file, whose time stays while its mass is edited.
TEST(EditLists, TellBodiesOfOneTimeApart) {
  const auto late = [](double mass) {
    return std::vector<RunEdit>{
        {0.3, 0, SceneEdits{Add<Body>{test::disc("late", {0.0, 0.0}, {0.0, 0.0}, 0.1, mass)}}}};
  };
  EditLists lists;
  const EditLists::List light = lists.list_of(late(1.0));
  const EditLists::List heavy = lists.list_of(late(5.0));
  const auto mass_in = [&](EditLists::List list) {
    return *std::get<Add<Body>>(std::get<SceneEdits>(lists.edits_of(list).at(0).what).at(0)).part.mass;
  };
  EXPECT_EQ(mass_in(light), 1.0);
  EXPECT_EQ(mass_in(heavy), 5.0);
  EXPECT_EQ(lists.list_of(late(1.0)), light);
}

}  // namespace
}  // namespace carom
