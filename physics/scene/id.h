#pragma once

#include <cstdint>

namespace carom {

// Tells the parts of one kind in a scene apart for as long as a document is edited, whatever their names and
// places in their list; never given again. 0: none was given. Files don't hold them.
template <class Part>
struct Id {
  std::uint32_t number = 0;

  bool operator==(const Id&) const = default;
};

}  // namespace carom
