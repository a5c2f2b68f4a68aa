#include "widgets/scene/join_shapes.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "widgets/scene/joined_velocities.h"
#include "widgets/scene/key_edits.h"

namespace carom {
namespace {

constexpr double kSame = 1e-9;  // of the size

QString text_of(const std::string& name) { return QString::fromStdString(name); }

// "A", "A and B", "A, B and C", "12 bodies".
QString names_of(std::span<const Body> bodies) {
  constexpr std::size_t kMostNamed = 3;
  if (bodies.size() > kMostNamed) return QStringLiteral("%1 bodies").arg(bodies.size());
  QStringList names;
  for (const Body& body : bodies) names << text_of(body.name);
  const QString last = names.takeLast();
  return names.empty() ? last : names.join(QStringLiteral(", ")) + QStringLiteral(" and ") + last;
}

// The shapes of a body as bodies of their own.
std::vector<Body> opened(const Body& body) {
  const auto* compound = std::get_if<Compound>(&body.shape);
  return compound == nullptr ? std::vector{body} : bodies_of(*compound, body);
}

PlainShape plain(const Shape& shape) {
  return std::visit(
      []<class Form>(const Form& form) -> PlainShape {
        if constexpr (std::is_same_v<Form, Compound>) {
          return {};  // a compound has been opened
        } else {
          return form;
        }
      },
      shape);
}

// All shapes, along the axes of the first body and about its place.
Compound shapes_of(std::span<const Body> bodies) {
  const Body& first = bodies.front();
  Compound compound;
  for (const Body& body : bodies) {
    for (const Body& part : opened(body)) {
      const Vec2 place = turned_by(-first.angle, part.position - first.position);
      const std::string material = part.material == first.material ? std::string() : part.material;
      compound.shapes.push_back({plain(part.shape), place, part.angle - first.angle, material});
    }
  }
  return compound;
}

Vec2 centre_of_mass(std::span<const Body> bodies) {
  Vec2 sum = Vec2::Zero();
  double mass = 0.0;
  for (const Body& body : bodies) {
    mass += mass_of(body);
    sum += mass_of(body) * body.position;
  }
  return sum / mass;
}

// m: where the shapes as one homogeneous body have their centre of mass.
Vec2 homogeneous_centre(std::span<const Body> bodies) {
  const Body& first = bodies.front();
  return first.position + turned_by(first.angle, centre_of(shapes_of(bodies)));
}

// That state a mass for another area, each of them homogeneous: the first two.
std::optional<std::pair<std::size_t, std::size_t>> of_two_densities(std::span<const Body> bodies) {
  const auto density = [](const Body& body) { return mass_of(body) / area(body.shape); };
  for (std::size_t k = 1; k < bodies.size(); ++k) {
    const double here = density(bodies[k]);
    const double first = density(bodies[0]);
    if (!(std::abs(here - first) <= kSame * first)) return std::pair(std::size_t{0}, k);
  }
  return std::nullopt;
}

// Whether the common centre of mass is that of a homogeneous body.
bool is_balanced(std::span<const Body> bodies) {
  const Vec2 centre = centre_of_mass(bodies);
  double size = 0.0;
  for (const Body& body : bodies)
    size = std::max(size, (body.position - centre).norm() + bounding_radius(body.shape));
  return (homogeneous_centre(bodies) - centre).norm() <= kSame * size;
}

// Why these can't be one body, in one sentence.
QString fault_of_kinds(std::span<const Body> bodies) {
  const Body& first = bodies.front();
  for (const Body& body : bodies) {
    if (is_half_plane(body.shape))
      return QStringLiteral("%1 is a half-plane, which has no centre of mass").arg(text_of(body.name));
  }
  for (const Body& body : bodies) {
    const QString both = text_of(first.name) + QStringLiteral(" and ") + text_of(body.name);
    if (first.fixed != body.fixed || first.drive.has_value() != body.drive.has_value())
      return both + QStringLiteral(" do not move alike: let both move, or fix both, first");
    if (first.drive != body.drive) return both + QStringLiteral(" are driven differently");
    if (first.group != body.group) return both + QStringLiteral(" are in different groups");
  }
  return {};
}

QString fault_of_masses(std::span<const Body> bodies) {
  if (has_infinite_mass(bodies.front()) || is_balanced(bodies)) return {};
  const bool thin =
      std::any_of(bodies.begin(), bodies.end(), [](const Body& b) { return area(b.shape) == 0.0; });
  if (thin)
    return names_of(bodies) + QStringLiteral(" can't share one density: what is thin or a point has no area");
  if (const auto two = of_two_densities(bodies)) {
    return QStringLiteral("%1 and %2 have different densities; give them one density first")
        .arg(text_of(bodies[two->first].name), text_of(bodies[two->second].name));
  }
  return names_of(bodies) + QStringLiteral(" have no common centre of mass as one plate");
}

std::vector<Body> named(const std::vector<Body>& bodies, std::span<const std::string> names) {
  std::vector<Body> found;
  for (const std::string& name : names) {
    const auto at = std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; });
    if (at != bodies.end()) found.push_back(*at);
  }
  return found;
}

