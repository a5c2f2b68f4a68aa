#pragma once

#include <string>
#include <vector>

#include "physics/scene/scene.h"
#include "widgets/edit/field_rows.h"
#include "widgets/edit/quantity.h"

// Values of a body or a force that follow from its members, and that people type all the same: speed, size,
// direction, the frequency of a drive.
namespace carom {

// Those that the body has, as field_rows() shows its members.
[[nodiscard]] std::vector<FieldRow> derived_rows(const Body& body);
[[nodiscard]] std::vector<FieldRow> derived_rows(const AppliedForce& force);
// Those and the members.
[[nodiscard]] std::vector<FieldRow> all_rows(const Body& body);

// Changes the members so that the value of this key follows; false if it is none of these.
bool set_derived(Body& body, const std::string& key, double value);
bool set_derived(AppliedForce& force, const std::string& key, double value);

// What formulas know of a body: m, r, x, y and v, as far as it has them.
[[nodiscard]] FormulaNames formula_names(const Body& body);

}  // namespace carom
