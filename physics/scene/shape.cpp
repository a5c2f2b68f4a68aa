#include "physics/scene/shape.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

#include "physics/math/vectors.h"

namespace carom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

Vec2 turned(const Vec2& v) { return {-v.y(), v.x()}; }

// The outline alone where a shape is one part or a polygon, else its parts.
std::vector<ConvexPart> parts_of(const Shape& shape) {
  if (std::holds_alternative<Compound>(shape)) return convex_parts(shape);
  return {ConvexPart{outline_of(shape)}};
}

constexpr int kAround = 24;  // points of a hull about a round corner

void add_around(const Vec2& point, double rounding, std::vector<Vec2>& points) {
  if (rounding == 0.0) {
    points.push_back(point);
    return;
  }
  for (int k = 0; k < kAround; ++k)
    points.push_back(point + rounding * direction_at(2.0 * std::numbers::pi * k / kAround));
}

struct CompoundMoments {
  double area = 0.0;  // m²
  Vec2 centre = Vec2::Zero();
  double inertia_per_mass = 0.0;  // m²
};

// Where nothing has an area, as of thin rods of one mass a length.
CompoundMoments moments_of(const Compound& compound) {
  CompoundMoments all;
  double reach = 0.0;
  for (const PlacedShape& s : compound.shapes) {
    all.area += area(shape_of(s.shape));
    reach += bounding_radius(shape_of(s.shape));
  }
  // Rods weigh as they are long, and points alike.
  const auto weight = [&](const PlacedShape& s) {
    const Shape shape = shape_of(s.shape);
    return all.area > 0.0 ? area(shape) : reach > 0.0 ? bounding_radius(shape) : 1.0;
  };
  double sum = 0.0;
  for (const PlacedShape& s : compound.shapes) {
    sum += weight(s);
    all.centre += weight(s) * s.position;
  }
  if (!(sum > 0.0)) return all;  // no shapes
  all.centre /= sum;
  for (const PlacedShape& s : compound.shapes) {
    all.inertia_per_mass +=
        weight(s) / sum * (inertia_per_mass(shape_of(s.shape)) + (s.position - all.centre).squaredNorm());
  }
  return all;
}

}  // namespace

Shape shape_of(const PlainShape& shape) {
  return std::visit([](const auto& plain) -> Shape { return plain; }, shape);
}

Vec2 centre_of(const Compound& compound) { return moments_of(compound).centre; }

std::vector<ConvexPart> convex_parts(const Shape& shape) {
  if (const auto* compound = std::get_if<Compound>(&shape)) {
    const Vec2 centre = centre_of(*compound);
    std::vector<ConvexPart> all;
    for (std::size_t k = 0; k < compound->shapes.size(); ++k) {
      const auto& [plain, position, angle, material] = compound->shapes[k];
      for (ConvexPart part : convex_parts(shape_of(plain))) {
        for (Vec2& v : part.outline.vertices) v = turned_by(angle, v);
        part.position = position - centre + turned_by(angle, part.position);
        part.box = part.box && angle == 0.0;
        part.shape = static_cast<int>(k);
        all.push_back(std::move(part));
      }
    }
    return all;
  }
  std::vector<ConvexPart> parts(1);
  parts[0].outline = outline_of(shape);
  parts[0].box = std::holds_alternative<Box>(shape);
  if (!std::holds_alternative<Polygon>(shape)) return parts;
  const std::vector<std::vector<Vec2>> pieces = convex_pieces(parts[0].outline.vertices);
  if (pieces.size() == 1) return parts;
  parts.assign(pieces.size(), {});
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    parts[k].position = carom::moments_of(pieces[k], 0.0).centroid;
    for (const Vec2& v : pieces[k]) parts[k].outline.vertices.push_back(v - parts[k].position);
  }
  return parts;
}

Outline outline_of(const Shape& shape) {
  return std::visit(
      Overloaded{
          [](const Disc& d) {
            return Outline{{Vec2::Zero()}, d.radius, false};
          },
          [](const Box& b) {
            const Vec2 half(0.5 * b.width, 0.5 * b.height);
            return Outline{{-half, Vec2(half.x(), -half.y()), half, Vec2(-half.x(), half.y())}, 0.0, false};
          },
          [](const Polygon& p) {
            std::vector<Vec2> vertices = tidied(p.vertices);
            const Vec2 centroid = moments_of(vertices, p.rounding).centroid;
            for (Vec2& v : vertices) v -= centroid;
            return Outline{std::move(vertices), p.rounding, false};
          },
          [](const Wall& w) {
            if (!w.length) return Outline{{}, 0.0, true};
            return Outline{{Vec2(-0.5 * *w.length, 0.0), Vec2(0.5 * *w.length, 0.0)}, 0.0, false};
          },
          [](const Compound& c) {
            std::vector<Vec2> points;
            for (const ConvexPart& part : convex_parts(c)) {
              for (const Vec2& v : part.outline.vertices)
                add_around(part.position + v, part.outline.rounding, points);
            }
            return Outline{convex_hull(std::move(points)), 0.0, false};
          }},
      shape);
}

