#include "physics/scene/fingerprint.h"

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace carom {
namespace {

using Word = std::string_view;

template <class T>
concept WholeOrEnum = std::integral<T> || std::is_enum_v<T>;

// The members that a type had when fingerprints were first written, in the order in which they are taken in. A
// member that came later is not named: it is taken in with its key, and only where it hasn't its default, so
// that runs saved before stay those of their scenes.
template <class T>
constexpr std::array<Word, 0> kFirst{};
template <>
constexpr auto kFirst<Material> = std::to_array<Word>({"name", "restitution", "tangential_restitution",
                                                       "static_friction", "kinetic_friction",
                                                       "rolling_resistance", "sticks"});
template <>
constexpr auto kFirst<MaterialPair> = std::to_array<Word>({"materials", "name", "restitution",
                                                           "tangential_restitution", "static_friction",
                                                           "kinetic_friction", "rolling_resistance", "sticks"});
template <>
constexpr auto kFirst<Drive> = std::to_array<Word>({"velocity", "amplitude", "angular_frequency", "phase"});
template <>
constexpr auto kFirst<Shape> = std::to_array<Word>({"type", "radius", "width", "height", "vertices", "rounding",
                                                    "length"});
template <>
constexpr auto kFirst<PlainShape> = kFirst<Shape>;
template <>
constexpr auto kFirst<PlacedShape> = std::to_array<Word>({"shape", "position", "angle", "material"});
template <>
constexpr auto kFirst<Body> = std::to_array<Word>({"shape", "name", "position", "angle", "velocity", "spin",
                                                   "mass", "density", "inertia", "fixed", "drive", "material",
                                                   "group"});
template <>
constexpr auto kFirst<Spring> = std::to_array<Word>({"name", "body", "to", "anchor", "stiffness", "damping",
                                                     "rest_length", "acts"});
template <>
constexpr auto kFirst<Joint> = std::to_array<Word>({"name", "type", "body", "point", "to", "anchor", "length",
                                                    "angle"});
template <>
constexpr auto kFirst<Attraction> = std::to_array<Word>({"constant", "softening"});
template <>
constexpr auto kFirst<AppliedForce> = std::to_array<Word>({"body", "force", "torque", "start", "rise", "end"});
template <>
constexpr auto kFirst<Forces> = std::to_array<Word>({"gravity", "linear_drag", "quadratic_drag", "springs",
                                                     "attraction", "applied"});

// Appends a value as bytes.
template <class T>
void append(std::string& bytes, const T& value);
template <WholeOrEnum T>
void append(std::string& bytes, const T& value) {
  const auto bits = static_cast<std::uint64_t>(value);
  for (int k = 0; k < 8; ++k) bytes.push_back(static_cast<char>(static_cast<unsigned char>(bits >> (8 * k))));
}
void append(std::string& bytes, double value) {
  append(bytes, std::bit_cast<std::uint64_t>(value + 0.0));  // -0 is 0 in a file
}
void append(std::string& bytes, std::string_view text) {
  append(bytes, text.size());
  bytes += text;
}
void append(std::string& bytes, const std::string& text) { append(bytes, std::string_view{text}); }
void append(std::string& bytes, const Vec2& v) {
  append(bytes, v.x());
  append(bytes, v.y());
}
template <class T>
void append(std::string& bytes, const std::optional<T>& value) {
  append(bytes, value.has_value());
  if (value) append(bytes, *value);
}
template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
  append(bytes, values.size());
  for (const T& value : values) append(bytes, value);
}

// The visitor of fields.h that keeps each member as bytes.
class Members : public OnlyLooks {
 public:
  void take(const char* key, const auto&... values) {
    if (find(key)) return;
    const std::size_t begin = bytes_.size();
    (append(bytes_, values), ...);
    places_.push_back({key, begin, bytes_.size() - begin});
  }
  [[nodiscard]] std::optional<std::string_view> find(std::string_view key) const {
    const auto found =
        std::find_if(places_.begin(), places_.end(), [key](const Place& p) { return p.key == key; });
    if (found == places_.end()) return std::nullopt;
    return std::string_view(bytes_).substr(found->begin, found->size);
  }
  [[nodiscard]] std::vector<Word> keys() const {
    std::vector<Word> keys;
    for (const Place& place : places_) keys.push_back(place.key);
    return keys;
  }
  [[nodiscard]] std::size_t size() const { return places_.size(); }

  void field(const Key& key, const auto& value, const auto& /*kind*/) { take(key.name, value); }
  void field(const Key& key, bool flag) { take(key.name, flag); }
  void required(const Key& key, const auto& value, const auto& /*kind*/) { take(key.name, value); }
  void choice(const Key& key, const auto& /*table*/, auto id) { take(key.name, id); }
  void object(const Key& key, const auto& value) { take(key.name, value); }
  void required_object(const Key& key, const auto& value) { take(key.name, value); }
  void alternative(const Key& key, const Shape& shape) {
    if (!std::holds_alternative<Compound>(shape)) take(key.name, shape);
  }
  void compound(const Key& /*key*/, const Shape& shape, const Count& /*count*/) {
    const auto* compound = std::get_if<Compound>(&shape);
    if (compound != nullptr) take("shape", shape.index(), compound->shapes);
  }
  void points(const Key& key, const auto& list, const Count& /*count*/, const Range& /*range*/) {
    take(key.name, list);
  }
  void two_names(const Key& key, const std::string& a, const std::string& b) { take(key.name, a, b); }
  void cases(const Key& key, const Words& /*words*/, std::size_t chosen, const auto& each) {
    take(key.name, chosen);
    each(chosen, *this);
  }
  [[nodiscard]] static bool shows(bool /*condition*/) { return true; }

 private:
  struct Place {
    Word key;
    std::size_t begin;
    std::size_t size;
  };
  std::string bytes_;
  std::vector<Place> places_;
};

template <class T>
void take_members(Members& members, const T& value) {
  fields(members, value);
}
void take_members(Members& members, const MaterialPair& pair) {
  fields(members, pair);
  members.take("name", pair.surface.name);
}
// Also what its kind doesn't use.
void take_members(Members& members, const Joint& joint) {
  fields(members, joint);
  members.take("length", joint.length);
  members.take("angle", joint.angle);
}
void take_members(Members& members, const Forces& forces) {
  members.take("gravity", forces.gravity);
  each_common_force(forces, [&members](const CommonForce& force, const auto& value, const auto&...) {
    members.take(force.type, value);
  });
  members.take("springs", forces.springs);
  members.take("applied", forces.applied);
}

// A value of the same kind whose members have their defaults.
template <class T>
T plain_like(const T& /*value*/) {
  return {};
}
template <class... Forms>
std::variant<Forms...> plain_like(const std::variant<Forms...>& value) {
  return std::visit([](const auto& form) -> std::variant<Forms...> { return std::decay_t<decltype(form)>{}; },
                    value);
}
Joint plain_like(const Joint& joint) {
  Joint plain;
  plain.kind = joint.kind;
  return plain;
}

template <class T>
void append(std::string& bytes, const T& value) {
  Members members;
  take_members(members, value);
  std::size_t first = 0;
  for (const Word key : kFirst<T>) {
    const auto member = members.find(key);
    if (!member) continue;
    bytes += *member;
    ++first;
  }
  if (first == members.size()) return;
  Members usual;
  take_members(usual, plain_like(value));
  for (const Word key : members.keys()) {
    const bool later = std::find(kFirst<T>.begin(), kFirst<T>.end(), key) == kFirst<T>.end();
    if (!later || members.find(key) == usual.find(key)) continue;
    append(bytes, key);
    bytes += *members.find(key);
  }
}

}  // namespace

std::uint64_t fingerprint(const Scene& scene, double start_time) {
  // All lists of a scene by name: a new one doesn't compile here until it is taken in, or said not to be.
  const auto& [forces, materials, pairs, impact_law, several_impacts, bodies, generators, joints, ids_given] =
      scene;
  std::string bytes;
  const auto add = [&bytes](const auto&... values) { (append(bytes, values), ...); };
  add(start_time, forces, materials, pairs, impact_law, several_impacts, all_bodies(scene), joints);
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  return hash != 0 ? hash : 1;
}

}  // namespace carom
