#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "physics/contact/contacts.h"
#include "physics/step/contact_finder.h"
#include "physics/step/contact_turning.h"
#include "physics/step/gauss_contacts.h"
#include "physics/step/jumps_of_moment.h"
#include "physics/step/world.h"

namespace carom {

// What contact impulses do, entered into the ledger: momentum to static and kinematic bodies, work of
// the latter, and losses. `mean` are the bodies' mean velocities while they act (3×N: m/s, m/s, rad/s).

// Forces that support bodies, or this share of their impulses. Friction and rolling resistance take what they
// oppose. Along the normal, what they take until an open contact has closed is what a landing without rebound
// does; else nothing moves there, and what does is the method's error.
// `passed` in s is the time since the start of their flight, which was guessed as `flight`. Contacts with
// `linear` forces are left out.
void record_support(World& world, const FoundContacts& found, const GaussContacts& linear, double share,
                    const Eigen::Matrix3Xd& mean, double passed, const GuessedFlight& flight);
// Impulses that stop approaches at once, as impacts without rebound do. `closing` in m/s, by contact: of those
// which are impacts. Those of a pair along one normal are one entry of the log.
void record_stops(World& world, const FoundContacts& found, const std::vector<std::optional<double>>& closing,
                  const Eigen::Matrix3Xd& mean, JumpsOfMoment& jumps);

}  // namespace carom