// One end of a joint, spring or force: the body, the point in its frame, and by how much its angle becomes
// another one.
struct End {
  std::string& body;
  Vec2& point;
  double turn = 0.0;  // rad
};

// Puts an end that is on one of the bodies on the one that they become, at the same place.
void move_end(End& end, std::span<const Body> bodies, const Body& whole) {
  for (const Body& body : bodies) {
    if (body.name != end.body) continue;
    const Vec2 at = body.position + turned_by(body.angle, end.point);
    end.point = turned_by(-whole.angle, at - whole.position);
    end.turn = whole.angle - body.angle;
    end.body = whole.name;
    return;
  }
}

// Joints or springs; those between the bodies go.
template <class Link>
void move_links(const std::vector<Link>& links, std::span<const Body> bodies, const Body& whole,
                SceneEdits& edits) {
  for (const Link& link : links) {
    if (link.id.number == 0) continue;  // a run has made it
    Link moved = link;
    End own{moved.body, moved.point};
    End other{moved.to, moved.anchor};
    move_end(own, bodies, whole);
    move_end(other, bodies, whole);
    if (moved.body == moved.to) {
      edits.emplace_back(Remove<Link>{link.id});
      continue;
    }
    if constexpr (std::is_same_v<Link, Joint>) {
      if (moved.angle) *moved.angle += own.turn - other.turn;
    }
    if (moved.body == whole.name || moved.to == whole.name) edits.emplace_back(Replace<Link>{moved});
  }
}

void move_forces(const std::vector<AppliedForce>& forces, std::span<const Body> bodies, const Body& whole,
                 SceneEdits& edits) {
  for (const AppliedForce& force : forces) {
    AppliedForce moved = force;
    End end{moved.body, moved.point};
    move_end(end, bodies, whole);
    if (moved.body == whole.name) edits.emplace_back(Replace<AppliedForce>{moved});
  }
}

// What the joints forbid of the velocities after the edits goes as in a perfectly inelastic impact.
void let_joints_hold(const Scene& scene, SceneEdits& edits) {
  Scene now = scene;
  apply_edits(now, edits);
  std::vector<Body> bodies = now.bodies;
  hold_joined_velocities(now, bodies);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].velocity != now.bodies[k].velocity || bodies[k].spin != now.bodies[k].spin)
      edits.emplace_back(Replace<Body>{bodies[k]});
  }
}

}  // namespace

Body joined(std::span<const Body> bodies) {
  Body whole = bodies.front();
  Compound compound = shapes_of(bodies);
  const Vec2 centre = centre_of(compound);
  for (PlacedShape& placed : compound.shapes) placed.position -= centre;
  whole.position = homogeneous_centre(bodies);
  whole.shape = std::move(compound);
  whole.mass.reset();
  whole.density.reset();
  whole.inertia.reset();
  if (has_infinite_mass(whole)) return whole;
  double mass = 0.0;
  double inertia = 0.0;
  Vec2 momentum = Vec2::Zero();
  double turning = 0.0;  // kg m²/s, about the common centre
  for (const Body& body : bodies) {
    const double m = mass_of(body);
    const Vec2 arm = body.position - whole.position;
    mass += m;
    momentum += m * body.velocity;
    inertia += inertia_of(body) + m * arm.squaredNorm();
    turning += inertia_of(body) * body.spin + m * cross(arm, body.velocity);
  }
  whole.mass = mass;
  whole.velocity = momentum / mass;
  whole.spin = inertia > 0.0 ? turning / inertia : 0.0;
  if (std::abs(inertia_of(whole) - inertia) > kSame * inertia) whole.inertia = inertia;
  return whole;
}

