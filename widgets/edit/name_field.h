#pragma once

#include <functional>
#include <utility>

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
  // What else forbids a name, in one sentence; empty: nothing.
  void set_fault(std::function<QString(const QString&)> fault) { other_fault_ = std::move(fault); }

 signals:
  void named(const QString& name);

 protected:
  QString take(const QString& text) override;

 private:
  QString of_ = tr("A body");
  std::function<QString(const QString&)> other_fault_;
};

}  // namespace carom
