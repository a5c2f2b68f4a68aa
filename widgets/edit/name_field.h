#pragma once

#include "widgets/edit/typed_field.h"

namespace carom {

// Why `of`, "A body", can't be called so, in one sentence; empty if it can. With an empty `of` there need be no
// name.
[[nodiscard]] QString name_fault(const QString& name, const QString& of);

// A field for the name of one body, or of another part.
class NameField : public TypedField {
  Q_OBJECT

 public:
  using TypedField::TypedField;

  void set_of(const QString& of) { of_ = of; }

 signals:
  void named(const QString& name);

 protected:
  QString take(const QString& text) override;

 private:
  QString of_ = tr("A body");
};

}  // namespace carom
