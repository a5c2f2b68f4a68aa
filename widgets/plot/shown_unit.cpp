#include "widgets/plot/shown_unit.h"

#include "widgets/base/method_names.h"
#include "widgets/edit/units.h"

namespace carom {
namespace {

QString written(std::string_view unit) {
  if (unit == "1") return {};
  return text_of(unit).replace(' ', QChar(0x00B7));
}

}  // namespace

QString ShownUnit::after(const QString& text) const {
  return name.isEmpty() || name == "°" ? text + name : text + ' ' + name;
}

QString ShownUnit::behind(const QString& label) const { return name.isEmpty() ? label : label + " / " + name; }

ShownUnit shown_unit(const Observable& observable) {
  const Unit unit = units_of(observable.unit).front();
  return {written(unit.name), unit.factor};
}

ShownUnit si_unit(const Observable& observable) { return {written(observable.unit), 1.0}; }

}  // namespace carom
