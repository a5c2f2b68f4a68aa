#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "physics/scene/id.h"
#include "physics/scene/scene.h"

// Edits of a scene as values: what a document, its undo stack and a run's record hold.
namespace carom {

// Puts a part into its list, before the one at `at`, or at the end. One without an id is given the next.
template <class Part>
struct Add {
  static constexpr std::size_t kAtEnd = std::numeric_limits<std::size_t>::max();

  Part part;
  std::size_t at = kAtEnd;
};
// Puts this in place of the part with the same id.
template <class Part>
struct Replace {
  Part part;
};
template <class Part>
struct Remove {
  Id<Part> id;
};

// Puts these in place of the forces that the scene has once.
using SetForces = CommonForces;

struct SetLaws {
  ImpactLawId impact_law = ImpactLawId::kEnergetic;
  SeveralImpactsId several_impacts = SeveralImpactsId::kPairwise;
};

// Puts the hand of a run to this place, or takes it off.
struct SetHand {
  std::optional<Hand> hand;
};

using SceneEdit =
    std::variant<SetForces, SetLaws, SetHand, Add<Body>, Replace<Body>, Remove<Body>, Add<Joint>,
                 Replace<Joint>, Remove<Joint>, Add<Spring>, Replace<Spring>, Remove<Spring>, Add<AppliedForce>,
                 Replace<AppliedForce>, Remove<AppliedForce>, Add<Material>, Replace<Material>,
                 Remove<Material>, Add<MaterialPair>, Replace<MaterialPair>, Remove<MaterialPair>,
                 Add<GridGenerator>, Replace<GridGenerator>, Remove<GridGenerator>>;
// Edits that are made, and taken back, together.
using SceneEdits = std::vector<SceneEdit>;

// Gives every part that has none an id.
void give_ids(Scene& scene);

// Changes the scene and returns the edit that changes it back. Whether the scene is valid then is for
// validate() to say. Throws std::out_of_range, and changes nothing, if there is no part of that id.
SceneEdit apply_edit(Scene& scene, const SceneEdit& edit);
// All of them in their order, or none.
SceneEdits apply_edits(Scene& scene, const SceneEdits& edits);

}  // namespace carom
