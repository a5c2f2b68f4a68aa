#include "physics/scene/scene_error.h"

#include <fmt/format.h>

#include "physics/scene/plain_text.h"

namespace carom {
namespace {

std::string refusal(const std::string& place, const std::string& found, const std::string& allowed) {
  return fmt::format("{}: {} is not allowed; allowed: {}", place.empty() ? "/" : shortened(place),
                     shortened(found), shortened(allowed, 300));
}

}  // namespace

void refuse_value(const std::string& place, const std::string& found, const std::string& allowed) {
  throw SceneError(refusal(place, found, allowed));
}

void refuse_by(Rule rule, const std::string& place, const std::string& found, const std::string& allowed) {
  throw RuleError(rule, refusal(place, found, allowed));
}

}  // namespace carom
