#include "physics/scene/fingerprint.h"

#include <bit>
#include <concepts>
#include <string_view>
#include <type_traits>

namespace carom {
namespace {

// Hashes values one after the other. A structured binding names all members of each type, so a new member
// that is forgotten here does not compile.
class Fingerprint {
 public:
  [[nodiscard]] std::uint64_t value() const { return hash_ != 0 ? hash_ : 1; }

  void add(double value) { add_bits(std::bit_cast<std::uint64_t>(value + 0.0)); }  // a file stores -0 as 0
  template <class Whole>
  requires std::integral<Whole> || std::is_enum_v<Whole>
  void add(Whole value) { add_bits(static_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    add_bits(text.size());
    for (const char c : text) add_byte(static_cast<unsigned char>(c));
  }
  void add(const std::string& text) { add(std::string_view(text)); }
  void add(const Vec2& v) {
    add(v.x());
    add(v.y());
  }
  template <class T>
  void add(const std::optional<T>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add_bits(values.size());
    for (const T& value : values) add(value);
  }
  void add(const Material& material) {
    const auto& [name, restitution, tangential_restitution, static_friction, kinetic_friction,
                 rolling_resistance, sticks] = material;
    add_all(name, restitution, tangential_restitution, static_friction, kinetic_friction, rolling_resistance,
            sticks);
  }
  void add(const MaterialPair& pair) {
    const auto& [a, b, surface] = pair;
    add_all(a, b, surface);
  }
  void add(const Drive& drive) {
    const auto& [velocity, amplitude, angular_frequency, phase] = drive;
    add_all(velocity, amplitude, angular_frequency, phase);
  }
  void add(const Disc& disc) {
    const auto& [radius] = disc;
    add(radius);
  }
  void add(const Box& box) {
    const auto& [width, height] = box;
    add_all(width, height);
  }
  void add(const Polygon& polygon) {
    const auto& [vertices, rounding] = polygon;
    add_all(vertices, rounding);
  }
  void add(const Wall& wall) {
    const auto& [length] = wall;
    add(length);
  }
  void add(const Body& body) {
    const auto& [name, shape, position, angle, velocity, spin, mass, density, inertia, fixed, drive, material,
                 group] = body;
    add(shape.index());
    std::visit([this](const auto& form) { add(form); }, shape);
    add_all(name, position, angle, velocity, spin, mass, density, inertia, fixed, drive, material, group);
  }
  void add(const Spring& spring) {
    const auto& [name, body, to, anchor, stiffness, damping, rest_length, acts] = spring;
    add_all(name, body, to, anchor, stiffness, damping, rest_length, acts);
  }
  void add(const Joint& joint) {
    const auto& [name, kind, body, point, to, anchor, length, angle] = joint;
    add_all(name, kind, body, point, to, anchor, length, angle);
  }
  void add(const Attraction& attraction) {
    const auto& [constant, softening] = attraction;
    add_all(constant, softening);
  }
  void add(const AppliedForce& force) {
    const auto& [body, newtons, torque, start, rise, end] = force;
    add_all(body, newtons, torque, start, rise, end);
  }
  void add(const Forces& forces) {
    const auto& [gravity, linear_drag, quadratic_drag, springs, attraction, applied] = forces;
    add_all(gravity, linear_drag, quadratic_drag, springs, attraction, applied);
  }
  template <class... Values>
  void add_all(const Values&... values) {
    (add(values), ...);
  }

 private:
  void add_byte(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001b3ULL; }
  void add_bits(std::uint64_t bits) {
    for (int k = 0; k < 8; ++k) add_byte(static_cast<unsigned char>(bits >> (8 * k)));
  }

  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

}  // namespace

std::uint64_t fingerprint(const Scene& scene, double start_time) {
  const auto& [forces, materials, pairs, impact_law, several_impacts, bodies, generators, joints] = scene;
  Fingerprint f;
  f.add_all(start_time, forces, materials, pairs, impact_law, several_impacts, all_bodies(scene), joints);
  return f.value();
}

}  // namespace carom
