#include "physics/worker/edit_lists.h"

#include <algorithm>

#include "physics/preset/start_fingerprint.h"

namespace carom {

EditLists::List EditLists::list_of(const std::vector<RunEdit>& edits) {
  List list = kEmpty;
  for (const RunEdit& edit : edits) {
    const auto [next, is_new] = after_.try_emplace({list, edit.id, edit.time, fingerprint_of_late_bodies(edit)},
                                                   static_cast<List>(elements_.size()));
    if (is_new) elements_.push_back({edit, list});
    list = next->second;
  }
  return list;
}

std::vector<RunEdit> EditLists::edits_of(List list) const {
  std::vector<RunEdit> edits;
  while (list != kEmpty) {
    const Element& last = elements_[static_cast<std::size_t>(list)];
    edits.push_back(last.edit);
    list = last.before;
  }
  std::reverse(edits.begin(), edits.end());
  return edits;
}

}  // namespace carom
