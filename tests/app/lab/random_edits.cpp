#include "tests/app/lab/random_edits.h"

#include <algorithm>
#include <optional>

namespace carom::test {
namespace {

constexpr std::size_t kEnoughBodies = 12;  // of the list, before bodies are removed instead of added
constexpr double kHalfWidth = 3.0;         // m, of the square in which bodies are put

}  // namespace

const std::vector<RandomEdits::Kind>& RandomEdits::kinds() {
  static const std::vector<Kind> table = {
      {"move", &RandomEdits::move},
      {"turn", &RandomEdits::turn},
      {"velocity", &RandomEdits::velocity},
      {"resize", &RandomEdits::resize},
      {"mass", &RandomEdits::mass},
      {"density", &RandomEdits::density},
      {"hold", &RandomEdits::hold},
      {"rename", &RandomEdits::rename},
      {"surface of body", &RandomEdits::surface_of_body},
      {"several", &RandomEdits::several},
      {"add body", &RandomEdits::add_body},
      {"add body", &RandomEdits::add_body},
      {"remove body", &RandomEdits::remove_body},
      {"add rod", &RandomEdits::add_rod},
      {"add string", &RandomEdits::add_string},
      {"add pin", &RandomEdits::add_pin},
      {"add weld", &RandomEdits::add_weld},
      {"joint value", &RandomEdits::joint_value},
      {"remove joint", &RandomEdits::remove_joint},
      {"add spring", &RandomEdits::add_spring},
      {"spring value", &RandomEdits::spring_value},
      {"remove spring", &RandomEdits::remove_spring},
      {"add force", &RandomEdits::add_force},
      {"force value", &RandomEdits::force_value},
      {"remove force", &RandomEdits::remove_force},
      {"add material", &RandomEdits::add_material},
      {"material value", &RandomEdits::material_value},
      {"rename material", &RandomEdits::rename_material},
      {"remove material", &RandomEdits::remove_material},
      {"add pair", &RandomEdits::add_pair},
      {"pair value", &RandomEdits::pair_value},
      {"remove pair", &RandomEdits::remove_pair},
      {"add generator", &RandomEdits::add_generator},
      {"generator value", &RandomEdits::generator_value},
      {"remove generator", &RandomEdits::remove_generator},
      {"forces", &RandomEdits::forces},
      {"laws", &RandomEdits::laws},
  };
  return table;
}

const std::vector<RandomEdits::Kind>& RandomEdits::kinds_of_no_part() {
  static const std::vector<Kind> table = {
      {"add body", &RandomEdits::add_body},
      {"add material", &RandomEdits::add_material},
      {"forces", &RandomEdits::forces},
      {"laws", &RandomEdits::laws},
  };
  return table;
}

SceneEdits RandomEdits::drawn(const std::vector<Kind>& kinds) {
  SceneEdits edits;
  while (edits.empty()) {
    const Kind& kind = kinds[random_() % kinds.size()];
    kind_ = kind.name;
    edits = (this->*kind.draw)();
  }
  return edits;
}

SceneEdits RandomEdits::any() { return drawn(kinds()); }
SceneEdits RandomEdits::of_no_part() { return drawn(kinds_of_no_part()); }

// --- what is drawn from
// -----------------------------------------------------------------------------------------------------------

double RandomEdits::between(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random_);
}

Vec2 RandomEdits::place() {
  const double x = between(-kHalfWidth, kHalfWidth);
  return {x, between(-kHalfWidth, kHalfWidth)};
}

template <class Part, class Change>
SceneEdits RandomEdits::changed(const std::vector<Part>& list, const Change& change) {
  const Part* was = one_of(list);
  if (was == nullptr) return {};
  Part part = *was;
  change(part);
  return {Replace<Part>{part}};
}

template <class Part>
SceneEdits RandomEdits::removed(const std::vector<Part>& list) {
  const Part* part = one_of(list);
  return part == nullptr ? SceneEdits() : SceneEdits{Remove<Part>{part->id}};
}

std::string RandomEdits::name(const char* stem) {
  const auto has = [](const auto& list, const std::string& name) {
    return std::any_of(list.begin(), list.end(), [&](const auto& part) { return part.name == name; });
  };
  for (int number = 1;; ++number) {
    std::string name = std::string(stem) + ' ' + std::to_string(number);
    if (!has(scene_.bodies, name) && !has(scene_.materials, name) && !has(scene_.joints, name) &&
        !has(scene_.forces.springs, name))
      return name;
  }
}

std::string RandomEdits::surface() {
  const Material* material = once_in(3) ? nullptr : one_of(scene_.materials);
  return material == nullptr ? Material{}.name : material->name;
}

Shape RandomEdits::shape() {
  switch (random_() % 5) {
    case 0: {
      const double width = between(0.1, 0.5);
      return Box{width, between(0.1, 0.5)};
    }
    case 2: {
      const double far = between(0.1, 0.4);
      return Compound{{{Box{2.0 * far, 0.1}, {0.0, 0.0}, 0.0, {}},
                       {Disc{between(0.05, 0.2)}, {far, 0.0}, 0.0, once_in(2) ? surface() : std::string()}}};
    }
    case 1:
      return Polygon{{{0.0, 0.0}, {between(0.1, 0.5), 0.0}, {0.0, between(0.1, 0.5)}}};
    default:
      return Disc{between(0.05, 0.3)};
  }
}

