#pragma once

#include "widgets/edit/typed_field.h"

namespace carom {

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