std::vector<Body> taken_apart(const Body& body) {
  const auto* compound = std::get_if<Compound>(&body.shape);
  if (compound == nullptr) return {body};
  std::vector<Body> parts = bodies_of(*compound, body);
  const bool has_area = area(body.shape) > 0.0;
  const auto weight = [&](const Body& part) {
    return has_area ? area(part.shape) : bounding_radius(part.shape);
  };
  double sum = 0.0;
  for (const Body& part : parts) sum += weight(part);
  for (Body& part : parts) {
    if (body.drive) part.velocity = body.velocity;
    part.density = body.mass || has_infinite_mass(body) ? std::nullopt : body.density;
    if (body.mass) part.mass = *body.mass * weight(part) / sum;
  }
  return parts;
}

Regrouping joining(const Scene& scene, std::span<const std::string> names) {
  Regrouping out;
  const std::vector<Body> bodies = named(scene.bodies, names);
  if (bodies.size() < names.size()) {
    out.refusal = QStringLiteral("Bodies of a generator can't be joined");
  } else if (bodies.size() < 2) {
    out.refusal = QStringLiteral("Two bodies or more become one");
  } else {
    out.refusal = fault_of_kinds(bodies);
  }
  if (out.refusal.isEmpty()) out.refusal = fault_of_masses(bodies);
  if (!out.refusal.isEmpty()) return out;
  const Body whole = joined(bodies);
  if (std::get<Compound>(whole.shape).shapes.size() > kMostShapes) {
    out.refusal = QStringLiteral("One body has at most %1 shapes").arg(kMostShapes);
    return out;
  }
  out.edits.emplace_back(Replace<Body>{whole});
  move_links(scene.joints, bodies, whole, out.edits);
  move_links(scene.forces.springs, bodies, whole, out.edits);
  move_forces(scene.forces.applied, bodies, whole, out.edits);
  for (const Body& body : std::span(bodies).subspan(1)) out.edits.emplace_back(Remove<Body>{body.id});
  const bool held = std::any_of(out.edits.begin(), out.edits.end(), [](const SceneEdit& edit) {
    return std::holds_alternative<Replace<Joint>>(edit);
  });
  if (held) let_joints_hold(scene, out.edits);
  out.name = QStringLiteral("Join %1 into one body").arg(names_of(bodies));
  out.bodies = {whole.name};
  return out;
}

Regrouping taking_apart(const Scene& scene, std::span<const std::string> names) {
  Regrouping out;
  std::vector<Body> wholes = named(scene.bodies, names);
  const auto has_one = [](const Body& body) { return !std::holds_alternative<Compound>(body.shape); };
  for (const Body& body : wholes) {
    if (has_one(body)) out.bodies.push_back(body.name);
  }
  const std::size_t left = out.bodies.size();
  std::erase_if(wholes, has_one);
  if (wholes.empty()) {
    out.refusal = names.size() == 1
                      ? QStringLiteral("%1 has only one shape").arg(text_of(names[0]))
                      : QStringLiteral("Each of the %1 bodies has only one shape").arg(names.size());
    return out;
  }
  std::vector<Body> bodies = all_bodies(scene);
  std::vector<std::string> gone;
  for (const Body& whole : wholes) {
    gone.push_back(whole.name);
    for (Body& part : taken_apart(whole)) {
      part.name = free_body_name(bodies, whole.name);
      bodies.push_back(part);
      out.bodies.push_back(part.name);
      out.edits.emplace_back(Add<Body>{std::move(part)});
    }
  }
  const Deletion removed = deletion(scene, gone);
  out.edits.insert(out.edits.end(), removed.edits.begin(), removed.edits.end());
  out.name = QStringLiteral("Take %1 apart into %2 %3")
                 .arg(names_of(wholes))
                 .arg(out.bodies.size() - left)
                 .arg(out.bodies.size() - left == 1 ? QStringLiteral("body") : QStringLiteral("bodies"));
  if (!removed.links.isEmpty()) out.name += QStringLiteral(" and delete ") + removed.links;
  return out;
}

}  // namespace carom
