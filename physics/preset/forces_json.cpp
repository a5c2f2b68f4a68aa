#include <algorithm>
#include <array>

#include "physics/preset/sections_json.h"

namespace carom {
namespace {

// The types of forces: those that a scene has once, then these.
constexpr auto kListed = std::to_array<const char*>({"spring", "force"});

[[nodiscard]] std::vector<std::string> types_of_force() {
  std::vector<std::string> types;
  const CommonForces forces;
  each_common_force(forces,
                    [&types](const CommonForce& force, const auto&...) { types.emplace_back(force.type); });
  types.insert(types.end(), kListed.begin(), kListed.end());
  return types;
}

// Reads the one whose type is this.
void read_common_force(FieldReader& r, const std::string& type, CommonForces& forces) {
  each_common_force(forces, [&](const CommonForce& force, auto& value, const auto&... range) {
    if (type != force.type) return;
    if constexpr (sizeof...(range) > 0) {
      r.required({"coefficient", force.meaning}, value, range...);
    } else {
      fields(r, value.emplace());
    }
  });
}

// An object of the array of forces.
template <class T>
Json typed(const char* type, const T& force, bool all) {
  Json j = {{"type", type}};
  j.update(written(force, all));
  return j;
}

}  // namespace

void read_force(FieldReader& r, const std::string& at, int index, Forces& forces, ForcePlaces& places) {
  const std::vector<std::string> types = types_of_force();
  const std::size_t common = types.size() - kListed.size();
  r.cases({"type", "the kind of force"}, types, 0, [&](std::size_t kind, FieldReader& k) {
    if (kind < common) {
      if (r.reads() && !places.common.emplace(types[kind], index).second) {
        std::string words = types[kind];
        std::replace(words.begin(), words.end(), '_', ' ');
        refuse_by(Rule::kKeysTogether, at, "a second " + words, "one");
      }
      read_common_force(k, types[kind], forces);
    } else if (types[kind] == "spring") {
      fields(k, forces.springs.emplace_back());
      places.springs.push_back(index);
    } else {
      fields(k, forces.applied.emplace_back());
      places.applied.push_back(index);
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
  for (const Spring& s : forces.springs) j.push_back(typed("spring", s, all));
  for (const AppliedForce& f : forces.applied) j.push_back(typed("force", f, all));
  return j;
}

Json joint_json(const Joint& joint, bool all) {
  return typed(name_of(kJointNames, joint.kind).data(), joint, all);
}

}  // namespace carom
