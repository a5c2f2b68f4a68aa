#include "widgets/edit/derived_fields.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "physics/math/vectors.h"

namespace carom {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;  // rad

bool moves(const Body& body) { return !has_infinite_mass(body); }
bool is_driven(const Body& body) { return body.drive.has_value(); }

// rad; of no vector: to the right.
double direction_of(const Vec2& vector) {
  return vector.isZero(0.0) ? 0.0 : std::atan2(vector.y(), vector.x());
}
double direction_of(const Body& body) { return direction_of(body.velocity); }

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

std::vector<FieldRow> derived_rows(const AppliedForce& force) {
  return {field_row({"size"}, "of the force", positive("N"), force.force.norm()),
          field_row({"direction"}, "of the force, counter-clockwise from the right", any_number("rad"),
                    direction_of(force.force))};
}

std::vector<FieldRow> all_rows(const Body& body) {
  std::vector<FieldRow> rows = field_rows(body);
  for (FieldRow& row : derived_rows(body)) rows.push_back(std::move(row));
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

bool set_derived(AppliedForce& force, const std::string& key, double value) {
  if (key == "size") {
    force.force = value * direction_at(direction_of(force.force));
  } else if (key == "direction") {
    force.force = force.force.norm() * direction_at(value);
  } else {
    return false;
  }
  return true;
}

FormulaNames formula_names(const Body& body) {
  FormulaNames names;
  if (!has_infinite_mass(body)) names.push_back({"m", mass_of(body)});
  if (const auto* disc = std::get_if<Disc>(&body.shape)) names.push_back({"r", disc->radius});
  names.push_back({"x", body.position.x()});
  names.push_back({"y", body.position.y()});
  if (!has_infinite_mass(body)) names.push_back({"v", body.velocity.norm()});
  return names;
}

}  // namespace carom
