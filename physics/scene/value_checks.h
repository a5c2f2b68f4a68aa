#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "physics/scene/scene.h"
#include "physics/scene/stop.h"
#include "physics/scene/validate.h"

// Checks of single values of a scene or a preset. Each throws a SceneError that names `place`.
namespace carom {

void check_range(const std::string& place, double value, const Range& range);
// `value` must be at least `least`, another number of the scene, which is called `what`.
void check_order(const std::string& place, double value, double least, const std::string& what);
void check_name(const std::string& place, const std::string& name, std::size_t longest = kLongestName);
// Adds the name to `names`; it must be new there.
void check_own_name(std::unordered_set<std::string>& names, const std::string& place, const std::string& name);
void check_count(const std::string& place, std::size_t count, std::size_t most, const char* what);

// Bodies by name.
using NamedBodies = std::unordered_map<std::string, const Body*>;
[[nodiscard]] const Body& named_body(const NamedBodies& bodies, const std::string& place,
                                     const std::string& name);
// One that forces can move.
const Body& movable_body(const NamedBodies& bodies, const std::string& place, const std::string& name);

// Its numbers, and that the bodies that it names are there.
void check_stop(const std::string& place, const Stop& stop, const NamedBodies& bodies);

// Checks the joints of a scene whose bodies, `bodies`, are good: references, numbers, and that at the start the
// ends are where the joints hold them and don't leave there. Throws SceneError with the JSON pointer of the
// first fault.
void check_joints(const Scene& scene, const std::vector<Body>& bodies, const RunBegin& begin);

}  // namespace carom
