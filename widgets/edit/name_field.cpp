#include "widgets/edit/name_field.h"

#include "physics/scene/fields.h"

namespace carom {

QString name_fault(const QString& name, const QString& of) {
  if (name.isEmpty() && !of.isEmpty()) return NameField::tr("%1 has a name.").arg(of);
  if (static_cast<std::size_t>(name.toUcs4().size()) > kNameLength.most)
    return NameField::tr("A name has up to %1 characters.").arg(kNameLength.most);
  return {};
}

QString NameField::take(const QString& text) {
  const QString name = text.trimmed();
  QString fault = name_fault(name, of_);
  if (fault.isEmpty() && other_fault_) fault = other_fault_(name);
  if (fault.isEmpty()) emit named(name);
  return fault;
}

}  // namespace carom
