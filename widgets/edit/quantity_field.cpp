#include "widgets/edit/quantity_field.h"

#include <QKeyEvent>
#include <QPainter>
#include <QStyleOption>
#include <algorithm>
#include <cmath>
#include <set>

#include "widgets/base/method_names.h"
#include "widgets/base/number_text.h"
#include "widgets/base/plain_text.h"
#include "widgets/edit/quantity.h"
#include "widgets/edit/units.h"

namespace carom {
namespace {

constexpr int kInset = 8;          // px, from the border to text and unit
constexpr int kBurst = 1000;       // ms between steps that are one edit
constexpr double kDoubling = 100;  // px of a pull that doubles a value
constexpr double kPixels = 2;      // px of a pull for one step of any other

// SI units in the shown one.
double shown_factor(const Range& range) { return units_of(range.unit).front().factor; }
// The finest step of what may be 0, in the shown unit.
double least_step(const Range& range) { return range.unit == "rad" ? 1.0 : 0.01; }
bool is_positive(const Range& range) { return range.low > 0.0; }

double within(double value, const Range& range) {
  if (range.or_zero && value <= 0.0) return 0.0;
  return std::clamp(value, range.low, range.high);
}

// A whole multiple of `step`, as near as doubles have it.
double rounded_to(double value, double step) {
  return step < 1.0 ? std::round(value / step) / std::round(1.0 / step) : std::round(value / step) * step;
}

}  // namespace

double stepped(double value, const Range& range, int steps) {
  const double factor = shown_factor(range);
  const double shown = value / factor;
  double step = shown == 0.0 ? 0.0 : std::pow(10.0, std::floor(std::log10(std::abs(shown)) + 1e-9) - 1.0);
  if (!is_positive(range) || shown == 0.0) step = std::max(step, least_step(range));
  return within(rounded_to(shown + steps * step, step) * factor, range);
}

double pulled(double value, const Range& range, double pixels) {
  if (pixels == 0.0) return value;
  if (is_positive(range) && value > 0.0) {
    const double moved = value * std::pow(2.0, pixels / kDoubling);
    // With three figures, which are enough to aim at.
    const double place = std::pow(10.0, std::floor(std::log10(moved)) - 2.0);
    return within(rounded_to(moved, place), range);
  }
  const double factor = shown_factor(range);
  const double step = least_step(range);
  const double moved = value / factor + std::round(pixels / kPixels) * step;
  return within(rounded_to(moved, step / 100.0) * factor, range);
}

QuantityField::QuantityField(QWidget* parent) : TypedField(parent) {}

void QuantityField::show_value(const Inspected& value) {
  range_ = value.range;
  typed_range_ = value.typed_range.value_or(value.range);
  name_ = value.name;
  values_ = value.values;
  formula_names_ = value.formula_names;
  is_given_ = value.unset.isEmpty();
  may_be_empty_ = value.emptied.has_value();
  refusal_ = value.refusal;
  value_fault_ = value.fault;
  const Unit unit = units_of(range_.unit).front();
  const QString unit_name = text_of(unit.name);
  if (unit_ != unit_name) {
    unit_ = unit_name;
    update();
  }
  const QString whose = value.name + (value.subject.isEmpty() ? "" : tr(" of %1").arg(value.subject));
  const QString tip =
      plain_tip(whose + ": " + value.meaning + (unit_.isEmpty() ? "" : tr(", in %1").arg(unit_)));
  if (toolTip() != tip) setToolTip(tip);
  const QString spoken = whose + (unit_.isEmpty() ? "" : ", " + unit_);
  if (accessibleName() != spoken) setAccessibleName(spoken);
  const std::set<double> different(values_.begin(), values_.end());
  const QString hint = different.size() > 1 ? tr("%1 values").arg(different.size()) : value.unset;
  if (placeholderText() != hint) setPlaceholderText(hint);
  show_text(different.size() > 1 || !is_given_ ? QString() : field_text(values_.front(), range_.unit));
}

QString QuantityField::take(const QString& text) {
  if (may_be_empty_ && text.trimmed().isEmpty()) {
    emit emptied();
    return {};
  }
  if (!refusal_.isEmpty()) return refusal_;
  const TypedValues typed = typed_values(text, name_, typed_range_, values_, formula_names_);
  if (!typed.fault.isEmpty()) return typed.fault;
  QString fault = value_fault_ ? value_fault_(typed.values) : QString();
  if (!fault.isEmpty()) return fault;
  if (typed.values == values_ && is_given_) {
    restore();
    return {};
  }
  answer_.clear();
  emit changed(typed.values, false);
  return answer_;
}

QString QuantityField::early_fault(const QString& text) const {
  if (values_.empty()) return {};
  const FormulaNames names = formula_names_.empty() ? FormulaNames{} : formula_names_.front();
  const std::optional<ValueChange> change = typed_quantity(text, range_.unit, names).change;
  if (!change) return {};
  for (const double old : values_) {
    const double value = change->of(old);
    if (value > typed_range_.high || value < std::min(typed_range_.low, 0.0))
      return range_sentence(name_, value, typed_range_);
  }
  return {};
}

QString QuantityField::value_of(const QString& text) const {
  return value_of_typed(text, range_, values_, formula_names_);
}

QString QuantityField::fitted(const QString& text) const {
  constexpr int kMargin = 2;  // px, of a line edit beside its text
  constexpr int kMostDigits = 5;
  constexpr int kMattering = 3;  // digits that matter more than the unit
  if (text.isEmpty() || values_.empty()) return text;
  QStyleOptionFrame option;
  initStyleOption(&option);
  const int room =
      style()->subElementRect(QStyle::SE_LineEditContents, &option, this).width() - 2 * kMargin - 1;
  const double shown = values_.front() / shown_factor(range_);
  const auto shortened = [&](int least, int width) {
    QString shorter = text;
    for (int digits = kMostDigits; digits >= least && fontMetrics().horizontalAdvance(shorter) > width;
         --digits)
      shorter = short_figure(shown, digits);
    return shorter;
  };
  const QString beside_unit = shortened(kMattering, std::min(room, room_beside_unit()));
  return fontMetrics().horizontalAdvance(beside_unit) <= room_beside_unit() ? beside_unit : shortened(1, room);
}

int QuantityField::room_beside_unit() const {
  const QString after = unit_.isEmpty() ? QString() : "  " + unit_;
  return width() - 2 * kInset - fontMetrics().horizontalAdvance(after);
}

void QuantityField::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Up || key == Qt::Key_Down) {
    step((key == Qt::Key_Up ? 1 : -1) * (event->modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1));
  } else {
    TypedField::keyPressEvent(event);
  }
}

