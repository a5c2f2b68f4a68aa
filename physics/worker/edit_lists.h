#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "physics/run/run_setup.h"

namespace carom {

// Lists of the edits of one run, of which most go on from another: what several begin with is kept
// once, so that a list for each of n edits takes memory for n edits, not for n²/2.
class EditLists {
 public:
  enum class List : int {};  // its last edit
  static constexpr List kEmpty{-1};

  // Edits with one id and one time that follow the same list are the same (see is_same) if they add the same
  // bodies: those of a file all have one id, and an edit of a body that comes in leaves its time.
  [[nodiscard]] List list_of(const std::vector<RunEdit>& edits);
  [[nodiscard]] std::vector<RunEdit> edits_of(List list) const;

 private:
  struct Element {
    RunEdit edit;
    List before;
  };
  std::vector<Element> elements_;
  // By a list and the edit that follows: id, time and added bodies.
  std::map<std::tuple<List, std::uint64_t, double, std::uint64_t>, List> after_;
};

}  // namespace carom
