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

// In a run, bodies of generators have this number and their place among all bodies.
inline constexpr std::uint32_t kFirstGenerated = 0x4000'0000;

}  // namespace carom
