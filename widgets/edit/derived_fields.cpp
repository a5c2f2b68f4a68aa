#include "widgets/edit/derived_fields.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "physics/math/vectors.h"

namespace carom {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;  // rad

bool moves(const Body& body) { return !has_infinite_mass(body); }
bool is_driven(const Body& body) { return body.drive.has_value(); }

// Of a body at rest: to the right.
double direction_of(const Body& body) {
  return body.velocity.isZero(0.0) ? 0.0 : std::atan2(body.velocity.y(), body.velocity.x());
}

void set_speed(Body& body, double speed) { body.velocity = speed * direction_at(direction_of(body)); }
void set_direction(Body& body, double angle) { body.velocity = body.velocity.norm() * direction_at(angle); }

struct Derived {
  std::string_view key;
  const char* meaning;
  Range range;
  bool (*is_there)(const Body&);
  double (*value)(const Body&);
  void (*set)(Body&, double);
};
constexpr auto kDerived = std::to_array<Derived>({
    {"speed", "at the start; of a body at rest, to the right", from_zero("m/s"), moves,
     [](const Body& body) { return body.velocity.norm(); }, set_speed},
    {"direction", "of the velocity, counter-clockwise from the right", any_number("rad"), moves, direction_of,
     set_direction},
    {"drive/frequency", "of the oscillation, ω over 2π", from_zero("Hz"), is_driven,
     [](const Body& body) { return body.drive->angular_frequency / kTurn; },
     [](Body& body, double hertz) { body.drive->angular_frequency = kTurn * hertz; }},
});

}  // namespace

std::vector<FieldRow> derived_rows(const Body& body) {
  std::vector<FieldRow> rows;
  for (const Derived& derived : kDerived) {
    if (derived.is_there(body))
      rows.push_back(
          field_row({std::string(derived.key)}, derived.meaning, derived.range, derived.value(body)));
  }
  return rows;
}

bool set_derived(Body& body, const std::string& key, double value) {
  for (const Derived& derived : kDerived) {
    if (derived.key != key) continue;
    derived.set(body, value);
    return true;
  }
  return false;
}

}  // namespace carom
