#pragma once

#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "physics/scene/edit.h"

namespace carom::test {

// Draws edits of a scene. The same seed and the same scene, whatever the ids of its parts, give the same edit.
class RandomEdits {
 public:
  RandomEdits(const Scene& scene, unsigned seed) : scene_(scene), random_(seed) {}

  // An edit of any kind that the scene has parts for. It may be one that validate() refuses.
  [[nodiscard]] SceneEdits any();
  // One that needs no part of the scene.
  [[nodiscard]] SceneEdits of_no_part();
  [[nodiscard]] std::string_view kind() const { return kind_; }  // of the last one

 private:
  struct Kind {
    const char* name;
    SceneEdits (RandomEdits::*draw)();
  };
  static const std::vector<Kind>& kinds();
  static const std::vector<Kind>& kinds_of_no_part();
  [[nodiscard]] SceneEdits drawn(const std::vector<Kind>& kinds);

  [[nodiscard]] double between(double low, double high);
  [[nodiscard]] bool once_in(unsigned n) { return random_() % n == 0; }
  [[nodiscard]] Vec2 place();
  template <class Part>
  [[nodiscard]] const Part* one_of(const std::vector<Part>& list) {
    return list.empty() ? nullptr : &list[random_() % list.size()];
  }
  // Replaces one part of the list.
  template <class Part, class Change>
  [[nodiscard]] SceneEdits changed(const std::vector<Part>& list, const Change& change);
  template <class Part>
  [[nodiscard]] SceneEdits removed(const std::vector<Part>& list);
  [[nodiscard]] std::string name(const char* stem);  // that no part has
  [[nodiscard]] std::string surface();
  [[nodiscard]] Shape shape();
  [[nodiscard]] Joint joint(JointKind kind);
  void change(Material& material);

  SceneEdits move();
  SceneEdits turn();
  SceneEdits velocity();
  SceneEdits resize();
  SceneEdits mass();
  SceneEdits density();
  SceneEdits hold();
  SceneEdits rename();
  SceneEdits surface_of_body();
  SceneEdits several();
  SceneEdits add_body();
  SceneEdits remove_body();
  SceneEdits add_rod();
  SceneEdits add_string();
  SceneEdits add_pin();
  SceneEdits add_weld();
  SceneEdits joint_value();
  SceneEdits remove_joint();
  SceneEdits add_spring();
  SceneEdits spring_value();
  SceneEdits remove_spring();
  SceneEdits add_force();
  SceneEdits force_value();
  SceneEdits remove_force();
  SceneEdits add_material();
  SceneEdits material_value();
  SceneEdits rename_material();
  SceneEdits remove_material();
  SceneEdits add_pair();
  SceneEdits pair_value();
  SceneEdits remove_pair();
  SceneEdits add_generator();
  SceneEdits generator_value();
  SceneEdits remove_generator();
  SceneEdits forces();
  SceneEdits laws();

  const Scene& scene_;
  std::mt19937 random_;
  std::string_view kind_;
};

}  // namespace carom::test
