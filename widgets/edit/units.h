#pragma once

#include <QString>
#include <string_view>
#include <vector>

namespace carom {

// A unit in which people type a value.
struct Unit {
  std::string_view si;    // the SI unit of what it measures, as ranges state it; "" is dimensionless
  std::string_view name;  // UTF-8
  double factor = 1.0;    // SI units in one of it
};

// The units of what is measured in `si`, first the one in which fields show it: degrees for an angle, the SI
// unit for all else.
[[nodiscard]] std::vector<Unit> units_of(std::string_view si);

// A value, given in SI, as fields show it: in its shown unit, without the unit's name, with six figures at
// most; an angle that is rounding is 0.
[[nodiscard]] QString field_text(double value, std::string_view si);

// The same with the unit: "2.5 kg", "45°".
[[nodiscard]] QString quantity_text(double value, std::string_view si);

// "1.00 → 2.00 kg": with as many figures, three or more, as tell the two apart.
[[nodiscard]] QString change_text(double before, double after, std::string_view si);

}  // namespace carom