void QuantityField::step(int steps) {
  if (!accept_typed()) return;
  if (!last_step_.isValid() || last_step_.elapsed() > kBurst) emit burst_began(false);
  last_step_.start();
  std::vector<double> values = values_;
  for (double& value : values) value = stepped(value, range_, steps);
  set_in_burst(values);
}

void QuantityField::set_in_burst(const std::vector<double>& values) {
  if (values != values_) emit changed(values, true);
}

void QuantityField::begin_pull() {
  restore();
  pulled_from_ = values_;
  emit burst_began(true);
}

void QuantityField::pull(double pixels) {
  // The selection may have changed under the mouse.
  if (pulled_from_.size() != values_.size()) return;
  std::vector<double> values = pulled_from_;
  for (double& value : values) value = pulled(value, range_, pixels);
  set_in_burst(values);
}

void QuantityField::pull_to(double value) { set_in_burst(std::vector<double>(values_.size(), value)); }

void QuantityField::paintEvent(QPaintEvent* event) {
  TypedField::paintEvent(event);
  if (unit_.isEmpty()) return;
  const QString content = text().isEmpty() ? placeholderText() : text();
  if (fontMetrics().horizontalAdvance(content) > room_beside_unit()) return;  // the tooltip has it
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(rect().adjusted(kInset, 0, -kInset, 0), Qt::AlignRight | Qt::AlignVCenter, unit_);
}

}  // namespace carom
