#pragma once

#include <cstddef>
#include <vector>

#include "physics/world/frame.h"

namespace carom {

// The most records that a run keeps: some 50 MB.
inline constexpr std::size_t kMostSamples = 400'000;
inline constexpr std::size_t kMostImpacts = 100'000;

// Where there are more records than that, their older nine tenths are thinned to half, again and again, so that
// a long run is there from its start: of four samples those with the least and the largest kinetic energy stay,
// of two impacts the stronger one. So spikes survive. True if nothing went.
bool thin(std::vector<Sample>& samples);
bool thin(std::vector<ImpactRecord>& impacts);

}  // namespace carom
