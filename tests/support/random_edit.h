#pragma once

#include <string>
#include <vector>

#include "physics/scene/edit.h"
#include "tests/support/draws.h"

namespace carom::test {

// An edit of one part of a scene, or of what it has once. The scene need not be valid afterwards.
inline SceneEdit random_edit(const Scene& scene, Draws& draws) {
  const auto of = [&]<class Part>(const std::vector<Part>& list, const auto& change) -> SceneEdit {
    const int what = list.empty() ? 0 : draws.up_to(2);
    Part part =
        list.empty() ? Part{} : list[static_cast<std::size_t>(draws.up_to(static_cast<int>(list.size()) - 1))];
    if (what == 2) return Remove<Part>{part.id};
    change(part);
    if (what == 1) return Replace<Part>{part};
    part.id = {};
    return Add<Part>{part, draws.chance(0.5)
                               ? Add<Part>::kAtEnd
                               : static_cast<std::size_t>(draws.up_to(static_cast<int>(list.size())))};
  };
  const auto rename = [&](auto& part) { part.name += std::to_string(draws.up_to(9)); };
  switch (draws.up_to(8)) {
    case 0:
      return SetForces{draws.in_square(10.0), draws.between(0.0, 1.0), 0.0, std::nullopt};
    case 1:
      return SetLaws{draws.chance(0.5) ? ImpactLawId::kNewton : ImpactLawId::kEnergetic,
                     SeveralImpactsId::kPairwise};
    case 2:
      return of(scene.joints, [&](Joint& joint) {
        rename(joint);
        joint.anchor = draws.in_square(1.0);
      });
    case 3:
      return of(scene.forces.springs, [&](Spring& spring) {
        rename(spring);
        spring.stiffness = draws.between(1.0, 9.0);
      });
    case 4:
      return of(scene.forces.applied, [&](AppliedForce& force) { force.force = draws.in_square(3.0); });
    case 5:
      return of(scene.materials, [&](Material& material) {
        rename(material);
        material.restitution = draws.between(0.0, 1.0);
      });
    case 6:
      return of(scene.pairs,
                [&](MaterialPair& pair) { pair.surface.kinetic_friction = draws.between(0.0, 1.0); });
    case 7:
      return of(scene.generators, [&](GridGenerator& grid) {
        rename(grid);
        grid.seed = static_cast<std::uint64_t>(draws.up_to(99));
      });
    default:
      return of(scene.bodies, [&](Body& body) {
        rename(body);
        body.position = draws.in_square(2.0);
        body.velocity = draws.in_square(2.0);
        body.mass = draws.between(0.1, 5.0);
        body.density.reset();
      });
  }
}

}  // namespace carom::test
