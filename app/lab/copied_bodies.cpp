#include "app/lab/copied_bodies.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <unordered_map>

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
  return copy;
}

Paste paste_into(const Scene& scene, const Preset& from, const Vec2& shift) {
  Paste paste;
  std::vector<Body> bodies = all_bodies(scene);
  std::unordered_map<std::string, std::string> renamed;
  for (const Material& material : from.scene.materials) {
    const bool known = std::any_of(scene.materials.begin(), scene.materials.end(),
                                   [&](const Material& m) { return m.name == material.name; });
    if (known || material.name == "default") continue;
    Material copy = material;
    copy.id = {};
    paste.edits.emplace_back(Add<Material>{copy});
  }
  for (Body body : all_bodies(from.scene)) {
    const std::string name =
        has(paste.names, body.name) ||
                std::any_of(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == body.name; })
            ? free_body_name(bodies, stem_of(body.name))
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

}  // namespace carom
