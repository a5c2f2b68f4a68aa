#pragma once

#include <cstddef>

// Limits on the impacts of a step; each limit that is reached is reported by a notice.
namespace carom {

// Located impacts in one step before the rest of it is resolved at its end: some seconds of work. Galperin's
// billiard with a mass ratio of 10¹² has 3 141 592.
inline constexpr int kMostImpactsPerStep = 4'000'000;
// The same at one time, to the last bit: an elastic disc that starts inside two bodies bounces between them
// for ever.
inline constexpr int kMostImpactsAtOnce = 200'000;
// The same for a pair with corners, whose search may take a millisecond: a light body may be crushed between
// two others for as long as friction takes what it gains.
inline constexpr int kMostCornersAtOnce = 20'000;
// Impacts of a step that last_impacts() lists, some 100 MB.
inline constexpr std::size_t kMostLogged = 1'000'000;

}  // namespace carom
