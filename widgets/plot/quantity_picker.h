#pragma once

#include <QWidget>
#include <vector>

#include "physics/observe/quantity_name.h"
#include "physics/scene/scene.h"

class QComboBox;

namespace carom {

// Chooses a quantity: an observable and its bodies. `none`, if given, is the text of a first choice for no
// quantity.
class QuantityPicker : public QWidget {
  Q_OBJECT

 public:
  explicit QuantityPicker(const std::vector<Body>& bodies, const QString& none = {}, QWidget* parent = nullptr);

  void set_quantity(const QuantityName& quantity);
  // Has no observable if none is chosen.
  [[nodiscard]] QuantityName quantity() const;

 signals:
  void changed();

 private:
  void show_bodies();

  QComboBox* observable_;
  int chosen_ = 0;  // of its entries
  QComboBox* first_;
  QComboBox* second_;
};

}  // namespace carom
