#pragma once

#include <QWidget>
#include <vector>

#include "physics/observe/quantity_name.h"
#include "physics/scene/scene.h"

class QComboBox;

namespace carom {

// Chooses a quantity: what of all observables, and of which bodies. `none`, if it is given, is a first choice
// that stands for no quantity.
class QuantityPicker : public QWidget {
  Q_OBJECT

 public:
  explicit QuantityPicker(const std::vector<Body>& bodies, const QString& none = {}, QWidget* parent = nullptr);

  void set_quantity(const QuantityName& quantity);
  // Without an observable where there is none.
  [[nodiscard]] QuantityName quantity() const;

 signals:
  void changed();

 private:
  void show_bodies();

  QComboBox* observable_;
  QComboBox* first_;
  QComboBox* second_;
};

}  // namespace carom
