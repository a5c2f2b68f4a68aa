#include "physics/run/lost_run.h"

#include <fmt/format.h>

#include "physics/scene/validate.h"

namespace carom {

std::string LostRun::text(const std::vector<Body>& bodies, double stands_at) const {
  const std::string name = shortened(bodies[static_cast<std::size_t>(body)].name);
  const auto why = [&]() -> std::string {
    switch (reason) {
      case LossReason::kTooLarge:
        return fmt::format("the motion of \"{}\" grew beyond {:g} (m, m/s, rad or rad/s): take shorter steps",
                           name, kLostBeyond);
      case LossReason::kTooManySteps:
        return fmt::format(
            "the adaptive integrator needs too many steps at \"{}\" to keep its tolerance: a larger one may "
            "help",
            name);
    }
    return {};
  };
  return fmt::format("lost at t = {:.6g} s: {}; shown is the last good step's end, t = {:.6g} s", time, why(),
                     stands_at);
}

}  // namespace carom
