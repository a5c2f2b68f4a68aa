#include <algorithm>

#include "physics/preset/sections_json.h"

namespace carom {
namespace {

// An object of the array of forces.
template <class T>
Json typed(std::string_view type, const T& force, bool all) {
  Json j = {{"type", type}};
  j.update(written(force, all));
  return j;
}

}  // namespace

std::vector<std::string> types_of_force() {
  std::vector<std::string> types;
  const CommonForces forces;
  each_common_force(forces,
                    [&types](const CommonForce& force, const auto&...) { types.emplace_back(force.type); });
  types.emplace_back(kSpringType);
  types.emplace_back(kAppliedForceType);
  return types;
}

void read_force(FieldReader& r, const std::string& at, int index, Forces& forces, ForcePlaces& places) {
  force_fields(r, forces, [&](const std::string& type) {
    if (type == kSpringType) {
      places.springs.push_back(index);
    } else if (type == kAppliedForceType) {
      places.applied.push_back(index);
    } else if (r.reads() && !places.common.emplace(type, index).second) {
      std::string words = type;
      std::replace(words.begin(), words.end(), '_', ' ');
      refuse_by(Rule::kKeysTogether, at, "a second " + words, "one");
    }
  });
}

Json forces_json(const Forces& forces, bool all) {
  Json j = Json::array();
  each_common_force(forces, [&](const CommonForce& force, const auto& value, const auto&... range) {
    if (!acts(value)) return;
    if constexpr (sizeof...(range) > 0) {
      j.push_back({{"type", force.type}, {"coefficient", value}});
    } else {
      j.push_back(typed(force.type, *value, all));
    }
  });
  for (const Spring& s : forces.springs) j.push_back(typed(kSpringType, s, all));
  for (const AppliedForce& f : forces.applied) j.push_back(typed(kAppliedForceType, f, all));
  return j;
}

Json joint_json(const Joint& joint, bool all) { return typed(name_of(kJointNames, joint.kind), joint, all); }

}  // namespace carom
