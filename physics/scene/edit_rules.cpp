#include "physics/scene/edit_rules.h"

#include <type_traits>
#include <unordered_map>

namespace carom {
namespace {

// A body that becomes fixed or driven loses its velocity with that.
bool moves_otherwise(const Body& was, const Body& is) {
  if (was.position != is.position || was.angle != is.angle) return true;
  const bool is_stopped = has_infinite_mass(is) && is.velocity.isZero(0.0) && is.spin == 0.0;
  return !is_stopped && (was.velocity != is.velocity || was.spin != is.spin);
}

// Of joints and springs: where their ends are.
template <class Link>
bool ends_elsewhere(const Link& was, const Link& is) {
  return was.body != is.body || was.point != is.point || was.to != is.to || was.anchor != is.anchor;
}

// Adds an edit for each part of the list that `change` changes. Parts without an id, which a run has made, are
// the run's own business.
template <class Part, class Change>
void follow(const std::vector<Part>& list, const Change& change, SceneEdits& out) {
  for (const Part& part : list) {
    Part other = part;
    if (part.id.number != 0 && change(other)) out.push_back(Replace<Part>{other});
  }
}

bool rename(std::string& name, const Renamed& names) {
  if (name != names.from) return false;
  name = names.to;
  return true;
}

void follow_body(const Scene& scene, const Renamed& names, SceneEdits& out) {
  const auto ends = [&](auto& link) {
    const bool own = rename(link.body, names);
    return rename(link.to, names) || own;
  };
  follow(scene.joints, ends, out);
  follow(scene.forces.springs, ends, out);
  follow(
      scene.forces.applied, [&](AppliedForce& force) { return rename(force.body, names); }, out);
  std::optional<Hand> hand = scene.forces.hand;
  if (hand && rename(hand->body, names)) out.push_back(SetHand{hand});
}

void follow_material(const Scene& scene, const Renamed& names, SceneEdits& out) {
  const auto surfaces = [&](Body& body) {
    bool any = false;
    each_material(body, [&](std::string& name) { any = rename(name, names) || any; });
    return any;
  };
  follow(scene.bodies, surfaces, out);
  follow(
      scene.generators, [&](GridGenerator& generator) { return rename(generator.material, names); }, out);
  const auto both = [&](MaterialPair& pair) {
    const bool first = rename(pair.a, names);
    return rename(pair.b, names) || first;
  };
  follow(scene.pairs, both, out);
}

// What goes with a body.
void remove_with(const Scene& scene, const std::string& body, SceneEdits& out) {
  const auto remove = [&]<class Part>(const std::vector<Part>& list, const auto& names_it) {
    for (const Part& part : list) {
      if (part.id.number != 0 && names_it(part)) out.push_back(Remove<Part>{part.id});
    }
  };
  const auto ends = [&](const auto& link) { return link.body == body || link.to == body; };
  remove(scene.joints, ends);
  remove(scene.forces.springs, ends);
  remove(scene.forces.applied, [&](const AppliedForce& force) { return force.body == body; });
}

}  // namespace

bool is_about_motion(const Scene& now, const SceneEdit& edit) {
  return std::visit(
      [&]<class Edit>(const Edit& e) {
        if constexpr (std::is_same_v<Edit, Add<Body>> || std::is_same_v<Edit, Add<Joint>> ||
                      std::is_same_v<Edit, Add<Spring>>) {
          return true;
        } else if constexpr (std::is_same_v<Edit, Replace<Body>>) {
          const Body* was = part_of(now.bodies, e.part.id);
          return was != nullptr && moves_otherwise(*was, e.part);
        } else if constexpr (std::is_same_v<Edit, Replace<Joint>>) {
          const Joint* was = part_of(now.joints, e.part.id);
          return was != nullptr && (ends_elsewhere(*was, e.part) || was->point != e.part.point);
        } else if constexpr (std::is_same_v<Edit, Replace<Spring>>) {
          const Spring* was = part_of(now.forces.springs, e.part.id);
          return was != nullptr && ends_elsewhere(*was, e.part);
        } else {
          return false;
        }
      },
      edit);
}

SceneEdits with_followers(const Scene& scene, const SceneEdits& edits) {
  SceneEdits all;
  Scene changed = scene;
  for (const SceneEdit& edit : edits) {
    SceneEdits followers;
    if (const auto* body = std::get_if<Replace<Body>>(&edit)) {
      const Body* was = part_of(changed.bodies, body->part.id);
      if (was != nullptr && was->name != body->part.name)
        follow_body(changed, {was->name, body->part.name}, followers);
    } else if (const auto* material = std::get_if<Replace<Material>>(&edit)) {
      const Material* was = part_of(changed.materials, material->part.id);
      if (was != nullptr && was->name != material->part.name)
        follow_material(changed, {was->name, material->part.name}, followers);
    } else if (const auto* gone = std::get_if<Remove<Body>>(&edit)) {
      if (const Body* was = part_of(changed.bodies, gone->id)) remove_with(changed, was->name, followers);
    }
    followers.push_back(edit);
    apply_edits(changed, followers);
    all.insert(all.end(), followers.begin(), followers.end());
  }
  return all;
}

std::vector<Renamed> renamed_bodies(const Scene& before, const Scene& after) {
  std::unordered_map<std::uint32_t, const std::string*> names;
  for (const Body& body : after.bodies) names.emplace(body.id.number, &body.name);
  std::vector<Renamed> renamed;
  for (const Body& body : before.bodies) {
    const auto now = names.find(body.id.number);
    if (now == names.end()) {
      renamed.push_back({body.name, {}});
    } else if (*now->second != body.name) {
      renamed.push_back({body.name, *now->second});
    }
  }
  return renamed;
}

}  // namespace carom
