#include "widgets/edit/name_field.h"

#include "physics/scene/fields.h"

namespace carom {

QString NameField::take(const QString& text) {
  const QString name = text.trimmed();
  if (name.isEmpty()) return tr("A body has a name.");
  if (static_cast<std::size_t>(name.toUcs4().size()) > kName.most)
    return tr("A name has up to %1 characters.").arg(kName.most);
  emit named(name);
  return {};
}

}  // namespace carom
