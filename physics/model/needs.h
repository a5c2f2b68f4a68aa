#pragma once

#include <string>
#include <vector>

#include "physics/scene/method.h"
#include "physics/scene/scene.h"

namespace carom {

// Which parts of the model a scene needs. A part may be dropped only where it provably stays idle for as long
// as nobody edits the scene; the integrator that the user chose is never dropped.
struct Needs {
  bool rotation = true;          // something turns, or can be made to turn
  bool friction = true;          // impacts have a tangential impulse
  bool smooth_forces = true;     // anything but uniform gravity acts in flight
  bool velocity_forces = true;   // drag or dampers: forces that take energy in flight
  bool coupled_forces = true;    // springs between free bodies, attraction: bodies can't be advanced one by one
  bool links = true;             // rods, strings, pins, welds, bodies that stick: can't be advanced one by one
  bool drives = true;            // bodies that move as they are told, or applied forces
  bool switching = true;         // one-sided springs, forces that start or end: moments to be located
  bool lasting_contacts = true;  // something can press bodies together for a while

  // True where free flight has a closed form: uniform gravity and constant forces only.
  bool closed_form_flight = false;

  // Not even the short cuts are taken that change nothing but rounding: all bodies are advanced together.
  bool untrimmed = false;

  bool operator==(const Needs&) const = default;
};

// What `scene` needs: a pure function of its bodies, materials and forces.
[[nodiscard]] Needs needs_of(const Scene& scene);

// True if forces hold what touches: the method asks for contacts that last, and the scene needs them.
[[nodiscard]] inline bool contacts_last(const Method& method, const Needs& needs) {
  return method.contacts == ContactsId::kLasting && needs.lasting_contacts;
}

// Everything that is modelled, whatever the scene: for comparison.
[[nodiscard]] constexpr Needs all_needs() { return {.untrimmed = true}; }

// For people: the parts that are modelled and those that are not needed, each a short noun.
struct NeedsText {
  std::vector<std::string> modelled;
  std::vector<std::string> not_needed;
};
[[nodiscard]] NeedsText text_of(const Needs& needs, const Scene& scene, ContactsId contacts);

}  // namespace carom
