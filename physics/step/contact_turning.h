#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "physics/step/contact_finder.h"
#include "physics/step/neighbours.h"
#include "physics/step/world.h"

namespace carom {

// Cosine of the angle by which a normal may turn in a step, some 25°; what turns further is another contact.
inline constexpr double kLeastCosine = 0.9;

// The flight of a step under guessed contact forces: 3×N, in m and rad, m/s and rad/s, and the forces'
// accelerations; and what presses each body hardest at one of its contacts.
struct GuessedFlight {
  Eigen::Matrix3Xd by;        // the contact forces' accelerations
  Eigen::Matrix3Xd position;  // at the end
  Eigen::Matrix3Xd velocity;  // at the end
  std::vector<Pose> pose;     // at the end, by body
  Eigen::ArrayXd press;       // m/s², see ContactPressing::between
  // By body: the guessed forces leave its motion through the step about as it is.
  std::vector<std::uint8_t> goes_on;
};
// Finds `goes_on` from the other members.
void note_going_on(const World& world, double h, GuessedFlight& flight);

// Sets normals and arms of the contacts for forces that are constant in a step of h s, and targets for the
// velocities at its end, where contacts turn with their bodies.
//
// A force acts along the contact's normal halfway through the step, at one point for both bodies, with the
// arms from where the integrator, on the mean, has the bodies. So a contact's force changes neither momentum
// nor angular momentum of its two bodies, to rounding. The velocities at the end obey the contact as it is
// then:
//   J_end v' = J_mid v' + (J_end - J_mid) v_guess + O(h³),
// so the targets take the second term, and the solver's matrix stays symmetric. A pressed contact that is off
// its surfaces at the end by a gap g, which was so little that rounding or the order of the method made it,
// returns within the next step: it parts at -g/h.
//
// Resting contacts are of order 2 with this, where the integrator is.
void turn_contacts(World& world, double h, const GuessedFlight& flight, const Neighbours& neighbours,
                   FoundContacts& found);

}  // namespace carom
