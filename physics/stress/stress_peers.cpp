#include "physics/stress/stress_peers.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace carom {
namespace {

// Figures that differ by less are equal but for rounding, in any unit here.
constexpr double kSame = 1e-12;
constexpr double kFalls = std::numeric_limits<double>::infinity();
constexpr double kStands = std::numeric_limits<double>::quiet_NaN();

constexpr auto kPeers = std::to_array<StressPeers>({
    {"stack-20", "sag of the top", {{{"v3", kStands, "stands"}, {"2.4", -180.0}, {"Cp", kFalls}}}},
    {"stack-20", "lean", {{{"2.4", 58.5, "at the top"}, {"Cp", kFalls}}}},
    {"stack-40", "sag of the top", {{{"v3", 540.0}, {"v3 tuned", 2.1}, {"2.4", kFalls}, {"Cp", kFalls}}}},
    {"stack-heavy-top",
     "sag of the top",
     {{{"v3", kFalls}, {"v3 tuned", 23.0}, {"2.4", kFalls}, {"Cp", kFalls}}}},
    {"mass-ratio", "sag of the top", {{{"2.4", kFalls}, {"Cp", kFalls}}}},
    {"pyramid-20", "sag of the top", {{{"v3", 29.0}, {"2.4", -257.0}, {"Cp", 40.0}}}},
    {"pyramid-20", "sideways drift of the top", {{{"v3", 2.3}, {"2.4", 5.6}, {"Cp", -11.0}}}},
    {"pyramid-20", "largest overlap", {{{"v3", 3.8}, {"2.4", kStands, "gaps of 14"}, {"Cp", 7.4}}}},
    // ½ of the squared rms speed; rolling not counted.
    {"pile",
     "kinetic energy per mass",
     {{{"v3", 3.2e-11, "after 10 s"}, {"2.4", 1.1e-4, "after 10 s"}, {"Cp", 8e-8, "after 10 s"}}}},
    {"pile",
     "largest overlap",
     {{{"v3", 39.0, "after 10 s"},
       {"v3 tuned", 4.1, "after 10 s"},
       {"2.4", 26.0, "after 10 s"},
       {"Cp", 100.0, "after 10 s"}}}},
    {"pile",
     "mean overlap",
     {{{"v3", 7.0, "after 10 s"},
       {"v3 tuned", 0.31, "after 10 s"},
       {"2.4", 7.0, "after 10 s"},
       {"Cp", 32.0, "after 10 s"}}}},
    {"incline-below",
     "creep in 60 s",
     {{{"v3", 3.9e-4, "10 s at 0.99"}, {"2.4", 1.1e-4, "10 s"}, {"Cp", 1.7e-3, "10 s"}}}},
    // Of the distance in 10 s: 2.189 m, and 1.096 m at 1.005.
    {"incline-above", "error of the acceleration", {{{"v3", 2.3, "at 1.01"}, {"2.4", 1.7}, {"Cp", 3.2}}}},
    {"slide-to-roll", "error of the final speed", {{{"v3", -2e-3}, {"2.4", -1.5e-2}, {"Cp", 1.8e-15}}}},
    {"spinning-disc", "error of the final speed", {{{"2.4", 7.2e-3}, {"Cp", 1.3e-15}}}},
    {"bullet",
     "share of the bounces missed",
     {{{"v3", 0.98},
       {"2.4", kStands, "clamps to 2 m a step"},
       {"Cp", kStands, "leaves a wall of 0.1 m at 10 radii a step"}}}},
    {"cradle-5", "error of the last ball's speed", {{{"2.4", -0.557}, {"Cp", 0.0}}}},
    {"cradle-5", "relative change of the energy", {{{"v3", -0.44}, {"2.4", -4.9e-2}, {"Cp", 0.0}}}},
    {"overlapping-start", "largest speed gained", {{{"2.4", 0.0}, {"Cp", 0.0}}}},
    {"galperin",
     "impacts off 314",
     {{{"v3", -300.0, "1 kHz"}, {"2.4", -266.0, "1 kHz"}, {"Cp", 0.0, "1 kHz"}}}},
    {"gas",
     "relative change of the energy",
     {{{"v3", -6.3e-2, "10 s"}, {"2.4", -8.8e-7, "10 s"}, {"Cp", -5.5e-8, "10 s"}}}},
});

}  // namespace

std::span<const StressPeers> stress_peers() { return kPeers; }

std::string peers_text(std::string_view id, std::string_view figure, double value) {
  std::string text;
  const auto of = std::find_if(kPeers.begin(), kPeers.end(),
                               [&](const StressPeers& p) { return p.id == id && p.figure == figure; });
  if (of == kPeers.end()) return text;
  for (const StressPeer& p : of->peers) {
    if (p.engine.empty()) break;
    if (!text.empty()) text += ", ";
    text += p.engine;
    if (std::isinf(p.value)) text += " falls";
    if (std::isfinite(p.value)) text += fmt::format(" {:.3g}", p.value);
    if (std::isfinite(p.value) && !(std::abs(value) - std::abs(p.value) <= kSame)) text += '*';
    if (!p.note.empty())
      text += std::isnan(p.value) ? fmt::format(" {}", p.note) : fmt::format(" ({})", p.note);
  }
  return text;
}

}  // namespace carom
