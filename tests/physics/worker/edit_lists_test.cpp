#include "physics/worker/edit_lists.h"

#include <algorithm>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace carom
