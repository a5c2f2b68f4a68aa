#pragma once

#include <cstdint>
#include <vector>

#include "physics/contact/islands.h"
#include "physics/step/gauss_island.h"

namespace carom {

// Contact forces that are linear in time during a step, where contacts turn with their bodies.
//
// Constant forces that satisfy the contacts at a step's end (resting_contacts.h) are of order 2 there. They
// tell which contacts press, and which of those stick. In small islands improve() then replaces them by forces
// at the two Gauss points of the step, t = h (1/2 ∓ √3/6), and by what is linear in time through both, such
// that under the integrator's own flight
//   - a contact that presses is closed at the end, and doesn't part: g = 0, g' = 0;
//   - one that sticks doesn't slip halfway and at the end;
//   - one that slips has T = -σ μ_k N at both points, where σ is the sign of its slip.
// Each force acts along the normal of its own moment, at one point for both bodies, with arms from the means of
// their paths: momentum is kept to rounding, and angular momentum too where no other force bends the paths.
// What the true forces have beyond that has no part in the first two moments, so that the order is 4 (E.
// Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, section II.1.3), or the integrator's if that
// is lower.
//
// Rolling resistance, contacts that turn by more than kLeastCosine in a step, and those that another body
// continues keep constant forces.
class GaussContacts {
 public:
  // Starts a part of a step of the method of step_length s at this absolute time.
  void begin_part(double time, double step_length);
  // Replaces constant forces in a part of h s from the epoch on. The contacts that were found get the means of
  // the linear ones. Velocities that contacts ask for are met to `tolerance`, and what slips slower than
  // `slip_speed` may stick (m/s). Returns the first time in s at which a contact changes its mode, h if none
  // does. An island whose modes don't last until `least` (s) keeps its constant forces. Where that is h, the
  // part can't be divided: what sticks breaks away at its end.
  double improve(World& world, double h, const Neighbours& neighbours, double tolerance, double slip_speed,
                 const Islands& islands, double least, FoundContacts& found);
  void clear();
  // Whether the forces of some contact are linear; of this one.
  [[nodiscard]] bool any() const { return !all_.empty(); }
  [[nodiscard]] bool has(int contact) const {
    return !improved_.empty() && improved_[static_cast<std::size_t>(contact)] != 0;
  }
  // Whether they are those of all contacts that press.
  [[nodiscard]] bool replaces_all(const Contacts& found) const {
    for (int i = 0; i < found.size(); ++i) {
      if (found.normal_impulse[i] > 0.0 && !has(i)) return false;
    }
    return any();
  }
  // Enters the work and the impulses of the linear forces until `passed` s after the epoch into the ledger.
  void record(World& world, double passed) const;

 private:
  void join(const World& world, const Contacts& found, const Islands& islands);
  void move_contacts(int from, int to);
  bool settle(const GaussStep& step, double& ends);
  void enter(const GaussStep& step);
  void note_breaks(const GaussStep& step, double ends);

  double h_ = 0.0;                        // s
  std::vector<std::vector<int>> joined_;  // contacts of islands, together where joints join their bodies
  ArrayOf<IslandIndex, int> joined_of_;   // which of these; -1: none
  GaussIsland island_;
  std::vector<GaussContact> all_;       // that have linear forces
  std::vector<std::uint8_t> improved_;  // by contact
  std::vector<GaussBreak> breaks_;      // at the start of this part
  std::vector<GaussBreak> next_;        // at its end
};

}  // namespace carom
