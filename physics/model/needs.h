#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physics/scene/facts.h"
#include "physics/scene/method.h"
#include "physics/scene/scene.h"

namespace carom {

// The parts of a model that not every scene needs. part_entries() says what each one adds.
enum class Part : std::uint8_t {
  kRotation,
  kFriction,
  kSticking,
  kDrag,
  kSprings,
  kAttraction,
  kAppliedForces,
  kSwitching,
  kDrives,
  kJoints,
  kRestingContacts
};
inline constexpr std::size_t kPartCount = 11;

// The parts that a model has. A part may be left out only if it provably has no effect until the scene is
// edited. The user's integrator is never replaced.
class Needs {
 public:
  [[nodiscard]] bool has(Part part) const { return parts_[static_cast<std::size_t>(part)]; }
  void set(Part part, bool needed = true) { parts_[static_cast<std::size_t>(part)] = needed; }
  bool operator==(const Needs&) const = default;

  // Also without the short cuts that change only rounding: all bodies are advanced together.
  bool untrimmed = false;

 private:
  std::bitset<kPartCount> parts_;
};

// One part: what it is called, why it is needed, and how to find out.
struct PartEntry {
  Part part;
  std::string_view key;      // in JSON
  std::string_view noun;     // for people
  std::string_view brings;   // what it puts into the model, and what a step does for it
  std::string_view why;      // where it is needed
  std::string_view why_not;  // where it is not
  bool (*needed)(const SceneFacts&, const Scene&);
  bool varies = false;  // its forces vary in flight, which is no parabola then
};

// In the order of Part.
[[nodiscard]] std::span<const PartEntry> part_entries();

// The parts that `scene` needs: a pure function of the scene.
[[nodiscard]] Needs needs_of(const Scene& scene);

// All parts, whatever the scene, without short cuts; for comparison.
[[nodiscard]] Needs all_needs();

// True if forces support resting bodies: the method asks for resting contacts, and the scene needs them.
[[nodiscard]] inline bool contacts_last(const Method& method, const Needs& needs) {
  return method.contacts == ContactsId::kLasting && needs.has(Part::kRestingContacts);
}
// False if bodies may rest on each other, and the method has impulses only.
[[nodiscard]] inline bool knows_contact_forces(const Method& method, const Needs& needs) {
  return method.contacts == ContactsId::kLasting || !needs.has(Part::kRestingContacts);
}

// For people: the parts that are modelled and those that are not needed, each a short noun.
struct NeedsText {
  std::vector<std::string> modelled;
  std::vector<std::string> not_needed;
};
[[nodiscard]] NeedsText text_of(const Needs& needs, const Scene& scene, ContactsId contacts);

}  // namespace carom
