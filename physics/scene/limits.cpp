#include "physics/scene/limits.h"

#include <fmt/format.h>

namespace carom {

std::string Range::text() const {
  return fmt::format("{}a number from {} to {}{}{}", or_zero ? "0, or " : "", low, high,
                     unit.empty() ? "" : " ", unit);
}

}  // namespace carom
