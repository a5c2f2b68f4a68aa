#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "physics/scene/body.h"
#include "physics/scene/forces.h"
#include "physics/scene/generator.h"
#include "physics/scene/joint.h"
#include "physics/scene/material.h"
#include "physics/scene/named.h"

// The physics of an experiment as plain values in SI units, as a preset file states them. x points right, y
// up; angles are counter-clockwise, in radians.
namespace carom {

// How an impact ends whose normal misses a centre, so that the normal impulse turns the bodies and changes
// the slip. Without friction, and for discs, both laws agree.
enum class ImpactLawId {
  kEnergetic,  // Routh's path with Stronge's energetic restitution; never gains energy
  kNewton,     // u_n' = -e u_n whatever friction does; may gain energy, which is reported
};

inline constexpr auto kImpactLawNames = std::to_array<Named<ImpactLawId>>({
    {ImpactLawId::kEnergetic, "energetic"},
    {ImpactLawId::kNewton, "newton"},
});

// How impacts of bodies that touch several others are resolved.
enum class SeveralImpactsId {
  kPairwise,     // pair by pair, and at once only those that close at one moment: Newton's cradle
  kSimultaneous  // all touching pairs at once, with one restitution (Moreau)
};
inline constexpr auto kSeveralImpactsNames = std::to_array<Named<SeveralImpactsId>>({
    {SeveralImpactsId::kPairwise, "pairwise"},
    {SeveralImpactsId::kSimultaneous, "simultaneous"},
});

// The physics of an experiment, as people write it.
struct Scene {
  Forces forces;
  std::vector<Material> materials;
  std::vector<MaterialPair> pairs;
  ImpactLawId impact_law = ImpactLawId::kEnergetic;
  SeveralImpactsId several_impacts = SeveralImpactsId::kPairwise;
  std::vector<Body> bodies;
  std::vector<GridGenerator> generators;
  std::vector<Joint> joints;
  std::uint32_t ids_given = 0;  // so far: the largest number
};

// The material called `name`; "default" exists in every scene. Throws std::out_of_range if there is none.
[[nodiscard]] Material material_named(const Scene& scene, const std::string& name);
// The surface law of two materials: that of their pair in the scene, else `mixed`.
[[nodiscard]] Material combined_material(const Scene& scene, const std::string& a, const std::string& b);
// The same for all pairs of these materials, an n×n table row by row.
[[nodiscard]] std::vector<Material> combined_materials(const Scene& scene,
                                                       const std::vector<std::string>& names);

// True if a material or a pair of materials sticks, whether or not a body has it.
[[nodiscard]] bool has_sticking_surface(const Scene& scene);
// Likewise for rolling resistance.
[[nodiscard]] bool has_rolling_resistance(const Scene& scene);
// A force that a scene has once, beside gravity, acts on each body alone.
[[nodiscard]] bool has_force_on_each_body(const Scene& scene);
[[nodiscard]] bool has_dampers(const Scene& scene);
[[nodiscard]] bool has_strings(const Scene& scene);
// A spring pulls beside the centre of a body that nothing turns.
[[nodiscard]] bool has_springs_beside_points(const Scene& scene);

// All bodies: those of the list, then those of the generators in order.
[[nodiscard]] std::vector<Body> all_bodies(const Scene& scene);

// The first of `stem`-1, `stem`-2, ... that is no body's name.
[[nodiscard]] std::string free_body_name(const std::vector<Body>& bodies, const std::string& stem);

}  // namespace carom
