#pragma once

#include <QString>
#include <optional>
#include <string_view>
#include <vector>

#include "physics/scene/limits.h"

namespace carom {

// What a typed text does to the value that was there, in SI units.
struct ValueChange {
  enum class Kind { kSet, kAdd, kMultiply, kDivide };
  Kind kind = Kind::kSet;
  double number = 0.0;

  [[nodiscard]] double of(double old) const;
};

// A text that was read: the change, or one sentence for people on why there is none.
struct TypedQuantity {
  std::optional<ValueChange> change;
  QString fault;
};

// A name that a formula knows beside g, pi and e, with its value in SI units.
struct FormulaName {
  const char* name;
  double value;
};
using FormulaNames = std::vector<FormulaName>;

// Reads what people type into a field whose SI unit is `si`: a number with . or , ("2,5"), perhaps with a unit
// ("30 cm", "45°", "90 km/h"), or a formula ("sqrt(2*g*0.8)") with the names g = 9.81, pi, e and those given. A
// number without a unit is in the unit that the field shows (see units_of). With *, / or + in front ("*2", "+10
// cm") it changes the old value; with - it is a negative number. The same in every locale; throws nothing.
[[nodiscard]] TypedQuantity typed_quantity(const QString& text, std::string_view si,
                                           const FormulaNames& names = {});

// The values that a text makes of the old ones, or one sentence on why it can't be taken.
struct TypedValues {
  std::vector<double> values;
  QString fault;
};

// All of them in the range, of a value that people know as `label`. `names`: those that a formula knows for
// each of the old values, or none.
[[nodiscard]] TypedValues typed_values(const QString& text, const QString& label, const Range& range,
                                       const std::vector<double>& old,
                                       const std::vector<FormulaNames>& names = {});

// "= 3.96 m/s": what a formula, a change or another unit makes of the values, with the unit that the field
// shows; of several that differ the least and the largest, "= 2 to 5 kg". Empty for a plain number, and for
// what can't be taken.
[[nodiscard]] QString value_of_typed(const QString& text, const Range& range, const std::vector<double>& old,
                                     const std::vector<FormulaNames>& names = {});

// One sentence that says what is allowed of `label`, for a value that the range does not contain: "e lies
// between 0 and 1."
[[nodiscard]] QString range_sentence(const QString& label, double value, const Range& range);

}  // namespace carom