void RandomEdits::change(Material& material) {
  material.restitution = between(0.0, 1.0);
  material.kinetic_friction = once_in(2) ? between(0.0, 0.5) : 0.0;
  material.static_friction = material.kinetic_friction * between(1.0, 1.5);
  material.sticks = once_in(12);
}

// --- bodies
// -----------------------------------------------------------------------------------------------------------

SceneEdits RandomEdits::move() {
  return changed(scene_.bodies, [this](Body& body) { body.position = place(); });
}

SceneEdits RandomEdits::turn() {
  return changed(scene_.bodies, [this](Body& body) { body.angle = between(-3.0, 3.0); });
}

SceneEdits RandomEdits::velocity() {
  return changed(scene_.bodies, [this](Body& body) {
    if (has_infinite_mass(body)) return;
    body.velocity = 0.5 * place();
    body.spin = once_in(2) ? between(-5.0, 5.0) : 0.0;
  });
}

SceneEdits RandomEdits::resize() {
  return changed(scene_.bodies, [this](Body& body) { body.shape = shape(); });
}

SceneEdits RandomEdits::mass() {
  return changed(scene_.bodies, [this](Body& body) {
    body.mass = between(0.1, 10.0);
    body.density.reset();
  });
}

SceneEdits RandomEdits::density() {
  return changed(scene_.bodies, [this](Body& body) {
    body.density = between(0.1, 10.0);
    body.mass.reset();
  });
}

// Or lets it go.
SceneEdits RandomEdits::hold() {
  return changed(scene_.bodies, [this](Body& body) {
    const bool moved = !has_infinite_mass(body);
    body.fixed = moved && once_in(2);
    body.drive.reset();
    if (moved && !body.fixed) body.drive = Drive{{between(-0.5, 0.5), 0.0}, {0.0, 0.1}, between(1.0, 5.0), 0.0};
    body.mass.reset();
    body.density = body.drive ? std::nullopt : std::optional(1.0);
    body.velocity.setZero();
    body.spin = 0.0;
  });
}

SceneEdits RandomEdits::rename() {
  const Body* other = once_in(10) ? one_of(scene_.bodies) : nullptr;
  return changed(scene_.bodies, [&](Body& body) { body.name = other == nullptr ? name("body") : other->name; });
}

SceneEdits RandomEdits::surface_of_body() {
  return changed(scene_.bodies, [this](Body& body) {
    body.material = surface();
    body.group = once_in(4) ? "apart" : "";
  });
}

SceneEdits RandomEdits::several() {
  const Vec2 by = 0.2 * place();
  SceneEdits edits;
  for (const Body& body : scene_.bodies) {
    if (once_in(2)) continue;
    edits.emplace_back(Replace<Body>{body});
    std::get<Replace<Body>>(edits.back()).part.position += by;
  }
  return edits;
}

SceneEdits RandomEdits::add_body() {
  if (scene_.bodies.size() >= kEnoughBodies) return remove_body();
  Body body;
  body.name = name("body");
  body.shape = once_in(8) ? Shape(Wall{between(0.5, 2.0)}) : shape();
  body.fixed = std::holds_alternative<Wall>(body.shape);
  body.position = place();
  if (!body.fixed) {
    body.density = 1.0;
    if (once_in(2)) body.velocity = 0.5 * place();
  }
  body.material = surface();
  return {Add<Body>{body}};
}

SceneEdits RandomEdits::remove_body() { return removed(scene_.bodies); }

// --- joints, springs and forces
// -----------------------------------------------------------------------------------------------------------

// Between two bodies, or from one to the plane.
Joint RandomEdits::joint(JointKind kind) {
  Joint joint;
  joint.kind = kind;
  joint.name = once_in(3) ? "" : name("joint");
  const Body* body = one_of(scene_.bodies);
  const Body* to = once_in(2) ? nullptr : one_of(scene_.bodies);
  if (body == nullptr) return joint;
  joint.body = body->name;
  const bool apart = kind == JointKind::kRod || kind == JointKind::kString;
  const Vec2 own = to == nullptr ? Vec2(Vec2::Zero()) : to->position;
  joint.anchor = apart ? (to == nullptr ? place() : Vec2(Vec2::Zero())) : Vec2(body->position - own);
  if (to != nullptr) joint.to = to->name;
  return joint;
}

SceneEdits RandomEdits::add_rod() { return {Add<Joint>{joint(JointKind::kRod)}}; }
SceneEdits RandomEdits::add_string() { return {Add<Joint>{joint(JointKind::kString)}}; }
SceneEdits RandomEdits::add_pin() { return {Add<Joint>{joint(JointKind::kPin)}}; }
SceneEdits RandomEdits::add_weld() { return {Add<Joint>{joint(JointKind::kWeld)}}; }

