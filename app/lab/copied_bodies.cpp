#include "app/lab/copied_bodies.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <unordered_map>

#include "widgets/scene/grid.h"
#include "widgets/scene/new_body.h"

namespace carom {
namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Joints and springs whose ends are all in the copy, or in the plane.
template <class Link>
std::vector<Link> among(const std::vector<Link>& links, const std::vector<std::string>& names) {
  std::vector<Link> kept;
  std::copy_if(links.begin(), links.end(), std::back_inserter(kept), [&](const Link& link) {
    return has(names, link.body) && (link.to.empty() || has(names, link.to));
  });
  return kept;
}

// "disc-3" is one of the "disc"s.
std::string stem_of(const std::string& name) {
  const std::size_t end = name.find_last_not_of("0123456789");
  return end != std::string::npos && end > 0 && end + 1 < name.size() && name[end] == '-' ? name.substr(0, end)
                                                                                          : name;
}

// A copy of a new body, which has a letter, has one too.
std::string name_of_copy(const std::vector<Body>& bodies, const std::string& name) {
  const bool letter = name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z';
  return letter ? new_body_name(bodies) : free_body_name(bodies, stem_of(name));
}

bool overlaps(const Extent& a, const Extent& b) {
  return (a.lower.array() < b.upper.array()).all() && (b.lower.array() < a.upper.array()).all();
}

}  // namespace

Preset copied_bodies(const Scene& scene, const std::vector<std::string>& names) {
  Preset copy;
  copy.title = "Copied bodies";
  std::vector<std::string> surfaces;
  for (const Body& body : scene.bodies) {
    if (!has(names, body.name)) continue;
    copy.scene.bodies.push_back(body);
    each_material(body, [&](const std::string& name) { surfaces.push_back(name); });
  }
  std::copy_if(scene.materials.begin(), scene.materials.end(), std::back_inserter(copy.scene.materials),
               [&](const Material& material) { return has(surfaces, material.name); });
  copy.scene.joints = among(scene.joints, names);
  copy.scene.forces.springs = among(scene.forces.springs, names);
  std::copy_if(scene.pairs.begin(), scene.pairs.end(), std::back_inserter(copy.scene.pairs),
               [&](const MaterialPair& pair) { return has(surfaces, pair.a) && has(surfaces, pair.b); });
  std::copy_if(scene.forces.applied.begin(), scene.forces.applied.end(),
               std::back_inserter(copy.scene.forces.applied),
               [&](const AppliedForce& force) { return has(names, force.body); });
  return copy;
}

Paste paste_into(const Scene& scene, const Preset& from, const Vec2& shift) {
  Paste paste;
  std::vector<Body> bodies = all_bodies(scene);
  std::unordered_map<std::string, std::string> renamed;
  std::vector<std::string> surfaces;  // that are new
  for (Material material : from.scene.materials) {
    const bool known = std::any_of(scene.materials.begin(), scene.materials.end(),
                                   [&](const Material& m) { return m.name == material.name; });
    if (known || material.name == "default") continue;
    surfaces.push_back(material.name);
    material.id = {};
    paste.edits.emplace_back(Add<Material>{material});
  }
  for (MaterialPair pair : from.scene.pairs) {
    if (!has(surfaces, pair.a) && !has(surfaces, pair.b)) continue;
    pair.id = {};
    paste.edits.emplace_back(Add<MaterialPair>{pair});
  }
  for (Body body : all_bodies(from.scene)) {
    const std::string name =
        has(paste.names, body.name) ||
                std::any_of(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == body.name; })
            ? name_of_copy(bodies, body.name)
            : body.name;
    renamed.emplace(body.name, name);
    body.name = name;
    body.id = {};
    body.position += shift;
    bodies.push_back(body);
    paste.names.push_back(name);
    paste.edits.emplace_back(Add<Body>{body});
  }
  const auto put = [&](auto link) {
    link.id = {};
    link.name.clear();
    link.body = renamed.at(link.body);
    if (link.to.empty()) {
      link.anchor += shift;
    } else {
      link.to = renamed.at(link.to);
    }
    paste.edits.emplace_back(Add<decltype(link)>{link});
  };
  for (const Joint& joint : from.scene.joints) put(joint);
  for (const Spring& spring : from.scene.forces.springs) put(spring);
  for (AppliedForce force : from.scene.forces.applied) {
    force.id = {};
    force.body = renamed.at(force.body);
    paste.edits.emplace_back(Add<AppliedForce>{force});
  }
  return paste;
}

Extent extent_of(const std::vector<Body>& bodies) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  Extent all{Vec2::Constant(kNone), Vec2::Constant(-kNone)};
  for (const Body& body : bodies) {
    const Vec2 half = half_extent(body.shape, body.angle);
    if (!half.allFinite()) continue;
    all.lower = all.lower.cwiseMin(body.position - half);
    all.upper = all.upper.cwiseMax(body.position + half);
  }
  return all;
}

Vec2 shift_beside(const std::vector<Body>& copied, const std::vector<Body>& others, const Extent& seen) {
  const Extent own = extent_of(copied);
  const double longest = (own.upper - own.lower).maxCoeff();
  if (!(longest > 0.0)) return Vec2::Zero();
  const Vec2 room = 1.1 * (own.upper - own.lower).cwiseMax(0.1 * longest);  // a level wall has no height
  const double x = step_not_below(room.x());
  const double y = step_not_below(room.y());
  const Vec2 steps[] = {{x, 0.0}, {0.0, y}, {-x, 0.0}, {0.0, -y}};
  std::optional<Vec2> in_sight;
  for (const Vec2& step : steps) {
    const Extent there{own.lower + step, own.upper + step};
    const bool is_seen =
        (there.lower.array() >= seen.lower.array()).all() && (there.upper.array() <= seen.upper.array()).all();
    if (!is_seen) continue;
    const bool is_free = std::none_of(others.begin(), others.end(),
                                      [&](const Body& body) { return overlaps(there, extent_of({body})); });
    if (is_free) return step;
    if (!in_sight) in_sight = step;
  }
  return in_sight.value_or(steps[0]);
}

}  // namespace carom