bool is_half_plane(const Shape& shape) {
  const auto* wall = std::get_if<Wall>(&shape);
  return wall != nullptr && !wall->length;
}

double area(const Shape& shape) {
  return std::visit(Overloaded{[](const Disc& d) { return std::numbers::pi * d.radius * d.radius; },
                               [](const Box& b) { return b.width * b.height; },
                               [](const Polygon& p) { return moments_of(tidied(p.vertices), p.rounding).area; },
                               [](const Wall& w) { return w.length ? 0.0 : kInfinity; },
                               [](const Compound& c) { return moments_of(c).area; }},
                    shape);
}

double bounding_radius(const Shape& shape) {
  if (const auto* disc = std::get_if<Disc>(&shape)) return disc->radius;
  double reach = 0.0;
  for (const auto& [outline, position, box, of] : parts_of(shape)) {
    if (outline.half_plane) return kInfinity;
    for (const Vec2& v : outline.vertices) reach = std::max(reach, (position + v).norm() + outline.rounding);
  }
  return reach;
}

double inertia_per_mass(const Shape& shape) {
  return std::visit(Overloaded{[](const Disc& d) { return 0.5 * d.radius * d.radius; },
                               [](const Box& b) { return (b.width * b.width + b.height * b.height) / 12.0; },
                               [](const Polygon& p) {
                                 const PlateMoments m = moments_of(tidied(p.vertices), p.rounding);
                                 return m.second_moment / m.area;
                               },
                               [](const Wall& w) { return w.length ? *w.length * *w.length / 12.0 : 0.0; },
                               [](const Compound& c) { return moments_of(c).inertia_per_mass; }},
                    shape);
}

Vec2 half_extent(const Shape& shape, double angle) {
  if (const auto* disc = std::get_if<Disc>(&shape)) return Vec2::Constant(disc->radius);
  Vec2 reach = Vec2::Zero();
  for (const auto& [outline, position, box, of] : parts_of(shape)) {
    if (outline.half_plane) return Vec2::Constant(kInfinity);
    for (const Vec2& v : outline.vertices)
      reach = reach.cwiseMax(turned_by(angle, position + v).cwiseAbs() + Vec2::Constant(outline.rounding));
  }
  return reach;
}

double signed_distance(const Outline& outline, const Vec2& point) {
  if (outline.half_plane) return point.y();
  double nearest = kInfinity;
  double outside = -kInfinity;  // largest distance beyond an edge, times its length; <= 0 inside
  const std::size_t count = outline.vertices.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2& a = outline.vertices[k];
    const Vec2 edge = outline.vertices[(k + 1) % count] - a;
    const double length2 = edge.squaredNorm();
    const double along = length2 > 0.0 ? std::clamp((point - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (point - a - along * edge).norm());
    if (length2 > 0.0) outside = std::max(outside, -(point - a).dot(turned(edge)));
  }
  const bool inside = count > 2 && outside <= 0.0;
  return (inside ? -nearest : nearest) - outline.rounding;
}

double signed_distance(const Shape& shape, const Vec2& point) {
  double nearest = kInfinity;
  for (const ConvexPart& part : convex_parts(shape))
    nearest = std::min(nearest, signed_distance(part.outline, point - part.position));
  return nearest;
}

std::optional<std::pair<double, double>> chord(const Outline& outline, const Vec2& from, const Vec2& along) {
  double low = kInfinity;
  double high = -kInfinity;
  const auto take = [&](double s) {
    low = std::min(low, s);
    high = std::max(high, s);
  };
  if (outline.half_plane) {
    if (along.y() == 0.0) {
      if (from.y() > 0.0) return std::nullopt;
      return std::pair(-kInfinity, kInfinity);
    }
    const double s = -from.y() / along.y();
    return along.y() > 0.0 ? std::pair(-kInfinity, s) : std::pair(s, kInfinity);
  }
  // The shape is the convex hull of the discs about its vertices and of its edges moved outwards. The first
  // and last intersections of the line with these are the ends of the chord.
  const std::size_t count = outline.vertices.size();
  const double r = outline.rounding;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec2& a = outline.vertices[k];
    const Vec2 d = a - from;
    const double aside = std::abs(turned(along).dot(d));
    if (aside <= r) {
      const double half = std::sqrt((r - aside) * (r + aside));
      take(along.dot(d) - half);
      take(along.dot(d) + half);
    }
    const Vec2 edge = outline.vertices[(k + 1) % count] - a;
    const double length = edge.norm();
    if (!(length > 0.0)) continue;
    const Vec2 out = -turned(edge) / length;
    const double approach = along.dot(out);
    if (approach == 0.0) continue;
    const double s = (d + r * out).dot(out) / approach;
    const double t = (from + s * along - a).dot(edge) / (length * length);
    if (t >= 0.0 && t <= 1.0) take(s);
  }
  if (!(low <= high)) return std::nullopt;
  return std::pair(low, high);
}

}  // namespace carom
