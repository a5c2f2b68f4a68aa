#include "physics/preset/sections_json.h"

namespace carom {
namespace {

void read_once(std::optional<int>& place, int index, const std::string& at, const std::string& what) {
  if (place) refuse_by(Rule::kKeysTogether, at, "a second " + what, "one");
  place = index;
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
  const auto one = [&](std::optional<int>& place, const char* what) {
    if (r.reads()) read_once(place, index, at, what);
  };
  r.cases({"type", "the kind of force"}, {"linear_drag", "quadratic_drag", "spring", "attraction", "force"}, 0,
          [&](std::size_t kind, FieldReader& k) {
            if (kind == 0) {
              one(places.linear_drag, "linear drag");
              k.required({"coefficient", "b in F = -b v"}, forces.linear_drag, kLinearDrag);
            } else if (kind == 1) {
              one(places.quadratic_drag, "quadratic drag");
              k.required({"coefficient", "c in F = -c |v| v"}, forces.quadratic_drag, kQuadraticDrag);
            } else if (kind == 2) {
              fields(k, forces.springs.emplace_back());
              places.springs.push_back(index);
            } else if (kind == 3) {
              one(places.attraction, "attraction");
              fields(k, forces.attraction.emplace());
            } else {
              fields(k, forces.applied.emplace_back());
              places.applied.push_back(index);
            }
          });
}

Json forces_json(const Forces& forces, bool all) {
  Json j = Json::array();
  if (forces.linear_drag != 0.0) j.push_back({{"type", "linear_drag"}, {"coefficient", forces.linear_drag}});
  if (forces.quadratic_drag != 0.0)
    j.push_back({{"type", "quadratic_drag"}, {"coefficient", forces.quadratic_drag}});
  for (const Spring& s : forces.springs) j.push_back(typed("spring", s, all));
  if (forces.attraction) j.push_back(typed("attraction", *forces.attraction, all));
  for (const AppliedForce& f : forces.applied) j.push_back(typed("force", f, all));
  return j;
}

Json joint_json(const Joint& joint, bool all) {
  return typed(name_of(kJointNames, joint.kind).data(), joint, all);
}

}  // namespace carom
