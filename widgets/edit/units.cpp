#include "widgets/edit/units.h"

#include <array>
#include <cmath>
#include <numbers>

#include "physics/scene/limits.h"
#include "widgets/base/method_names.h"
#include "widgets/base/number_text.h"
#include "widgets/base/rounding.h"

namespace carom {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;  // rad
constexpr double kTurn = 2.0 * std::numbers::pi;      // rad

// The first unit of each quantity is the one that fields show.
constexpr auto kUnits = std::to_array<Unit>({
    {"m", "m", 1.0},
    {"m", "mm", 1e-3},
    {"m", "cm", 1e-2},
    {"m", "km", 1e3},
    {"s", "s", 1.0},
    {"s", "ms", 1e-3},
    {"s", "min", 60.0},
    {"kg", "kg", 1.0},
    {"kg", "g", 1e-3},
    {"kg", "t", 1e3},
    {"m/s", "m/s", 1.0},
    {"m/s", "mm/s", 1e-3},
    {"m/s", "cm/s", 1e-2},
    {"m/s", "km/h", 1.0 / 3.6},
    {"m/s", "km/s", 1e3},
    {"m/s²", "m/s²", 1.0},
    {"m/s²", "m/s^2", 1.0},
    {"m/s²", "m/s2", 1.0},
    {"m/s²", "cm/s²", 1e-2},
    {"rad", "°", kDegree},
    {"rad", "deg", kDegree},
    {"rad", "rad", 1.0},
    {"rad", "rev", kTurn},
    {"rad/s", "rad/s", 1.0},
    {"rad/s", "rev/s", kTurn},
    {"rad/s", "rev/min", kTurn / 60.0},
    {"rad/s", "rpm", kTurn / 60.0},
    {"rad/s", "°/s", kDegree},
    {"rad/s", "deg/s", kDegree},
    {"rad/s", "Hz", kTurn},
    {"Hz", "Hz", 1.0},
    {"Hz", "1/s", 1.0},
    {"Hz", "rev/min", 1.0 / 60.0},
    {"Hz", "rpm", 1.0 / 60.0},
    {"N", "N", 1.0},
    {"N", "mN", 1e-3},
    {"N", "kN", 1e3},
    {"N m", "N m", 1.0},
    {"N m", "Nm", 1.0},
    {"N m", "N·m", 1.0},
    {"N m", "N cm", 1e-2},
    {"N/m", "N/m", 1.0},
    {"N/m", "N/cm", 1e2},
    {"N/m", "N/mm", 1e3},
    {"N/m", "kN/m", 1e3},
    {"N s/m", "N s/m", 1.0},
    {"N s/m", "Ns/m", 1.0},
    {"kg/m²", "kg/m²", 1.0},
    {"kg/m²", "kg/m^2", 1.0},
    {"kg/m²", "kg/m2", 1.0},
    {"kg/m²", "g/cm²", 10.0},
    {"kg/m²", "g/cm^2", 10.0},
    {"kg m²", "kg m²", 1.0},
    {"kg m²", "kg·m²", 1.0},
    {"kg m²", "kg m^2", 1.0},
    {"kg m²", "kg m2", 1.0},
    {"kg/s", "kg/s", 1.0},
    {"kg/s", "g/s", 1e-3},
    {"kg/m", "kg/m", 1.0},
    {"kg/m", "g/m", 1e-3},
    {"N m²/kg²", "N m²/kg²", 1.0},
});

Unit shown_unit(std::string_view si) { return units_of(si).front(); }

// With the name of the unit behind it.
QString with_unit(const QString& text, const Unit& unit) {
  if (unit.name.empty()) return text;
  const QString name = text_of(unit.name);
  return text + (name == "°" ? "" : " ") + name;
}

}  // namespace

std::vector<Unit> units_of(std::string_view si) {
  std::vector<Unit> units;
  for (const Unit& unit : kUnits) {
    if (unit.si == si) units.push_back(unit);
  }
  if (units.empty()) units.push_back({si, si, 1.0});
  return units;
}

QString field_text(double value, std::string_view si) {
  // A turn is the scale of every angle. Others have none of their own, but nothing that a scene states is as
  // small as this.
  constexpr double kSmall = 1e-3 * kLeastPositive;
  const double kept = si == "rad" ? without_rounding(value, kTurn) : std::abs(value) < kSmall ? 0.0 : value;
  const double shown = kept / shown_unit(si).factor;
  return shown == 0.0 ? QString("0") : short_figure(shown, 6);
}

QString quantity_text(double value, std::string_view si) {
  return with_unit(field_text(value, si), shown_unit(si));
}

QString change_text(double before, double after, std::string_view si) {
  const Unit unit = shown_unit(si);
  constexpr int kMostFigures = 15;
  int figures = 3;
  while (figures < kMostFigures && before != after &&
         figure(before / unit.factor, figures) == figure(after / unit.factor, figures))
    ++figures;
  return with_unit(figure(before / unit.factor, figures) + " → " + figure(after / unit.factor, figures), unit);
}

}  // namespace carom
