#include "widgets/edit/quantity.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <exception>
#include <muParser.h>
#include <numbers>

#include "widgets/base/method_names.h"
#include "widgets/edit/units.h"

namespace carom {
namespace {

constexpr qsizetype kLongest = 200;  // characters
constexpr double kGravity = 9.81;    // m/s², the name g in formulas

// Signs that stand for others: true minus, times.
QString with_plain_signs(QString text) {
  return text.replace(QChar(0x2212), '-').replace(QChar(0x00D7), '*').trimmed();
}

// Whether a unit may follow this text: a number, a bracket, or a name and a space.
bool may_have_unit(const QString& before) {
  const QString number = before.trimmed();
  if (number.isEmpty()) return false;
  const QChar last = number.back();
  return last.isDigit() || last == '.' || last == ',' || last == ')' ||
         (last.isLetter() && before.back().isSpace());
}

// Takes the longest unit that the text ends with off it.
std::optional<Unit> take_unit(QString& text, std::string_view si) {
  std::optional<Unit> best;
  for (const Unit& unit : units_of(si)) {
    const QString name = text_of(unit.name);
    if (name.isEmpty() || !text.endsWith(name) || !may_have_unit(text.chopped(name.size()))) continue;
    if (!best || unit.name.size() > best->name.size()) best = unit;
  }
  if (best) text = text.chopped(text_of(best->name).size()).trimmed();
  return best;
}

// The word behind a number that is no unit of this field; empty if there is none.
QString foreign_unit(const QString& text) {
  static const QRegularExpression kTail(R"(^.*[\d.)]\s*((?![eE]\d)[^\s\d.()*+,-]*[\p{L}°%²][^\s()*+,-]*)$)");
  const QRegularExpressionMatch match = kTail.match(text);
  return match.hasMatch() && !match.captured(1).startsWith('/') ? match.captured(1) : QString();
}

QString unit_sentence(const QString& found, std::string_view si) {
  QStringList names;
  for (const Unit& unit : units_of(si)) names << text_of(unit.name);
  if (si.empty()) return QString("“%1” can't stand here: this is a plain number.").arg(found);
  return QString("“%1” is no unit of this; it takes %2.").arg(found, names.join(", "));
}

// A comma is a decimal sign, except between the arguments of a function of several.
QString with_decimal_points(QString text) {
  static const QRegularExpression kSeveral(R"((min|max|sum|avg|atan2)\s*$)");
  std::vector<bool> arguments;  // of each open bracket
  for (qsizetype i = 0; i < text.size(); ++i) {
    if (text[i] == '(') arguments.push_back(kSeveral.match(text.left(i)).hasMatch());
    if (text[i] == ')' && !arguments.empty()) arguments.pop_back();
    if (text[i] == ',' && (arguments.empty() || !arguments.back())) text[i] = '.';
  }
  return text;
}

// "g, pi, e and m"
QString known_names(const FormulaNames& names) {
  QStringList known{"g", "pi", "e"};
  for (const FormulaName& each : names) known << each.name;
  const QString last = known.takeLast();
  return known.join(", ") + " and " + last;
}

QString reason_of(const mu::Parser::exception_type& error, const FormulaNames& names) {
  switch (error.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN:
      return QString("“%1” is not known; formulas know %2.")
          .arg(QString::fromStdString(error.GetToken()).trimmed(), known_names(names));
    case mu::ecUNEXPECTED_EOF:
      return "The formula ends too soon.";
    case mu::ecMISSING_PARENS:
      return "A bracket is not closed.";
    default:
      return "This is no number and no formula.";
  }
}

// A number by itself that is larger than any that can be held, as 1e400.
bool is_too_large(const QString& text) {
  static const QRegularExpression kNumber(R"(^[+-]?[\d.]+([eE]\+?\d+)?$)");
  return kNumber.match(text).hasMatch() && std::isinf(text.toDouble());
}

struct Evaluated {
  double value = 0.0;
  QString fault;
};

Evaluated evaluated(const QString& formula, const FormulaNames& names) {
  if (is_too_large(formula)) return {formula.toDouble(), {}};
  try {
    mu::Parser parser;
    parser.ClearConst();
    parser.DefineConst("g", kGravity);
    parser.DefineConst("pi", std::numbers::pi);
    parser.DefineConst("e", std::numbers::e);
    for (const FormulaName& each : names) parser.DefineConst(each.name, each.value);
    parser.SetExpr(formula.toStdString());
    const double value = parser.Eval();
    if (parser.GetNumResults() != 1) return {0.0, "This is more than one number."};
    if (!std::isfinite(value)) return {0.0, "This formula has no value."};
    return {value, {}};
  } catch (const mu::Parser::exception_type& error) {
    return {0.0, reason_of(error, names)};
  } catch (const std::exception&) {
    return {0.0, "This is no number and no formula."};
  }
}

ValueChange::Kind take_operator(QString& text) {
  ValueChange::Kind kind = ValueChange::Kind::kSet;
  if (text.startsWith('*')) kind = ValueChange::Kind::kMultiply;
  if (text.startsWith('/')) kind = ValueChange::Kind::kDivide;
  if (text.startsWith('+')) kind = ValueChange::Kind::kAdd;
  if (kind != ValueChange::Kind::kSet) text = text.mid(1).trimmed();
  return kind;
}

}  // namespace

double ValueChange::of(double old) const {
  switch (kind) {
    case Kind::kAdd:
      return old + number;
    case Kind::kMultiply:
      return old * number;
    case Kind::kDivide:
      return old / number;
    case Kind::kSet:
      break;
  }
  return number;
}

TypedQuantity typed_quantity(const QString& typed, std::string_view si, const FormulaNames& names) {
  if (typed.size() > kLongest) return {{}, "This is too long."};
  QString text = with_plain_signs(typed);
  const ValueChange::Kind kind = take_operator(text);
  const bool factor = kind == ValueChange::Kind::kMultiply || kind == ValueChange::Kind::kDivide;
  const std::optional<Unit> unit = take_unit(text, si);
  if (text.isEmpty()) return {{}, "A number is missing."};
  if (factor && unit) return {{}, "A factor has no unit."};
  if (const QString foreign = foreign_unit(text); !foreign.isEmpty()) return {{}, unit_sentence(foreign, si)};
  const Evaluated result = evaluated(with_decimal_points(text), names);
  if (!result.fault.isEmpty()) return {{}, result.fault};
  if (kind == ValueChange::Kind::kDivide && result.value == 0.0) return {{}, "Nothing is divided by 0."};
  const double scale = factor ? 1.0 : unit.value_or(units_of(si).front()).factor;
  return {ValueChange{kind, result.value * scale}, {}};
}

TypedValues typed_values(const QString& text, const QString& label, const Range& range,
                         const std::vector<double>& old, const std::vector<FormulaNames>& names) {
  std::vector<double> values;
  TypedQuantity typed;
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (i == 0 || !names.empty())
      typed = typed_quantity(text, range.unit, names.empty() ? FormulaNames() : names[i]);
    if (!typed.change) return {{}, typed.fault};
    if (std::isinf(typed.change->number))
      return {{}, "This number is too large. " + range_sentence(label, typed.change->number, range)};
    values.push_back(typed.change->of(old[i]));
    if (!range.contains(values.back())) return {{}, range_sentence(label, values.back(), range)};
  }
  return {values, {}};
}

