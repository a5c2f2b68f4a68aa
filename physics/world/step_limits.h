#pragma once

#include <cstddef>

// What a step may have of impacts; each limit that is met is told by a notice.
namespace carom {

// Located impacts in one step before the rest of it is resolved at its end: some seconds of work. Galperin's
// billiard with a mass ratio of 10¹² has 3 141 592.
inline constexpr int kMostImpactsPerStep = 4'000'000;
// Likewise at one time, to the last bit: an elastic disc that starts inside two bodies bounces between them
// for ever.
inline constexpr int kMostImpactsAtOnce = 200'000;
// And of a pair with corners, for which a millisecond may go into looking ahead: a light one may be crushed
// between two for as long as friction takes what it gains.
inline constexpr int kMostCornersAtOnce = 20'000;
// Impacts of a step that are kept in last_impacts(), some 100 MB.
inline constexpr std::size_t kMostLogged = 1'000'000;

}  // namespace carom
