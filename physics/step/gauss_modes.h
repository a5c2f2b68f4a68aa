#pragma once

#include "physics/step/gauss_island.h"

namespace carom {

// Whether contacts press or are open, stick or slip, from the start of a step on, and until when: read off the
// linear forces and the flights under them (gauss_contacts.h).

// Whether a contact that does not press closes, by more than `off` (m).
[[nodiscard]] bool closes(const GaussStep& step, const GaussContact& c, double off = 0.0);
// Where contacts are more than would hold their bodies, and no forces meet them all: those that stick keep the
// friction that they have; else the one that presses least is to press no more. False if none is left.
bool ask_less(GaussIsland& island);
// Changes the modes that don't hold at the start; whether there were any. If not, `ends` (s) becomes no later
// than the first moment at which a contact lets go, breaks away or stops slipping.
bool change_modes(const GaussStep& step, GaussIsland& island, double& ends);
// Whether the island's contacts without forces don't close.
[[nodiscard]] bool stay_open(const GaussStep& step, const GaussIsland& island);

}  // namespace carom
