#pragma once

#include <string>

#include "physics/scene/fields.h"
#include "physics/scene/id.h"

namespace carom {

// How a surface behaves in contact. Two materials combine to the smaller restitution of the two and the
// geometric mean of each friction coefficient and of rolling resistance (see `mixed`).
struct Material {
  std::string name = "default";
  double restitution = 1.0;             // dimensionless, 0..1: normal rebound speed over closing speed
  double tangential_restitution = 0.0;  // dimensionless, -1..1: 0 stops the slip, 1 reverses it (superball)
  double static_friction = 0.0;         // dimensionless, >= kinetic_friction
  double kinetic_friction = 0.0;        // dimensionless, >= 0
  // Dimensionless, >= 0. A moment of up to this times R N resists the rolling of a disc of radius R under the
  // normal force N. Resting contacts only.
  double rolling_resistance = 0.0;
  // The two bodies stay joined from their first impact on; no other property of the surface matters then. Two
  // materials stick if one of them does.
  bool sticks = false;
  Id<Material> id{};

  bool operator==(const Material&) const = default;
};

// The default rule, for two materials that the scene does not list as a pair.
[[nodiscard]] Material mixed(const Material& a, const Material& b);
// The same without a name.
[[nodiscard]] Material mixed_surface(const Material& a, const Material& b);

// How a surface behaves: what materials and pairs of materials share.
template <class V>
void surface_fields(V& v, Is<Material> auto& m) {
  v.field({"restitution", "rebound speed over closing speed"}, m.restitution, kRestitutionRange);
  v.field({"tangential_restitution", "reversed share of the slip"}, m.tangential_restitution,
          kTangentialRestitution);
  v.put("static_friction", m.static_friction);
  v.field({"kinetic_friction", "coefficient"}, m.kinetic_friction, kFrictionCoefficient);
  v.follows(m.static_friction, m.kinetic_friction);
  v.field({"static_friction", "coefficient, kinetic_friction or more"}, m.static_friction,
          kFrictionCoefficient);
  v.field({"rolling_resistance", "moment over radius and normal force"}, m.rolling_resistance,
          kFrictionCoefficient);
  v.field({"sticks", "bodies stay joined from their first impact on"}, m.sticks);
  v.keep(
      {"restitution", "tangential_restitution", "static_friction", "kinetic_friction", "rolling_resistance"});
}

template <class V>
void fields(V& v, Is<Material> auto& m) {
  v.required({"name", "a name of its own"}, m.name, kNameLength);
  surface_fields(v, m);
}

// Two materials with a surface law of their own, in place of `mixed`.
struct MaterialPair {
  std::string a;
  std::string b;     // may be the same
  Material surface;  // its name is not used
  Id<MaterialPair> id{};
};

template <class V>
void fields(V& v, Is<MaterialPair> auto& p) {
  v.two_names({"materials", "the names of two materials, [\"a\", \"b\"]"}, p.a, p.b);
  surface_fields(v, p.surface);
}

}  // namespace carom
