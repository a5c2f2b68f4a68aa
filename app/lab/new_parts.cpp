#include "app/lab/new_parts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include "physics/scene/edit_rules.h"
#include "widgets/edit/inspected.h"

namespace carom {
namespace {

// The id of the surface that the start has by this name already: it was added at a later moment than the one
// that is edited now.
template <class T>
Id<T> id_of_known(const Scene&, const T&) {
  return {};
}
Id<Material> id_of_known(const Scene& start, const Material& part) {
  const auto same = [&](const Material& known) { return known.name == part.name; };
  const auto known = std::find_if(start.materials.begin(), start.materials.end(), same);
  return known == start.materials.end() ? Id<Material>{} : known->id;
}
Id<MaterialPair> id_of_known(const Scene& start, const MaterialPair& part) {
  const auto same = [&](const MaterialPair& known) {
    return std::minmax(known.a, known.b) == std::minmax(part.a, part.b);
  };
  const auto known = std::find_if(start.pairs.begin(), start.pairs.end(), same);
  return known == start.pairs.end() ? Id<MaterialPair>{} : known->id;
}

// Whether a body gets this surface, which the start gives it no earlier.
bool is_put_on(const Scene& start, const SceneEdits& edits, const std::string& surface) {
  return std::any_of(edits.begin(), edits.end(), [&](const SceneEdit& edit) {
    const auto* replace = std::get_if<Replace<Body>>(&edit);
    if (replace == nullptr || replace->part.material != surface) return false;
    const Body* was = part_of(start.bodies, replace->part.id);
    return was == nullptr || was->material != surface;
  });
}

// "wood 2": "wood".
std::string stem_of(const std::string& name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  const bool numbered = last != std::string::npos && last + 1 < name.size() && name[last] == ' ';
  return numbered ? name.substr(0, last) : name;
}

void name_own_surfaces(const Scene& start, SceneEdits& edits) {
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const auto* add = std::get_if<Add<Material>>(&edits[i]);
    if (add == nullptr || add->part.id.number != 0 || id_of_known(start, add->part).number == 0) continue;
    const std::string from = add->part.name;
    if (!is_put_on(start, edits, from)) continue;
    const std::string to = free_surface_name(start, stem_of(from));
    const auto rename = [&](std::string& name) {
      if (name == from) name = to;
    };
    for (SceneEdit& edit : edits) {
      if (auto* surface = std::get_if<Add<Material>>(&edit)) rename(surface->part.name);
      if (auto* body = std::get_if<Replace<Body>>(&edit)) each_material(body->part, rename);
      if (auto* pair = std::get_if<Add<MaterialPair>>(&edit)) {
        rename(pair->part.a);
        rename(pair->part.b);
      }
    }
  }
}

}  // namespace

void give_ids(Preset& preset) {
  give_ids(preset.scene);
  for (RunEdit& late : preset.edits) {
    auto& edits = std::get<SceneEdits>(late.what);
    number_new_parts(preset.scene, edits);
    preset.scene.ids_given = std::max(preset.scene.ids_given, added_body(late).id.number);
  }
}

void number_new_parts(const Scene& start, SceneEdits& edits) {
  name_own_surfaces(start, edits);
  std::uint32_t given = start.ids_given;
  for (SceneEdit& edit : edits) {
    std::visit(
        [&](auto& e) {
          if constexpr (requires { e.at; }) {
            if (e.part.id.number == 0) e.part.id = id_of_known(start, e.part);
            if (e.part.id.number == 0) e.part.id.number = ++given;
          }
        },
        edit);
  }
}

SceneEdits with_known_parts(const Scene& start, SceneEdits edits) {
  for (SceneEdit& edit : edits) {
    if (const auto* material = std::get_if<Add<Material>>(&edit)) {
      if (part_of(start.materials, material->part.id) != nullptr)
        edit = SceneEdit(Replace<Material>{Material(material->part)});
    } else if (const auto* pair = std::get_if<Add<MaterialPair>>(&edit)) {
      if (part_of(start.pairs, pair->part.id) != nullptr)
        edit = SceneEdit(Replace<MaterialPair>{MaterialPair(pair->part)});
    }
  }
  return edits;
}

}  // namespace carom
