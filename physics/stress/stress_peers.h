#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace carom {

// What another engine showed in the scene of a stress case, measured with its own program in the same set-up on
// one machine: Box2D 3.2 ("v3"; 4 sub-steps, single precision, stiffer when "tuned": its contact stiffness
// raised with 64 sub-steps at 480 Hz), Box2D 2.4.1 ("2.4"; 8 velocity and 3 position iterations) and
// Chipmunk 7.0.3
// ("Cp"; 10 iterations), at 60 Hz unless the note says otherwise; sleeping off. The program carom_peers
// (tests/peers) measures those of 2.4 and Cp again.
struct StressPeer {
  std::string_view engine;
  double value = std::numeric_limits<double>::quiet_NaN();  // the figure's unit; infinite: it fell
  std::string_view note = {};                               // how the peer's set-up differs
};
struct StressPeers {
  std::string_view id;              // of the case
  std::string_view figure;          // its name there
  std::array<StressPeer, 4> peers;  // the last ones without an engine: none
};
[[nodiscard]] std::span<const StressPeers> stress_peers();

// "v3 3.8*, 2.4 falls", those of one figure; a star after what is better than `value`, smaller in size. Empty
// if there are none.
[[nodiscard]] std::string peers_text(std::string_view id, std::string_view figure, double value);

}  // namespace carom
