#pragma once

#include "widgets/edit/typed_field.h"

namespace carom {

// Why a body can't be called so, in one sentence; empty if it can.
[[nodiscard]] QString name_fault(const QString& name);

// A field for the name of one body.
class NameField : public TypedField {
  Q_OBJECT

 public:
  using TypedField::TypedField;

 signals:
  void named(const QString& name);

 protected:
  QString take(const QString& text) override;
};

}  // namespace carom
