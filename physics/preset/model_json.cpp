#include <fmt/format.h>

#include "physics/dynamics/integrators/integrators.h"
#include "physics/preset/names.h"
#include "physics/preset/sections_json.h"
#include "physics/scene/shape.h"

namespace carom {
namespace {

void read_once(std::optional<int>& place, int index, const std::string& at, const std::string& what) {
  if (place) refuse_by(Rule::kKeysTogether, at, "a second " + what, "one");
  place = index;
}

void read_spring(FieldReader& r, Spring& s) {
  r.read({"name", "its own, if any"}, s.name, kPerhapsName);
  r.require({"body", "the name of the body that it acts on"}, s.body, kName);
  if (r.reads() && r.has("to") == r.has("anchor")) {
    refuse_value(r.at("anchor"), r.has("to") ? "\"anchor\" beside \"to\"" : "a spring without its other end",
                 "either \"anchor\": [x, y], in m, or \"to\": the name of a body");
  }
  if (!r.writes() || !s.to.empty()) r.read({"to", "the body at the other end"}, s.to, kName);
  if (!r.writes() || s.to.empty())
    r.read({"anchor", "the point of the plane at the other end, [x, y]"}, s.anchor, any_number("m"));
  r.keep({"anchor"});
  r.also({{"oneOf", {{{"required", Json::array({"to"})}}, {{"required", Json::array({"anchor"})}}}}});
  r.require({"stiffness", "force over stretch"}, s.stiffness, positive("N/m"));
  r.read({"damping", "force over the stretch's speed"}, s.damping, from_zero("N s/m"));
  r.read({"rest_length", "of the spring that pulls at nothing"}, s.rest_length, from_zero("m"));
  r.read_choice({"acts", "which way it acts"}, kSpringActsNames, s.acts);
}

void read_applied(FieldReader& r, AppliedForce& f) {
  r.require({"body", "the name of the body that it acts on"}, f.body, kName);
  r.read({"force", "at the body's centre, [x, y]"}, f.force, any_number("N"));
  r.read({"torque", "counter-clockwise"}, f.torque, any_number("N m"));
  r.read({"start", "when it sets in"}, f.start, from_zero("s"));
  r.read({"rise", "within which it grows to all of it"}, f.rise, from_zero("s"));
  r.read({"end", "when it ends"}, f.end, from_zero("s"));
}

// One of the array of forces.
Json typed(const char* type, const Json& members) {
  Json j = {{"type", type}};
  j.update(members);
  return j;
}

// How a surface behaves: the keys that materials and pairs of materials share.
void read_surface(FieldReader& r, Material& m) {
  r.read({"restitution", "rebound speed over closing speed"}, m.restitution, kRestitutionRange);
  r.read({"tangential_restitution", "reversed share of the slip"}, m.tangential_restitution,
         kTangentialRestitution);
  r.put("static_friction", m.static_friction);
  r.read({"kinetic_friction", "coefficient"}, m.kinetic_friction, kFrictionCoefficient);
  if (!r.writes()) m.static_friction = m.kinetic_friction;
  r.read({"static_friction", "coefficient, kinetic_friction or more"}, m.static_friction, kFrictionCoefficient);
  r.read({"rolling_resistance", "moment over radius and normal force"}, m.rolling_resistance,
         kFrictionCoefficient);
  r.read({"sticks", "bodies stay joined from their first impact on"}, m.sticks);
  r.keep(
      {"restitution", "tangential_restitution", "static_friction", "kinetic_friction", "rolling_resistance"});
}

// As it stands there, or begun.
template <class Form>
Form& form_of(Shape& shape) {
  return std::holds_alternative<Form>(shape) ? std::get<Form>(shape) : shape.emplace<Form>();
}

void read_shape(FieldReader& r, Shape& shape) {
  r.cases({"type", "the kind of shape"}, {"disc", "box", "polygon", "wall"}, shape.index(),
          [&](std::size_t kind, FieldReader& k) {
            if (kind == 0) {
              auto& disc = form_of<Disc>(shape);
              k.require({"radius", "of the disc; 0 for a point-like body"}, disc.radius, kDiscRadius);
            } else if (kind == 1) {
              auto& box = form_of<Box>(shape);
              k.require({"width", "along its own x axis"}, box.width, positive("m"));
              k.require({"height", "along its own y axis"}, box.height, positive("m"));
            } else if (kind == 2) {
              auto& polygon = form_of<Polygon>(shape);
              Json vertices = Json::array();
              for (const Vec2& v : polygon.vertices) vertices.push_back(pair_json(v));
              k.put("vertices", vertices);
              k.needed({"vertices", "points of a convex polygon in order, [[x, y], ...], in m"},
                       [&](const ValueReader& v) {
                         v.list({2, kMostPolygonPoints}, [&](const ValueReader& p) {
                           polygon.vertices.push_back(p.pair(any_number("m")));
                         });
                       });
              if (!k.writes() || polygon.rounding != 0.0)
                k.read({"rounding", "by which it grows on all sides"}, polygon.rounding, from_zero("m"));
            } else {
              auto& wall = form_of<Wall>(shape);
              k.read({"length", "of a thin wall; without it a half-plane"}, wall.length, positive("m"));
            }
          });
}

void read_drive(FieldReader& r, Drive& d) {
  r.read({"velocity", "[x, y]"}, d.velocity, any_number("m/s"));
  r.read({"amplitude", "[x, y]"}, d.amplitude, any_number("m"));
  r.read({"angular_frequency", "of the oscillation"}, d.angular_frequency, from_zero("rad/s"));
  r.read({"phase", "of the oscillation"}, d.phase, any_number("rad"));
}

}  // namespace

void read_method(FieldReader& r, Method& m) {
  r.read_choice({"integrator", "how free motion is advanced"}, kIntegrators, m.integrator);
  r.read_choice({"impacts", "when impacts are resolved"}, kImpacts, m.impacts);
  r.read_choice({"contacts", "how lasting contacts are treated"}, kContacts, m.contacts);
  r.read({"step", "length of a step, or interval of the results"}, m.step, kStepRange);
  r.read({"tolerance", "of the adaptive integrator, a step"}, m.tolerance, kToleranceRange);
  r.keep({"integrator", "impacts", "contacts", "step"});
  if (choice_of(kIntegrators, m.integrator).adaptive) r.keep({"tolerance"});
}

void read_material(FieldReader& r, Material& m) {
  r.require({"name", "a name of its own"}, m.name, kName);
  read_surface(r, m);
}

void read_pair(FieldReader& r, MaterialPair& p) {
  r.needed({"materials", "the names of two materials, [\"a\", \"b\"]"}, [&](const ValueReader& names) {
    std::vector<std::string> two;
    names.list({2, 2}, [&](const ValueReader& name) { two.push_back(name.text(kName)); });
    p.a = two.front();
    p.b = two.back();
  });
  r.put("materials", Json::array({p.a, p.b}));
  read_surface(r, p.surface);
}

void read_body(FieldReader& r, Body& b) {
  r.require({"name", "a name of its own"}, b.name, kName);
  const bool moved = !r.writes() || !has_infinite_mass(b);
  if (r.writes()) r.put("shape", written(b.shape, false, read_shape));
  r.needed({"shape",
            "{\"type\": \"disc\", \"radius\": r}, {\"type\": \"box\", \"width\": w, \"height\": h}, {\"type\": "
            "\"polygon\", \"vertices\": [[x, y], ...]} or {\"type\": \"wall\"}"},
           [&](const ValueReader& v) { v.object([&](FieldReader& shape) { read_shape(shape, b.shape); }); });
  r.require({"position", "of the centre of mass, two numbers, [x, y]"}, b.position, any_number("m"));
  r.read({"angle", "counter-clockwise"}, b.angle, any_number("rad"));
  if (moved || !b.velocity.isZero(0.0)) r.read({"velocity", "[x, y]"}, b.velocity, any_number("m/s"));
  if (moved || b.spin != 0.0) r.read({"spin", "counter-clockwise"}, b.spin, any_number("rad/s"));
  r.read({"mass", "or a density"}, b.mass, positive("kg"));
  r.read({"density", "or a mass"}, b.density, positive("kg/m²"));
  if (r.writes_all() && moved && !b.mass && !b.density) r.put("density", 1.0);
  r.also({{"not", {{"required", {"mass", "density"}}}}});
  r.read({"inertia", "about the centre of mass"}, b.inertia, positive("kg m²"));
  r.read({"fixed", "it never moves"}, b.fixed);
  if (r.writes() && b.drive) r.put("drive", written(*b.drive, r.writes_all(), read_drive));
  r.member({"drive", "its prescribed motion"}, [&](const ValueReader& v) {
    v.object([&](FieldReader& drive) { read_drive(drive, b.drive.emplace()); });
  });
  r.read({"material", "the name of one"}, b.material, kName);
  r.read({"group", "bodies of one group do not collide with each other"}, b.group, kPerhapsName);
}

void read_generator(FieldReader& r, GridGenerator& g) {
  r.cases({"type", "the kind of generator"}, {"grid"}, 0, [&](std::size_t, FieldReader& k) {
    k.require({"name", "the stem of the bodies' names"}, g.name, kStem);
    k.read({"columns", "discs side by side"}, g.columns, Whole{1, kMostBodies});
    k.read({"rows", "discs one over the other"}, g.rows, Whole{1, kMostBodies});
    k.require({"origin", "the first disc's centre, two numbers, [x, y]"}, g.origin, any_number("m"));
    k.read({"spacing", "from disc to disc, [x, y]"}, g.spacing, any_number("m"));
    k.read({"jitter", "by which each disc is moved at most"}, g.jitter, from_zero("m"));
    k.put("radius", Vec2(g.radius_min, g.radius_max));
    k.needed({"radius", "two numbers, [least, largest]"}, [&](const ValueReader& v) {
      const Vec2 radius = v.pair(positive("m"));
      g.radius_min = radius.x();
      g.radius_max = radius.y();
    });
    k.read({"speed", "largest velocity component"}, g.speed_max, from_zero("m/s"));
    k.read({"density", "of each disc"}, g.density, positive("kg/m²"));
    k.read({"material", "the name of one"}, g.material, kName);
    k.read({"seed", "of the random numbers"}, g.seed, Whole{0.0, 9e15});
  });
}

void read_joint(FieldReader& r, Joint& joint) {
  r.read({"name", "its own, if any"}, joint.name, kPerhapsName);
  r.require({"body", "the name of a body that moves"}, joint.body, kName);
  r.read({"point", "of it, along its own axes, [x, y]"}, joint.point, any_number("m"));
  if (r.reads() && !r.has("to") && !r.has("anchor")) {
    refuse_value(r.at("anchor"), "a link without its other end",
                 "\"anchor\": [x, y], a point of the plane in m, or \"to\": the name of a body");
  }
  if (!r.writes() || !joint.to.empty()) r.read({"to", "the body at the other end"}, joint.to, kName);
  r.read({"anchor", "the point of that body, or of the plane, [x, y]"}, joint.anchor, any_number("m"));
  if (joint.to.empty()) r.keep({"anchor"});
  r.also({{"anyOf", {{{"required", Json::array({"to"})}}, {{"required", Json::array({"anchor"})}}}}});
  r.cases({"type", "the kind of link"}, words_of(kJointNames), index_of(kJointNames, joint.kind),
          [&](std::size_t kind, FieldReader& k) {
            joint.kind = kJointNames[kind].id;
            if (joint.kind == JointKind::kRod || joint.kind == JointKind::kString)
              k.read({"length", "the distance at the start, or more of a string"}, joint.length, positive("m"));
            if (joint.kind == JointKind::kWeld)
              k.read({"angle", "the body's angle less that of the other"}, joint.angle, any_number("rad"));
          });
}

Json joint_json(const Joint& joint, bool all) {
  return typed(name_of(kJointNames, joint.kind).data(), written(joint, all, read_joint));
}

void read_force(FieldReader& r, const std::string& at, int index, Forces& forces, ForcePlaces& places) {
  const auto one = [&](std::optional<int>& place, const char* what) {
    if (r.reads()) read_once(place, index, at, what);
  };
  r.cases({"type", "the kind of force"}, {"linear_drag", "quadratic_drag", "spring", "attraction", "force"}, 0,
          [&](std::size_t kind, FieldReader& k) {
            if (kind == 0) {
              one(places.linear_drag, "linear drag");
              k.require({"coefficient", "b in F = -b v"}, forces.linear_drag, from_zero("kg/s"));
            } else if (kind == 1) {
              one(places.quadratic_drag, "quadratic drag");
              k.require({"coefficient", "c in F = -c |v| v"}, forces.quadratic_drag, from_zero("kg/m"));
            } else if (kind == 2) {
              read_spring(k, forces.springs.emplace_back());
              places.springs.push_back(index);
            } else if (kind == 3) {
              one(places.attraction, "attraction");
              forces.attraction.emplace();
              k.require({"constant", "G"}, forces.attraction->constant, positive("N m²/kg²"));
              k.read({"softening", "of close encounters"}, forces.attraction->softening, from_zero("m"));
            } else {
              read_applied(k, forces.applied.emplace_back());
              places.applied.push_back(index);
            }
          });
}

Json forces_json(const Forces& forces, bool all) {
  Json j = Json::array();
  if (forces.linear_drag != 0.0) j.push_back({{"type", "linear_drag"}, {"coefficient", forces.linear_drag}});
  if (forces.quadratic_drag != 0.0)
    j.push_back({{"type", "quadratic_drag"}, {"coefficient", forces.quadratic_drag}});
  for (const Spring& s : forces.springs) j.push_back(typed("spring", written(s, all, read_spring)));
  if (forces.attraction) {
    const auto& [constant, softening] = *forces.attraction;
    j.push_back({{"type", "attraction"}, {"constant", constant}});
    if (all || softening != 0.0) j.back()["softening"] = softening;
  }
  for (const AppliedForce& f : forces.applied) j.push_back(typed("force", written(f, all, read_applied)));
  return j;
}

}  // namespace carom