SceneEdits RandomEdits::joint_value() {
  return changed(scene_.joints, [this](Joint& joint) {
    const bool apart = joint.kind == JointKind::kRod || joint.kind == JointKind::kString;
    joint.length = apart && once_in(2) ? std::optional(between(0.2, 6.0)) : std::nullopt;
    if (once_in(2)) joint.name = name("joint");
    if (once_in(3)) joint.point = 0.02 * place();
  });
}

SceneEdits RandomEdits::remove_joint() { return removed(scene_.joints); }

SceneEdits RandomEdits::add_spring() {
  const Joint ends = joint(JointKind::kRod);
  Spring spring;
  spring.name = ends.name;
  spring.body = ends.body;
  spring.to = ends.to;
  if (ends.to.empty()) spring.anchor = ends.anchor;
  spring.stiffness = between(1.0, 20.0);
  return {Add<Spring>{spring}};
}

SceneEdits RandomEdits::spring_value() {
  return changed(scene_.forces.springs, [this](Spring& spring) {
    spring.stiffness = between(1.0, 20.0);
    spring.damping = once_in(2) ? between(0.0, 1.0) : 0.0;
    spring.rest_length = between(0.0, 2.0);
    spring.acts = once_in(2) ? SpringActs::kBoth : SpringActs::kPull;
  });
}

SceneEdits RandomEdits::remove_spring() { return removed(scene_.forces.springs); }

SceneEdits RandomEdits::add_force() {
  const Body* body = one_of(scene_.bodies);
  if (body == nullptr) return {};
  AppliedForce force;
  force.body = body->name;
  force.force = place();
  force.end = once_in(2) ? std::optional(between(0.1, 1.0)) : std::nullopt;
  return {Add<AppliedForce>{force}};
}

SceneEdits RandomEdits::force_value() {
  return changed(scene_.forces.applied, [this](AppliedForce& force) {
    force.force = place();
    force.torque = once_in(2) ? between(-0.1, 0.1) : 0.0;
    force.rise = between(0.0, 0.1);
  });
}

SceneEdits RandomEdits::remove_force() { return removed(scene_.forces.applied); }

// --- surfaces
// -----------------------------------------------------------------------------------------------------------

SceneEdits RandomEdits::add_material() {
  if (scene_.materials.size() >= 6) return remove_material();
  Material material;
  material.name = name("surface");
  change(material);
  return {Add<Material>{material}};
}

SceneEdits RandomEdits::material_value() {
  return changed(scene_.materials, [this](Material& material) { change(material); });
}

SceneEdits RandomEdits::rename_material() {
  return changed(scene_.materials, [this](Material& material) { material.name = name("surface"); });
}

SceneEdits RandomEdits::remove_material() { return removed(scene_.materials); }

SceneEdits RandomEdits::add_pair() {
  MaterialPair pair;
  pair.a = surface();
  pair.b = surface();
  change(pair.surface);
  return {Add<MaterialPair>{pair}};
}

SceneEdits RandomEdits::pair_value() {
  return changed(scene_.pairs, [this](MaterialPair& pair) {
    change(pair.surface);
    if (once_in(3)) pair.b = surface();
  });
}

SceneEdits RandomEdits::remove_pair() { return removed(scene_.pairs); }

// --- the rest
// -----------------------------------------------------------------------------------------------------------

SceneEdits RandomEdits::add_generator() {
  if (!scene_.generators.empty()) return remove_generator();
  GridGenerator grid;
  grid.name = name("grid");
  grid.columns = 2;
  grid.rows = 1 + static_cast<int>(random_() % 2);
  grid.origin = place();
  grid.spacing = {0.4, 0.4};
  grid.material = surface();
  grid.seed = random_();
  return {Add<GridGenerator>{grid}};
}

SceneEdits RandomEdits::generator_value() {
  return changed(scene_.generators, [this](GridGenerator& grid) {
    grid.columns = 1 + static_cast<int>(random_() % 3);
    grid.radius_max = between(0.1, 0.2);
    grid.speed_max = between(0.0, 1.0);
  });
}

SceneEdits RandomEdits::remove_generator() { return removed(scene_.generators); }

SceneEdits RandomEdits::forces() {
  SetForces forces{.gravity = once_in(2) ? Vec2(0.0, -between(0.0, 10.0)) : Vec2(Vec2::Zero())};
  forces.linear_drag = once_in(2) ? between(0.0, 0.5) : 0.0;
  forces.quadratic_drag = once_in(4) ? between(0.0, 0.5) : 0.0;
  if (once_in(4)) forces.attraction = Attraction{between(0.1, 1.0), 0.1};
  return {forces};
}

SceneEdits RandomEdits::laws() {
  return {SetLaws{once_in(2) ? ImpactLawId::kNewton : ImpactLawId::kEnergetic,
                  once_in(4) ? SeveralImpactsId::kSimultaneous : SeveralImpactsId::kPairwise}};
}

}  // namespace carom::test