QString value_of_typed(const QString& text, const Range& range, const std::vector<double>& old,
                       const std::vector<FormulaNames>& names) {
  static const QRegularExpression kPlain(R"(^-?[\d.,]*([eE][+-]?\d*)?$)");
  QString number = with_plain_signs(text);
  const QString shown = text_of(units_of(range.unit).front().name);
  if (number.endsWith(shown)) number = number.chopped(shown.size()).trimmed();
  if (kPlain.match(number).hasMatch()) return {};
  const std::vector<double> values = typed_values(text, {}, range, old, names).values;
  if (values.empty()) return {};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const QString largest = quantity_text(*most, range.unit);
  return *least == *most ? "= " + largest : "= " + field_text(*least, range.unit) + " to " + largest;
}

QString range_sentence(const QString& label, double value, const Range& range) {
  const double low = range.or_zero ? 0.0 : range.low;
  if (range.low > -kLargestNumber && range.high < kLargestNumber)
    return QString("%1 lies between %2 and %3.")
        .arg(label, field_text(low, range.unit), quantity_text(range.high, range.unit));
  if (value > range.high) return QString("%1 is at most %2.").arg(label, quantity_text(range.high, range.unit));
  if (value <= 0.0 && range.low > 0.0 && !range.or_zero) return QString("%1 is more than 0.").arg(label);
  if (value < 0.0 && low == 0.0) return QString("%1 is 0 or more.").arg(label);
  return QString("%1 is at least %2.").arg(label, quantity_text(range.low, range.unit));
}

}  // namespace carom
