#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace carom {

// The names of the selected bodies, in the order of their choice. Each change says whether it changed anything.
class Selection {
 public:
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] bool empty() const { return names_.empty(); }
  [[nodiscard]] bool contains(const std::string& name) const {
    return std::find(names_.begin(), names_.end(), name) != names_.end();
  }

  bool set(std::vector<std::string> names) {
    if (names == names_) return false;
    names_ = std::move(names);
    return true;
  }
  // Adds the name, or takes it out.
  void toggle(const std::string& name) {
    if (std::erase(names_, name) == 0) names_.push_back(name);
  }
  // Keeps what `stays` accepts.
  template <class Predicate>
  bool keep_if(Predicate stays) {
    return std::erase_if(names_, [&](const std::string& name) { return !stays(name); }) > 0;
  }

 private:
  std::vector<std::string> names_;
};

}  // namespace carom
