#include "widgets/base/method_names.h"

#include <QCoreApplication>
#include <algorithm>

#include "physics/dynamics/integrators/integrators.h"
#include "widgets/base/number_text.h"

namespace carom {
namespace {

QString step_text(const Method& m) {
  if (choice_of(kIntegrators, m.integrator).adaptive) {
    return QCoreApplication::translate("MethodNames", "tolerance %1").arg(short_figure(m.tolerance));
  }
  return QString("%1 ms").arg(short_figure(1e3 * m.step));
}

template <class Member>
bool differ(const std::vector<Method>& methods, Member member) {
  return std::any_of(methods.begin(), methods.end(),
                     [&](const Method& m) { return m.*member != methods.front().*member; });
}

}  // namespace

std::vector<QString> names_of(const std::vector<Method>& methods) {
  std::vector<QString> names;
  for (const Method& m : methods) {
    const IntegratorChoice& integrator = choice_of(kIntegrators, m.integrator);
    QString name = text_of(integrator.label);
    // Exact flight has neither step nor tolerance.
    const bool exact = integrator.order == 0;
    if (differ(methods, &Method::impacts) && !exact)
      name += ", " + text_of(choice_of(kImpacts, m.impacts).name);
    if (differ(methods, &Method::contacts)) name += ", " + text_of(choice_of(kContacts, m.contacts).name);
    const bool same_integrator = std::count_if(methods.begin(), methods.end(), [&](const Method& other) {
                                   return other.integrator == m.integrator;
                                 }) > 1;
    const bool steps =
        differ(methods, &Method::step) || (same_integrator && differ(methods, &Method::tolerance));
    if (steps && !exact) name += ", " + step_text(m);
    names.push_back(name);
  }
  return names;
}

QString description_of(const Method& method) {
  return QString("%1, %2, %3, %4")
      .arg(text_of(choice_of(kIntegrators, method.integrator).label),
           text_of(choice_of(kImpacts, method.impacts).label),
           text_of(choice_of(kContacts, method.contacts).label), step_text(method));
}

}  // namespace carom
